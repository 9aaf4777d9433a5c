#!/bin/sh
# Do the tests notice small wrong changes of src? mutants.sh BUILD [MUTANTS [FILE...]]
# In SUPPORT: the objects that tests share.
#
# Each mutant of tests/mutate is compiled (its file alone, or what includes it) and put into a shared library under the
# tests, which run with few trials until one fails; an endless loop fails too. A mutant whose object code is that of
# the original in every variant of the build is none. What survives stands in the list at the end, unless
# tests/mutate/equivalent.txt argues that it changes no answer. MUTANTS: a seeded random sample of so many; 0: all.
# Exit status 1 when less than 95 % of the others are noticed.
. tests/build/count.sh
build=$1/mutants
sample=${2:-0}
programs=$1
# Undefined behaviour traps: the tests of the golden hash run with the sanitizer too.
compiler='gcc -std=c99 -Werror=incompatible-pointer-types -Werror=int-conversion -fPIC -fno-semantic-interposition
  -fsanitize=undefined -fsanitize-undefined-trap-on-error'
# Of processor time, for one test: others may be at work here.
SECONDS_EACH=8
SEED=1
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

# The tests, those first that notice most in least time; the others follow, but for those of the tests' own tools.
TESTS='golden test_status test_check test_pose_bits test_wide test_support test_rotation test_pose test_pose_status'
TESTS="$TESTS test_aabb test_custom test_certificates test_penetration"
TOOLS='test_case test_exact test_reference'

# compile VARIANT SOURCES FOLDER FILE: FILE.o from SOURCES, where the mutated file stands
compile() {
  # shellcheck disable=SC2046
  $compiler $(flags "$1") -I"$2" -Iinclude -MMD -c "$2/$4.c" -o "$3/$4.o"
}

link() {
  gcc -shared "$@"
}

# Tests do not depend on the variant: they are linked once, with the default library.
prepare() {
  rm -rf "$build"
  mkdir -p "$build/tests"
  cp -r src "$build/src"  # what the mutants are made of, whatever changes meanwhile
  gcc -std=c99 -O1 tests/mutate/mutate.c -o "$build/mutate" || return 1
  for variant in $VARIANTS; do
    mkdir -p "$build/$variant"
    for source in src/*.c; do
      compile "$variant" "$build/src" "$build/$variant" "$(basename "$source" .c)" 2>/dev/null || return 1
    done
  done
  link "$build"/default/*.o -o "$build/tests/libgjk.so"
  gcc -std=c99 -O1 -Iinclude tests/target/golden.c tests/target/golden_host.c -o "$build/tests/golden" \
    -L"$build/tests" -lgjk || return 1
  for test in tests/unit/test_*.c; do
    name=$(basename "$test" .c)
    # shellcheck disable=SC2086
    gcc "$programs/hosted/tests/unit/$name.o" $SUPPORT -o "$build/tests/$name" -L"$build/tests" -lgjk -lm || return 1
    case " $TESTS $TOOLS " in
      *" $name "*) ;;
      *) TESTS="$TESTS $name" ;;
    esac
  done
}

# run_tests FOLDER: with the library there; prints the test that fails
run_tests() {
  for test in $TESTS; do
    # shellcheck disable=SC3045 # dash and others have it
    if ! (ulimit -t $SECONDS_EACH && LD_LIBRARY_PATH=$1 exec "$build/tests/$test" >/dev/null 2>&1) 2>/dev/null; then
      echo "$test"
      return 1
    fi
  done
}

# judge FOLDER FILE: what becomes of the mutant in FOLDER/src: invalid, same, 'noticed TEST' or survived. Survivors of one
# variant meet the others where the file has code that differs between them.
judge() {
  verdict=same
  case $2 in
    *.c) units=$(basename "$2" .c) ;;
    *) units=$(grep -l "src/$(basename "$2")" "$build"/default/*.d | sed 's|.*/||; s|\.d$||') ;;
  esac
  for variant in $VARIANTS; do
    changed=
    for unit in $units; do
      compile "$variant" "$1/src" "$1" "$unit" 2>/dev/null || { echo invalid; return; }
      cmp -s "$1/$unit.o" "$build/$variant/$unit.o" || changed="$changed $unit"
    done
    [ -n "$changed" ] || continue
    objects=
    for object in "$build/$variant"/*.o; do
      unit=$(basename "$object" .o)
      case " $changed " in
        *" $unit "*) object=$1/$unit.o ;;
      esac
      objects="$objects $object"
    done
    # shellcheck disable=SC2086
    link $objects -o "$1/libgjk.so"
    test=$(run_tests "$1") || { echo "noticed $test"; return; }
    verdict=survived
    grep -qE '^#(if|el).*(GJK|__)|GJK_SMALL' "$2" || break
  done
  echo $verdict
}

# work NUMBER: judges every second mutant of the list
work() {
  folder=$build/worker$1
  mkdir -p "$folder"
  cp -r "$build/src" "$folder/src"
  awk -v first="$1" 'NR % 2 == first' "$build/list" | while IFS='	' read -r file number line change text; do
    (cd "$build" && ./mutate apply "$file" "$number") >"$folder/$file"
    printf '%s\t%s\t%s\t%s\t%s\n' "$(judge "$folder" "$file")" "$file" "$line" "$change" "$text"
    cp "$build/$file" "$folder/$file"
  done >"$build/results$1"
}

if ! have gcc; then
  echo 'skipped: mutants: needs gcc'
  exit 0
fi
export GJK_TEST_PERCENT=2
prepare || exit 1
if ! test=$(run_tests "$build/tests"); then
  echo "mutants: $test fails on the library as it is"
  exit 1
fi
shift
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- src/*.[ch]
for file in "$@"; do
  (cd "$build" && ./mutate list "$file")
done | awk -v sample="$sample" -v seed=$SEED '
  # A random sample keeps the order of the files.
  { line[NR] = $0 }
  END {
    srand(seed)
    left = sample > 0 && sample < NR ? sample : NR
    for (i = 1; i <= NR; i++) {
      if (rand() * (NR - i + 1) < left) {
        print line[i]
        left--
      }
    }
  }' >"$build/list"
echo "$(wc -l <"$build/list") mutants; $build/results0 and $build/results1 grow"
work 0 &
work 1
wait
awk -F '\t' -f tests/build/mutants.awk tests/mutate/equivalent.txt "$build/results0" "$build/results1"
