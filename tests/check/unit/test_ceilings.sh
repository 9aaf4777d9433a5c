#!/bin/sh
# Caches, history, skipped tests and saves never change an answer, also where no answer is found. Runs all tests of
# scenes, saves and lockstep with ceilings of 1, 2, 3 and 10 iterations, and in workspaces of 0 to 60 cells. Then with such
# ceilings on casts alone: their scans and rounds.
# test_ceilings.sh BUILD
. tests/build/count.sh
. tests/build/golden.sh
root=$(pwd)
dir=$1/ceilings
mkdir -p "$dir"

flags="-std=c99 -O1 -I$root/include -I$root -I$root/port -I$root/tests/support"

# compile ITERATIONS: the library, as test_limit.sh has it, and what the tests share, with that ceiling on iterations
compile() {
  rm -rf "${dir:?}/$1"
  mkdir -p "$dir/$1/tests"
  golden_library host "${CC:-cc}" -O2 "-DGJK_ITERATIONS_MAX=$1" '-DGJK_PORT_HEADER="hosted/gjk_port.h"' || return 1
  # shellcheck disable=SC2086
  (cd "$dir/$1/tests" && ${CC:-cc} $flags "-DGJK_ITERATIONS_MAX=$1" -c "$root"/tests/support/scene/*.c \
    "$root/tests/support/generate/polytope.c" "$root/tests/support/case/case.c" "$root/port/hosted/gjk_hosted.c" &&
    ar rcs ../all.a ./*.o "$root/$golden_objects"/gjk*.o)
}

# run ITERATIONS CELLS SOURCE ARGUMENTS...: a test with that ceiling, its worlds in so many cells
run() {
  iterations=$1 cells=$2 source=$3
  program=$dir/$iterations/$(basename "$source" .c)
  shift 3
  # shellcheck disable=SC2086
  [ -e "$program" ] || ${CC:-cc} $flags "-DGJK_ITERATIONS_MAX=$iterations" "$source" "$dir/$iterations/all.a" -lm -lpthread \
    -o "$program" || return 1
  GJK_TEST_CELLS=$cells "$program" "$@"
}

for iterations in 1 2 3 10; do
  check "a ceiling of $iterations" compile $iterations
  check "caches and histories, $iterations iterations" run $iterations 60 tests/check/unit/test_history.c
  check "matches, $iterations iterations" run $iterations 60 tests/check/limit/match.c
done
for setting in 1:0 2:20 3:40 10:60; do
  for source in tests/check/unit/test_scene_*.c tests/check/unit/test_plane_scene_random.c tests/check/unit/test_plane_scene_spread.c; do
    check "$(basename "$source" .c), iterations and cells $setting" run ${setting%:*} ${setting#*:} "$source"
  done
  check "saves and restores, iterations and cells $setting" run ${setting%:*} ${setting#*:} tests/check/soak_scene/main.c 8000
done

# casts CEILING: the library with that ceiling on scans and rounds of casts, and the test of casts under ceilings
casts() {
  objects=build/host-casts-$1
  sh tests/build/variant.sh "$objects" "-DGJK_CAST_ITERATIONS_MAX=$1" "-DGJK_ADVANCE_ROUNDS_MAX=$1" "-DGJK2_ADVANCE_ROUNDS_MAX=$1" &&
    answer_casts "$1" "$objects"
}

# answer_casts NAME FOLDER: leaves what the test of casts prints with the library there
answer_casts() {
  # shellcheck disable=SC2086
  mkdir -p "$dir/casts-$1" && ${CC:-cc} $flags tests/check/limit/casts.c $support "$2"/gjk*.o -lm -lpthread -o "$dir/casts-$1/casts" &&
    { "$dir/casts-$1/casts" >"$dir/casts-$1.txt" || { grep failed "$dir/casts-$1.txt"; return 1; }; }
}

# as_usual CEILING: its answers are the usual ones; open casts are bounded. 10 leave few kinds of casts open.
as_usual() {
  awk -v least=$(($1 < 10 ? 25 : 5)) -f tests/check/limit/casts.awk "$dir/casts-usual.txt" "$dir/casts-$1.txt"
}

# run_open CEILING SOURCE: a test of scenes with the library of casts
run_open() {
  program=$dir/casts-$1/$(basename "$2" .c)
  # shellcheck disable=SC2086,SC2046
  ${CC:-cc} $flags -DCEILINGS_OPEN_CASTS=1 "$2" tests/support/scene/world.c tests/support/scene/plane_world.c \
    $(echo "$support" | tr ' ' '\n' | grep -v world.o) "build/host-casts-$1"/gjk*.o -lm -lpthread -o "$program" && "$program"
}

support=$(make -s print-SUPPORT)
check 'the usual ceilings of casts' answer_casts usual build/host
for ceiling in 1 2 3 10; do
  check "casts, $ceiling scans and rounds" casts $ceiling
  check "casts, $ceiling scans and rounds: no other answer" as_usual $ceiling
done
for ceiling in 1 3; do
  for name in motion fast bullets slide; do
    check "test_scene_$name, $ceiling scans and rounds" run_open $ceiling "tests/check/unit/test_scene_$name.c"
    check "test_plane_scene_$name, $ceiling scans and rounds" run_open $ceiling "tests/check/unit/test_plane_scene_$name.c"
  done
  check "histories, $ceiling scans and rounds" run_open $ceiling tests/check/unit/test_history.c
done
finish ceilings
