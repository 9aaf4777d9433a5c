#!/bin/sh
# Caches, history, skipped tests and saves never change an answer, also where no answer is found. Runs all tests of
# scenes, saves and lockstep with ceilings of 1, 2, 3 and 10 iterations, and in workspaces of 0 to 60 cells. Then with such
# ceilings on casts alone: their scans and rounds.
# test_ceilings.sh BUILD
# shellcheck disable=SC2030,SC2031  # what is exported in a subshell is for that alone
. tests/build/count.sh
dir=$1/ceilings
mkdir -p "$dir"

scenes='tests/check/unit/test_plane_scene_random.c tests/check/unit/test_plane_scene_spread.c'
scenes="$(echo tests/check/unit/test_scene_*.c) $scenes"
support=$(make -s print-SUPPORT)

flags='-std=c99 -O1 -include tests/support/given_ceilings.h -Iinclude -I. -Iport -Itests/support'

# object SOURCE: sets object to its object with the ceilings of the environment: the usual one where it uses none
object() {
  object=$dir/$(echo "${1%.c}" | tr / -).o
  # shellcheck disable=SC2086
  if ! ${CC:-cc} $flags -E -P "$1" | grep -q 'given_[a-z_]* [+<]'; then
    object=build/hosted/${1%.c}.o
    case " $support " in *" $object "*) ;; *) alone hosted make -s "$object" ;; esac
  elif ! [ -e "$object" ]; then
    ${CC:-cc} $flags -c "$1" -o "$object"
  fi
}

# whole: the library and what the tests share in one archive
whole() {
  # shellcheck disable=SC2086
  ceilings_library && alone hosted make -s $support || return 1
  members=
  for shared in $support; do
    shared=${shared#build/hosted/}
    object "${shared%.o}.c" || return 1
    members="$members $object"
  done
  # shellcheck disable=SC2086
  rm -f "$dir/all.a" && ar rcs "$dir/all.a" $members $ceilings_objects
}

# run ITERATIONS CELLS SOURCE ARGUMENTS...: 30 % of a test with that ceiling, its worlds in so many cells
run() {
  iterations=$1 cells=$2 source=$3
  program=$dir/$(basename "$source" .c)
  shift 3
  [ -e "$program" ] || { object "$source" && ${CC:-cc} "$object" "$dir/all.a" -lm -lpthread -o "$program"; } || return 1
  GJK_TEST_ITERATIONS=$iterations GJK_TEST_CELLS=$cells GJK_TEST_PERCENT=${GJK_TEST_PERCENT:-30} "$program" "$@"
}

rm -f "$dir"/*
check 'the library, and what the tests share' whole
for iterations in 1 2 3 10; do
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
  export GJK_TEST_PERCENT=15
  run "$1" 60 tests/check/unit/test_concave_hostile.c
)

for iterations in 1 2 3; do
  check "concave bodies, $iterations iterations" concave $iterations
done

# casts CEILING: leaves what the test of casts prints with that ceiling on scans and rounds of casts
casts() (
  export GJK_TEST_CAST_ITERATIONS="$1" GJK_TEST_ROUNDS="$1" GJK_TEST_PERCENT=100
  run 128 2000 tests/check/limit/casts.c >"$dir/casts-$1.txt" || { grep failed "$dir/casts-$1.txt"; return 1; }
)

# usual: the same with the library as it is
usual() {
  make -s build/hosted/tests/check/limit/casts.o &&
    ${CC:-cc} build/hosted/tests/check/limit/casts.o $support build/host/libgjk.a -lm -lpthread -o "$dir/usual" &&
    "$dir/usual" >"$dir/casts-usual.txt"
}

# as_usual CEILING: its answers are the usual ones; open casts are bounded. 10 leave few kinds of casts open.
as_usual() {
  awk -v least=$(($1 < 10 ? 25 : 5)) -f tests/check/limit/casts.awk "$dir/casts-usual.txt" "$dir/casts-$1.txt"
}

# run_open CEILING SOURCE: a whole test of scenes with that ceiling on casts
run_open() (
  export GJK_TEST_CAST_ITERATIONS="$1" GJK_TEST_ROUNDS="$1" GJK_TEST_PERCENT=100
  run 128 2000 "$2"
)

check 'the usual ceilings of casts' usual
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
