#!/bin/sh
# Runs the assertions of the sources as checks, with the sanitizers for undefined behaviour and addresses: bounds.sh
# BUILD PAIRS STEP. PAIRS: random pairs, as many that move, and as many forged scenes, for each of two builds. STEP: Newton's iterations
# are run for every STEP-th number.
dir=$1/bounds
root=$(pwd)
rm -rf "$dir"
mkdir -p "$dir"
cp -r src "$dir/src"
for file in src/*/*.[ch]; do
  sed 's|//@ assert \(.*\);$|if (!(\1)) __builtin_trap();|; s|//@ .*||' "$file" >"$dir/$file"
done
support="tests/support/generate/*.c tests/support/reference/random_shape.c tests/support/exact/*.c tests/support/case/case.c tests/support/case/case2.c tests/support/case/case2_collider.c"

# library NAME SANITIZERS FOLDERS...: NAME.a of these folders of the sources
library() {
  name=$1
  sanitizers=$2
  shift 2
  mkdir -p "$dir/$name"
  # shellcheck disable=SC2046,SC2086
  (cd "$dir/$name" && ${CC:-cc} -std=c99 -O1 $sanitizers "-I$root/include" -c $(printf "$root/$dir/src/%s/*.c " "$@") &&
    ar rcs "../$name.a" ./*.o)
}

# build NAME SANITIZERS SOURCES...
build() {
  name=$1
  sanitizers=$2
  shift 2
  # shellcheck disable=SC2086
  ${CC:-cc} -std=c99 -O1 $sanitizers -Iinclude "-I$dir" -Itests/support "$@" -lm -o "$dir/$name"
}

all='-fsanitize=undefined,address -fno-sanitize-recover=all'
library library "$all" '*' &&
  library narrow "$all -DGJK_NARROW_MULTIPLY=1" arith contact depth gjk mesh motion parts place plane plane_motion query shape ||
  exit 1
# shellcheck disable=SC2086
build pairs "$all" $support tests/prove/bounds.c "$dir/library.a" && [ "$("$dir/pairs" "$2")" = "$2" ] || exit 1
# shellcheck disable=SC2086
build pairs-narrow "$all -DGJK_NARROW_MULTIPLY=1" $support tests/prove/bounds.c "$dir/narrow.a" &&
  [ "$("$dir/pairs-narrow" "$2")" = "$2" ] || exit 1
# shellcheck disable=SC2086
build motion "$all" $support tests/prove/bounds_motion.c "$dir/library.a" && [ "$("$dir/motion" "$2")" = "$2" ] || exit 1
# shellcheck disable=SC2086
build motion-narrow "$all -DGJK_NARROW_MULTIPLY=1" $support tests/prove/bounds_motion.c "$dir/narrow.a" &&
  [ "$("$dir/motion-narrow" "$2")" = "$2" ] || exit 1
# shellcheck disable=SC2086
build scene "$all" tests/support/scene/world.c tests/prove/bounds_scene.c "$dir/library.a" &&
  [ "$("$dir/scene" "$2")" = "$2" ] || exit 1
# The plane's own tests, with a percent of their trials for every 1,000 pairs.
for test in cast check contacts curved distance hostile impact impact_curved penetration polygon pose; do
  # shellcheck disable=SC2086
  if ! build plane "$all -Iport" "tests/check/unit/test_plane_$test.c" "$dir/library.a" ||
    ! GJK_TEST_PERCENT=$(($2 / 1000 + 1)) "$dir/plane" >"$dir/plane.log" 2>&1; then
    echo "the assertions of the plane fail in test_plane_$test"
    exit 1
  fi
done
build exhaust '-fsanitize=undefined -fsanitize-undefined-trap-on-error' tests/prove/exhaust.c "$dir/src/arith/gjk_root.c" &&
  "$dir/exhaust" "$3"
