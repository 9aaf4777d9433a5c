#!/bin/sh
# Caches, history, skipped tests and saves never change an answer, also where no answer is found. Runs all tests of
# scenes, saves and lockstep with ceilings of 1, 2, 3 and 10 iterations, and in workspaces of 0 to 60 cells.
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
finish ceilings
