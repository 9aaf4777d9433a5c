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
scenes='tests/check/unit/test_plane_scene_random.c tests/check/unit/test_plane_scene_spread.c'
scenes="$(echo tests/check/unit/test_scene_*.c) $scenes"
shared="$(echo tests/support/scene/*.c) tests/support/generate/polytope.c tests/support/generate/surface.c
  tests/support/reference/random_shape.c tests/support/case/case.c port/hosted/gjk_hosted.c"
programs='tests/check/unit/test_history.c tests/check/limit/match.c tests/check/soak_scene/main.c tests/check/limit/casts.c'

# The objects with the usual macros.
usual() {
  # shellcheck disable=SC2046
  make -s $(for source in $shared $scenes $programs tests/check/unit/test_concave_hostile.c tests/check/unit/test_plane_scene_*.c; do
    echo "build/hosted/${source%.c}.o"
  done | sort -u)
}

# read_source SOURCE MACROS...: a sum over what the compiler reads of it
read_source() {
  # shellcheck disable=SC2086
  ${CC:-cc} $flags -E -P "$@" | cksum
}

# object FOLDER SOURCE MACROS...: leaves its object in FOLDER: the usual one where the macros change nothing
object() {
  to=$1/$(echo "${2%.c}" | tr / -).o source=$2
  shift 2
  mkdir -p "${to%/*}"
  if [ -e "$to" ]; then
    return 0
  elif [ "$(read_source "$source")" = "$(read_source "$source" "$@")" ]; then
    cp "build/hosted/${source%.c}.o" "$to"
  else
    # shellcheck disable=SC2086
    ${CC:-cc} $flags "$@" -c "$source" -o "$to"
  fi
}

# compile ITERATIONS: the library, as test_limit.sh has it, and what the tests share, with that ceiling on iterations
compile() {
  rm -rf "${dir:?}/$1"
  golden_library host "${CC:-cc}" -O2 "-DGJK_ITERATIONS_MAX=$1" '-DGJK_PORT_HEADER="hosted/gjk_port.h"' || return 1
  for source in $shared; do
    object "$dir/$1/shared" "$source" "-DGJK_ITERATIONS_MAX=$1" || return 1
  done
  ar rcs "$dir/$1/all.a" "$dir/$1"/shared/*.o "$golden_objects"/gjk*.o
}

# run ITERATIONS CELLS SOURCE ARGUMENTS...: half of a test with that ceiling, its worlds in so many cells
run() {
  iterations=$1 cells=$2 source=$3
  program=$dir/$iterations/$(basename "$source" .c)
  shift 3
  if ! [ -e "$program" ]; then
    object "$dir/$iterations/tests" "$source" "-DGJK_ITERATIONS_MAX=$iterations" &&
      ${CC:-cc} "$to" "$dir/$iterations/all.a" -lm -lpthread -o "$program" || return 1
  fi
  GJK_TEST_CELLS=$cells GJK_TEST_PERCENT=${GJK_TEST_PERCENT:-50} "$program" "$@"
}

check 'the tests and what they share' usual
for iterations in 1 2 3 10; do
  check "a ceiling of $iterations" compile $iterations
  check "caches and histories, $iterations iterations" run $iterations 60 tests/check/unit/test_history.c
  check "matches, $iterations iterations" run $iterations 60 tests/check/limit/match.c
done
for setting in 1:0 2:20 3:40 10:60; do
  for source in $scenes; do
    check "$(basename "$source" .c), iterations and cells $setting" run ${setting%:*} ${setting#*:} "$source"
  done
  check "saves and restores, iterations and cells $setting" run ${setting%:*} ${setting#*:} tests/check/soak_scene/main.c 8000
done

# concave ITERATIONS: a few games with concave bodies
concave() (
  export GJK_TEST_PERCENT=25
  run "$1" 60 tests/check/unit/test_concave_hostile.c
)

for iterations in 1 2 3; do
  check "concave bodies, $iterations iterations" concave $iterations
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
  mkdir -p "$dir/casts-$1" &&
    ${CC:-cc} build/hosted/tests/check/limit/casts.o $support "$2"/gjk*.o -lm -lpthread -o "$dir/casts-$1/casts" &&
    { "$dir/casts-$1/casts" >"$dir/casts-$1.txt" || { grep failed "$dir/casts-$1.txt"; return 1; }; }
}

# as_usual CEILING: its answers are the usual ones; open casts are bounded. 10 leave few kinds of casts open.
as_usual() {
  awk -v least=$(($1 < 10 ? 25 : 5)) -f tests/check/limit/casts.awk "$dir/casts-usual.txt" "$dir/casts-$1.txt"
}

# run_open CEILING SOURCE: a test of scenes with the library of casts
run_open() {
  program=$dir/casts-$1/$(basename "$2" .c)
  for source in "$2" tests/support/scene/world.c tests/support/scene/plane_world.c; do
    object "$dir/open" "$source" -DCEILINGS_OPEN_CASTS=1 || return 1
  done
  # shellcheck disable=SC2046
  ${CC:-cc} "$dir/open/$(echo "${2%.c}" | tr / -).o" "$dir"/open/tests-support-scene-*world.o \
    $(echo "$support" | tr ' ' '\n' | grep -v -e '/world.o' -e '/plane_world.o') "build/host-casts-$1"/gjk*.o -lm -lpthread -o "$program" && "$program"
}

rm -rf "$dir/open"
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
