#!/bin/sh
# Which lines and branches of src and include the tests reach: coverage.sh BUILD. SUPPORT names the objects that tests
# share. FILES: a regular expression for the paths of the files to count; unit tests that use no symbol of their
# sources do not run.
#
# Every variant that compiles other code is built with clang's source coverage, and runs the unit tests, the golden
# hash and the scenes; the counts are added up. A branch is one outcome of one condition. What is not reached is
# listed, unless a comment on its line or the line above says why: '// not reached: REASON'. Such a comment is listed
# too if all beside it is reached. Exit status 1: the list is not empty. Not compiled here, and so not counted: the
# inline assembly for ARM.
. tests/build/count.sh
build=$1/coverage
programs=$1
files=${FILES:-.}
percent=${GJK_TEST_PERCENT:-10}
export GJK_TEST_PERCENT="$percent"

if ! have clang || ! have llvm-cov || ! have llvm-profdata; then
  echo 'skipped: coverage: needs clang llvm'
  exit 0
fi
if ! echo 'int main(void) { return 0; }' | clang -fprofile-instr-generate -x c - -o /dev/null 2>/dev/null; then
  echo 'skipped: coverage: needs libclang-rt-dev'
  exit 0
fi

# library FLAGS...: the variant's library; it counts atomically, since some tests have threads
library() {
  mkdir -p "$variant"
  for source in src/*/*.c; do
    clang -std=c99 -ffreestanding -fprofile-instr-generate -fprofile-update=atomic -fcoverage-mapping -Iinclude -Iport "$@" -c "$source" \
      -o "$variant/$(basename "$source" .c).o" || return 1
  done
}

# program NAME OBJECTS OR SOURCES...: linked with the variant's library
program() {
  name=$1
  shift
  clang -std=c99 -O1 -fprofile-instr-generate -Iinclude -I. -Iport -Itests/support "$@" "$variant"/*.o -lm -o "$variant/$name"
}

# run NAME: the program, its counts in the variant's folder
run() {
  LLVM_PROFILE_FILE=$variant/$1.profraw nice "$variant/$1" >"$variant/$1.log" 2>&1 ||
    { echo "$variant: $1 fails"; tail -n 3 "$variant/$1.log"; return 1; }
}

# The symbols of the sources to count.
wanted() {
  for source in src/*/*.c; do
    echo "$source"
  done | grep -E "$files" | while read -r source; do
    nm "$programs/host/$(basename "$source" .c).o"
  done | awk '$2 ~ /[TR]/ { print $3 }'
}

# calls TEST: does it use a symbol of those sources itself?
calls() {
  [ "$files" = . ] || nm "$programs/hosted/tests/check/unit/$1.o" | awk '$1 == "U" { print $2 }' | grep -qxF -f "$build/wanted"
}

# measure NAME FLAGS...: builds and runs a variant, and writes what llvm-cov has to say
measure() {
  variant=$build/$1
  shift
  rm -rf "$variant"
  library "$@" || return 1
  objects=
  for object in "$variant"/*.o; do
    objects="$objects -object $object"
  done
  case $variant in
    */ceiling)
      # shellcheck disable=SC2086
      for name in bounds plane motion casts parts; do
        program $name "$@" tests/check/limit/$name.c $SUPPORT && run $name || return 1
      done
      ;;
    *)
      program golden -DGOLDEN_RUN_PAIRS=GOLDEN_PAIRS tests/check/target/golden.c tests/check/target/golden_host.c \
        tests/check/target/plane_golden.c tests/check/target/motion_golden.c tests/check/target/plane_motion_golden.c tests/check/target/parts_golden.c tests/check/target/hull_golden.c \
        tests/check/target/scene_golden.c tests/check/target/concave_golden.c tests/support/scene/match.c port/hosted/gjk_hosted.c && run golden || return 1
      for test in tests/check/unit/test_*.c; do
        name=$(basename "$test" .c)
        calls "$name" || continue
        # shellcheck disable=SC2086
        program "$name" "$programs/hosted/tests/check/unit/$name.o" $SUPPORT && run "$name" || return 1
      done
      ;;
  esac
  llvm-profdata merge -o "$variant/counts" "$variant"/*.profraw || return 1
  # shellcheck disable=SC2086
  llvm-cov export -format=lcov -instr-profile "$variant/counts" $objects >"$variant/lines" &&
    llvm-cov export -format=text -skip-expansions -skip-functions -instr-profile "$variant/counts" $objects \
      >"$variant/branches"
}

mkdir -p "$build"
wanted >"$build/wanted"
# Two variants at a time.
measure default -O1 >"$build-default.log" 2>&1 &
first=$!
status=0
{ measure narrow -O1 -DGJK_NARROW_MULTIPLY=1 && measure plain -O1 -U__GNUC__; } || status=1
wait $first || { cat "$build-default.log"; status=1; }
measure wide -O1 '-DGJK_PORT_HEADER="hosted/gjk_port.h"' >"$build-wide.log" 2>&1 &
first=$!
{ measure small -Os && measure ceiling -O1 -DGJK_ITERATIONS_MAX=3 -DGJK_CAST_ITERATIONS_MAX=3 -DGJK_ADVANCE_ROUNDS_MAX=2 -DGJK2_ADVANCE_ROUNDS_MAX=2; } || status=1
wait $first || { cat "$build-wide.log"; status=1; }
[ $status = 0 ] || exit 1

# JSON to one branch a line: B FILE LINE COLUMN TRUE FALSE
for file in "$build"/*/branches; do
  tr '{' '\n' <"$file" | awk '
    match($0, /^"branches":\[.*\],"filename"/) {
      list = substr($0, 13, RLENGTH - 24)
      file = $0
      sub(/.*"filename":"/, "", file)
      sub(/".*/, "", file)
      count = split(list, branch, "],")
      for (i = 1; i <= count; i++) {
        gsub(/[][]/, "", branch[i])
        if (split(branch[i], field, ",") >= 6) {
          print "B", file, field[1], field[2], field[5], field[6]
        }
      }
    }'
done >"$build/branches"
awk -v root="$PWD/" -v only="$files" -f tests/build/coverage.awk "$build/branches" "$build"/*/lines
