#!/bin/sh
# Runs the assertions of the sources as checks, with the sanitizers for undefined behaviour and addresses: bounds.sh
# BUILD PAIRS STEP. PAIRS: random pairs, as many that move, and as many forged scenes, for each of two builds. STEP: Newton's iterations
# are run for every STEP-th number.
. tests/build/count.sh
dir=$1/bounds
root=$(pwd)
rm -rf "$dir"
mkdir -p "$dir/narrow"
checked_library || exit 1
all='-fsanitize=undefined,address -fno-sanitize-recover=all'
# The oracles are as they are in other tests.
support=$(make -s print-SUPPORT)
# shellcheck disable=SC2086
make -s $support >/dev/null && ar rcs "$dir/support.a" $support || exit 1

# build NAME SANITIZERS FILES...
build() {
  name=$1
  sanitizers=$2
  shift 2
  # shellcheck disable=SC2086
  ${CC:-cc} -std=c99 -O1 $sanitizers -Iinclude -Ibuild/checked -Iport -Itests/support "$@" "$dir/support.a" -lm -o "$dir/$name"
}

# answers PROGRAM COUNT: it prints that it asked about so many
answers() {
  [ "$("$dir/$1" "$2")" = "$2" ]
}

library='build/checked/gjk*.o'
# The same with products of 16 bits, of what computes.
computes='arith contact depth gjk mesh motion parts place plane plane_motion query shape'
# shellcheck disable=SC2046,SC2086
(cd "$dir/narrow" && ${CC:-cc} -std=c99 -Og $all -DGJK_NARROW_MULTIPLY=1 "-I$root/include" \
  -c $(printf "$root/build/checked/rooms/gjk-%s.c " $computes)) || exit 1
# shellcheck disable=SC2086
build pairs "$all" tests/prove/bounds.c $library && answers pairs "$2" || exit 1
build pairs-narrow "$all -DGJK_NARROW_MULTIPLY=1" tests/prove/bounds.c "$dir"/narrow/*.o && answers pairs-narrow "$2" || exit 1
# shellcheck disable=SC2086
build motion "$all" tests/prove/bounds_motion.c $library && answers motion "$2" || exit 1
build motion-narrow "$all -DGJK_NARROW_MULTIPLY=1" tests/prove/bounds_motion.c "$dir"/narrow/*.o && answers motion-narrow "$2" ||
  exit 1
# shellcheck disable=SC2086
build scene "$all" tests/prove/bounds_scene.c $library && answers scene "$2" || exit 1
# The plane's own tests, with a percent of their trials for every 1,000 pairs.
for test in canonical cast check contacts curved hostile impact impact_curved lattice polygon pose; do
  # shellcheck disable=SC2086
  if ! build plane "$all" "tests/check/unit/test_plane_$test.c" $library ||
    ! GJK_TEST_PERCENT=$(($2 / 1000 + 1)) "$dir/plane" >"$dir/plane.log" 2>&1; then
    echo "the assertions of the plane fail in test_plane_$test"
    exit 1
  fi
done
build exhaust '-fsanitize=undefined -fsanitize-undefined-trap-on-error' tests/prove/exhaust.c build/checked/src/arith/gjk_root.c &&
  "$dir/exhaust" "$3"
