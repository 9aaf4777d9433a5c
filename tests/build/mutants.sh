#!/bin/sh
# Do the tests notice small wrong changes of src? mutants.sh BUILD [MUTANTS [SEED]]
# In SUPPORT: the objects that tests share.
#
# Each mutant of tests/check/mutate is compiled (its file alone, or what includes it) and put into a shared library
# under the tests. These run with few trials until one fails; an endless loop fails too. Only tests that link the file
# run, those first that have noticed most mutants of it. A mutant is dropped if its object code is that of the original
# in every variant of the build. Survivors are listed at the end, unless tests/check/mutate/equivalent.txt shows that
# they change no answer, or only speed.
# MUTANTS: a random sample of so many, 0: all. With the same SEED a larger sample contains a smaller one. FILES: a
# regular expression for the names of files. Verdicts are kept in BUILD/mutants/results, so that a run goes on where it
# was interrupted, and a run with another seed adds to them. A verdict holds while the code of its file is the same;
# that of a survivor, while the tests are the same, too.
# Exit status 1: fewer than 95 % are noticed, or an argument is wrong.
. tests/build/count.sh
build=$1/mutants
sample=${2:-0}
seed=${3:-1}
programs=$1
percent=1
results=$build/results
# Undefined behaviour traps: the tests of the golden hash run with the sanitizer too. So does a write beyond a local array, mostly.
compiler='gcc -std=c99 -Werror=incompatible-pointer-types -Werror=int-conversion -fPIC -fno-semantic-interposition
  -fsanitize=undefined -fsanitize-undefined-trap-on-error -fstack-protector-all'
VARIANTS='default narrow small wide plain'

flags() {
  case $1 in
    default) echo -O1 ;;
    narrow) echo -O1 -DGJK_NARROW_MULTIPLY=1 ;;
    small) echo -Os ;;
    wide) echo -O1 -DGJK_INT128=1 -DGJK_INT128_TYPE=__int128 ;;
    plain) echo -O1 -U__GNUC__ ;;
  esac
}

# Tests of the tests' own tools.
TOOLS='test_case test_exact test_reference test_reference_depth'

# compile VARIANT TOP FOLDER FILE: FILE.o from TOP/src, where the mutated file stands
compile() {
  # shellcheck disable=SC2046
  $compiler $(flags "$1") -Iinclude -MMD -c "$2"/src/*/"$4.c" -o "$3/$4.o"
}

# program NAME OBJECTS OR SOURCES...: linked with the shared library; into NAME.units the objects of the library that it needs
program() {
  name=$1
  shift
  gcc -std=c99 -O1 -Iinclude -I. -Itests/support "$@" "$build/tests/support.a" -L"$build/tests" -lgjk -lm -o "$build/tests/$name" &&
    gcc -std=c99 -O1 -Iinclude -I. -Itests/support "$@" "$build/tests/support.a" "$build/tests/library.a" -lm \
      -Wl,-Map,"$build/tests/map" -o "$build/tests/static" || return 1
  sed -n 's|^[^ ]*library\.a(\(.*\)\.o)$|\1|p; /^Discarded/q' "$build/tests/map" | sort -u >"$build/tests/$name.units"
  [ -s "$build/tests/$name.units" ] || rm "$build/tests/$name" "$build/tests/$name.units"
}

# Processor time of the test on the library as it is, in hundredths of a second, into NAME.time.
measure() {
  (LD_LIBRARY_PATH=$build/tests "$build/tests/$1" >/dev/null 2>&1 || echo fails; times) | awk '
    /fails/ { failed = 1 }
    { line = $0 }
    END {
      split(line, field, /[ms ]+/)
      print int(100 * (60 * field[1] + field[2]))
      exit failed
    }' >"$build/tests/$1.time"
}

# What the mutants are made of, whatever changes meanwhile, and its objects, unless they are there already.
prepare_library() {
  if [ -e "$build/complete" ] && diff -r src "$build/src" >/dev/null && diff -r include "$build/include" >/dev/null; then
    return
  fi
  rm -rf "$build/src" "$build/include" "$build/complete"
  cp -r src "$build/src"
  cp -r include "$build/include"
  for variant in $VARIANTS; do
    mkdir -p "$build/$variant"
    rm -f "$build/$variant"/*
    for source in src/*/*.c; do
      compile "$variant" "$build" "$build/$variant" "$(basename "$source" .c)" 2>/dev/null || return 1
    done
  done
  touch "$build/complete"
}

# Tests do not depend on the variant: they are linked once, with the default library. Quick ones come first.
prepare_tests() {
  rm -rf "$build/tests"
  mkdir -p "$build/tests"
  # shellcheck disable=SC2086
  gcc -shared "$build"/default/*.o -o "$build/tests/libgjk.so" && ar rcs "$build/tests/library.a" "$build"/default/*.o &&
    ar rcs "$build/tests/support.a" $SUPPORT || return 1
  for many in '' many_; do
    # shellcheck disable=SC2086
    program ${many}golden ${many:+-DGOLDEN_MANY} tests/support/scene/match.c tests/check/target/golden.c \
      tests/check/target/plane_golden.c tests/check/target/motion_golden.c tests/check/target/plane_motion_golden.c \
      tests/check/target/parts_golden.c tests/check/target/hull_golden.c tests/check/target/scene_golden.c \
      tests/check/target/concave_golden.c tests/check/target/golden_host.c || return 1
  done
  program scene_golden tests/support/scene/match.c tests/check/target/scene_golden.c tests/check/target/scene_golden_host.c || return 1
  program ground_golden tests/check/target/ground_golden.c tests/check/target/ground_golden_host.c || return 1
  for test in tests/check/unit/test_*.c; do
    name=$(basename "$test" .c)
    case " $TOOLS " in
      *" $name "*) ;;
      *) program "$name" "$programs/hosted/tests/check/unit/$name.o" || return 1 ;;
    esac
  done
  awk '{ test = FILENAME; gsub(/.*\/|\.units$/, "", test); print test "\t" $0 }' "$build"/tests/*.units >"$build/tests/links"
  sum=$(cat "$build"/tests/*golden "$build"/tests/test_*[a-z] | cksum | tr ' ' '-')
  for units in "$build"/tests/*.units; do
    test=$(basename "$units" .units)
    measure "$test" || { echo "mutants: $test fails on the library as it is"; return 1; }
  done
  TESTS=$(for time in "$build"/tests/*.time; do
    echo "$(cat "$time") $(basename "$time" .time)"
  done | sort -n | sed 's/.* //')
}

# order FILE UNITS...: the tests to run, those first that noticed the most mutants of the file
order() {
  file=$1
  shift
  echo "$TESTS" | awk -F '\t' -v file="$file" -v units="$*" '
    BEGIN { n = split(units, unit, " "); for (i = 1; i <= n; i++) wanted[unit[i]] }
    FILENAME == ARGV[1] { if ($3 == file && sub(/^noticed /, "", $2)) noticed[$2]++; next }
    FILENAME == ARGV[2] { if ($2 in wanted) links[$1]; next }
    $1 in links { print noticed[$1] + 0, FNR, $1 }' "$results" "$build/tests/links" - | sort -k 1,1rn -k 2,2n | sed 's/.* //'
}

# run_tests FOLDER TEST...: with the library there; prints the test that fails
run_tests() {
  library=$1
  shift
  for test in "$@"; do
    # Others may be at work here, and a wrong answer may take longer than a right one.
    limit=$(($(cat "$build/tests/$test.time") / 30 + 2))
    # shellcheck disable=SC3045 # dash and others have it
    if ! (ulimit -t $limit && LD_LIBRARY_PATH=$library exec "$build/tests/$test" >/dev/null 2>&1) 2>/dev/null; then
      echo "$test"
      return 1
    fi
  done
}

# judge FOLDER FILE: what becomes of the mutant in FOLDER/src: invalid, same, 'noticed TEST' or survived. Other variants than
# the default only where the file has code that differs between them.
judge() {
  verdict=same
  case $2 in
    *.c) units=$(basename "$2" .c) ;;
    *) units=$(grep -l "/$(basename "$2")" "$build"/default/*.d | sed 's|.*/||; s|\.d$||') ;;
  esac
  # shellcheck disable=SC2086
  tests=$(order "$2" $units)
  for variant in $VARIANTS; do
    changed=
    for unit in $units; do
      compile "$variant" "$1" "$1" "$unit" 2>/dev/null || { echo invalid; return; }
      cmp -s "$1/$unit.o" "$build/$variant/$unit.o" || changed="$changed $unit"
    done
    if [ -n "$changed" ]; then
      objects=
      for object in "$build/$variant"/*.o; do
        unit=${object##*/}
        unit=${unit%.o}
        case " $changed " in
          *" $unit "*) object=$1/$unit.o ;;
        esac
        objects="$objects $object"
      done
      # shellcheck disable=SC2086
      gcc -shared $objects -o "$1/libgjk.so"
      # shellcheck disable=SC2086
      test=$(run_tests "$1" $tests) || { echo "noticed $test"; return; }
      verdict=survived
    fi
    grep -qE '^#(if|el).*(GJK_[^S]|GJK_SMALL|__)|GJK_SMALL' "$2" || break
  done
  echo $verdict
}

# work NUMBER: judges the mutants of the list that the other one has not taken
work() {
  folder=$build/worker$1
  rm -rf "$folder"
  mkdir -p "$folder"
  cp -r "$build/src" "$folder/src"
  while IFS='	' read -r file number line change text; do
    mkdir "$build/taken/$(basename "$file")-$number" 2>/dev/null || continue
    (cd "$build" && ./mutate apply "$file" "$number") >"$folder/$file"
    verdict=$(judge "$folder" "$file")
    key=$(awk -v file="$file" '$1 == file { print $2 }' "$build/codes")
    case $verdict in
      survived) key=$key-$sum ;;
    esac
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$key" "$verdict" "$file" "$number" "$line" "$change" "$text" >>"$results"
    cp "$build/$file" "$folder/$file"
  done <"$build/left"
}

if ! have gcc; then
  echo 'skipped: mutants: needs gcc'
  exit 0
fi
export GJK_TEST_PERCENT=$percent
mkdir -p "$build"
gcc -std=c99 -O1 tests/check/mutate/mutate.c -o "$build/mutate" && prepare_library && prepare_tests || exit 1

# What a file's verdicts hold for: its object code in all variants; of a header what there is to change.
code_of() {
  case $1 in
    *.c) cat "$build"/*/"$(basename "$1" .c).o" ;;
    *) (cd "$build" && ./mutate list "$1") | cut -f 4- ;;
  esac | cksum | tr ' ' '-'
}

# All mutants; the sample in random order, so that what an interrupted run has done is a sample too.
rm -rf "$build"/worker*
for file in src/*/*.[ch]; do
  (cd "$build" && ./mutate list "$file")
  echo "$file $(code_of "$file")" >&3
done >"$build/all" 3>"$build/codes"
[ "$sample" -gt 0 ] || sample=$(wc -l <"$build/all")
awk -F '\t' -v seed="$seed" -v files="${FILES:-.}" '
  # The minimal standard generator: the same numbers from every awk; for each file anew, whatever the others are.
  function next_random() { x = x * 16807 % 2147483647 }
  BEGIN { letters = "abcdefghijklmnopqrstuvwxyz_./" }
  $1 != file {
    file = $1
    x = seed
    for (i = 1; i <= length(file); i++) { x = (x + index(letters, substr(file, i, 1))) % 2147483646 + 1; next_random() }
    for (i = 0; i < 10; i++) next_random()
  }
  { next_random() }
  $1 ~ files { printf "%d\t%s\n", x, $0 }' "$build/all" | sort -n | head -n "$sample" | cut -f 2- >"$build/list"

# Verdicts that hold no longer are found anew, so that the sample stays one; what has none is left to do.
touch "$results"
awk -F '\t' -v tests="$sum" -v old="$build/old" '
  FILENAME == ARGV[1] { split($0, field, " "); code[field[1]] = field[2]; next }
  $1 == code[$3] || $1 == code[$3] "-" tests { print; next }
  { printf "%s\t%s\t%s\t%s\n", $3, $4, $6, $7 >old }' "$build/codes" "$results" >"$build/kept"
mv "$build/kept" "$results"
touch "$build/old"
awk -F '\t' '
  FILENAME == ARGV[1] { done[$3, $4]; next }
  FILENAME == ARGV[2] { again[$1, $2, $3, $4]; next }
  FILENAME == ARGV[3] && !(($1, $2, $4, $5) in again) { next }
  !(($1, $2) in done) { done[$1, $2]; print }' "$results" "$build/old" "$build/all" "$build/list" |
  # Those argued not to be noticed, which take longest, come last.
  awk -F '\t' '
    FILENAME == ARGV[1] { if ($0 !~ /^#/) { n++; file[n] = $1; text[n] = $2; change[n] = $3 } next }
    {
      for (i = 1; i <= n && (file[i] != $1 || change[i] != $4 || index($5, text[i]) == 0); i++) { }
      if (i <= n) last[++count] = $0
      else print
    }
    END { for (i = 1; i <= count; i++) print last[i] }' tests/check/mutate/equivalent.txt - >"$build/left"
rm "$build/old"
rm -rf "$build/taken"
mkdir "$build/taken"
echo "$sample of $(wc -l <"$build/all") mutants, seed $seed; $(wc -l <"$build/left") left to judge; $results grows"
work 0 &
work 1
wait
awk -F '\t' -f tests/build/mutants.awk tests/check/mutate/equivalent.txt "$build/all" "$results"
