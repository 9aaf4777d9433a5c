#!/bin/sh
# The C++ headers: the golden hashes of pairs and of a scene, what they do around the calls, low ceilings on iterations, the
# example of port/README.md; that firmware can have them, and what they cost there. test_cpp.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/cpp-test
rm -rf "$dir"
mkdir -p "$dir"
strict='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror'
includes='-Iinclude -Iport/cpp -Itests -Itests/support'

# program NAME COMPILER FLAGS...: of NAME.cpp here or in tests/check/bind
program() {
  name=$1
  compiler=$2
  shift 2
  source=tests/check/bind/$name.cpp
  [ -e "$source" ] || source=$dir/$name.cpp
  # shellcheck disable=SC2086
  "$compiler" -std=c++17 $strict $includes "$@" "$source" "$build/host/libgjk.a" "$build/hosted/port/hosted/gjk_hosted.o" \
    -o "$dir/$name-$compiler"
}

# The match of the plane is compiled from that of space.
plane_match() {
  cp tests/check/bind/scene_golden.cpp "$dir/plane_golden.cpp" &&
    program plane_golden "$1" -Itests/check/bind -DOF_PLANE -O2 -fno-exceptions -fno-rtti && runs plane_golden "$1"
}

# The scenes of the plane are those of space under other names: each call of the plane's header stands in the other one, too.
same_scenes() {
  grep -oE '\bgjk2_scene_[a-z_]+\(' port/cpp/gjk2_scene.hpp | sed 's/gjk2/gjk/' | sort -u >"$dir/flat"
  grep -oE '\bgjk_scene_[a-z_]+\(' port/cpp/gjk_scene.hpp | grep -v manifolds | sort -u | diff - "$dir/flat"
}

# The block of C++ in port/README.md, and what its comments say that it prints.
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/README.md >"$dir/readme.cpp"
readme() {
  sed -n 's|.*// prints: ||p' "$dir/readme.cpp" >"$dir/expected"
  program readme "$1" -O2 && "$dir/readme-$1" >"$dir/printed" && test -s "$dir/expected" && diff "$dir/expected" "$dir/printed"
}

# runs NAME COMPILER ARGUMENTS...
runs() {
  name=$1
  compiler=$2
  shift 2
  "$dir/$name-$compiler" "$@"
}

other_bits() {
  ! runs golden "$1" 149
}

other_match() {
  ! runs scene_golden "$1" 9999
}

# ceiling COMPILER MAX: with a library that has it
ceiling() {
  # shellcheck disable=SC2086
  ceilings_library &&
    "$1" -std=c++17 -O1 $strict $includes "-DGJK_ITERATIONS_MAX=$2" tests/check/bind/ceilings.cpp $ceilings_objects \
      "$build/hosted/port/hosted/gjk_hosted.o" -o "$dir/ceiling-$2" && GJK_TEST_ITERATIONS=$2 "$dir/ceiling-$2"
}

# literal COMPILER WORD: does a literal compile?
literal() {
  printf '#include "gjk.hpp"\nusing namespace gjk::literals;\nstatic_assert(%s >= 0);\n' "$2" >"$dir/literal.cpp"
  "$1" -std=c++17 -Iinclude -Iport/cpp -fsyntax-only "$dir/literal.cpp"
}

refused() {
  ! literal "$@"
}

# freestanding COMPILER FLAGS...: the headers need nothing of a library
freestanding() {
  printf '#include "%s"\n' gjk.hpp gjk2.hpp gjk_scene.hpp gjk2_scene.hpp gjk2_ground.hpp gjk_parts.hpp >"$dir/headers.cpp"
  # shellcheck disable=SC2086
  "$@" -std=c++17 $strict -Iinclude -Iport/cpp -ffreestanding -fno-exceptions -fno-rtti -c "$dir/headers.cpp" -o "$dir/headers.o"
}

needs_cpp17() {
  ! "$1" -std=c++14 -Iinclude -Iport/cpp -fsyntax-only port/cpp/gjk.hpp 2>"$dir/message" && grep -q 'needs C++17' "$dir/message"
}

# A function in C and in C++: the code of the second is larger by a store, 4 bytes, for each of its two results at most.
as_small_as_c() {
  cat >"$dir/cost.c" <<'END'
#include "gjk/gjk.h"
int32_t gap_of(const gjk_shape *shape, const gjk_pose *pose, const gjk_collider *b);
int32_t gap_of(const gjk_shape *shape, const gjk_pose *pose, const gjk_collider *b) {
  gjk_collider a;
  gjk_distance_result gap;
  if (gjk_collider_init(&a, shape, NULL, 0) != GJK_OK || gjk_collider_pose(&a, pose) != GJK_OK) return -1;
  return gjk_distance(&a, b, NULL, &gap) == GJK_OK ? gap.distance : -1;
}
END
  cat >"$dir/cost.cpp" <<'END'
#include "gjk.hpp"
extern "C" int32_t gap_of(const gjk_shape *shape, const gjk_pose *pose, const gjk_collider *b);
extern "C" int32_t gap_of(const gjk_shape *shape, const gjk_pose *pose, const gjk_collider *b) {
  const auto a = gjk::place(*shape, *pose);
  if (!a) return -1;
  const auto gap = gjk::distance(*a, *b);
  return gap ? gap->distance : -1;
}
END
  flags='-mcpu=cortex-m3 -mthumb -O2 -ffreestanding -Iinclude -Iport/cpp'
  # shellcheck disable=SC2086
  arm-none-eabi-gcc -std=c99 $flags -c "$dir/cost.c" -o "$dir/cost-c.o" &&
    arm-none-eabi-g++ -std=c++17 -fno-exceptions -fno-rtti $flags -c "$dir/cost.cpp" -o "$dir/cost-cpp.o" || return 1
  arm-none-eabi-size "$dir/cost-c.o" "$dir/cost-cpp.o"
  arm-none-eabi-size "$dir/cost-c.o" "$dir/cost-cpp.o" |
    awk 'NR == 2 { c = $1 } NR == 3 { cpp = $1 } END { exit c == 0 || cpp > c + 8 }'
}

is_formatted() {
  clang-format --dry-run -Werror port/cpp/*.hpp tests/check/bind/*.[ch]pp
}

for compiler in g++ clang++; do
  if ! have $compiler; then
    skip "gjk.hpp with $compiler" $compiler
    continue
  fi
  check "golden: compiles, $compiler" program golden $compiler -O2 -fno-exceptions -fno-rtti
  check "the golden hash, $compiler" runs golden $compiler
  check "another set has another hash, $compiler" other_bits $compiler
  check "a match: compiles, $compiler" program scene_golden $compiler -O2 -fno-exceptions -fno-rtti
  check "the golden hash of a scene, $compiler" runs scene_golden $compiler
  check "another match has another hash, $compiler" other_match $compiler
  check "the golden hash of a scene of the plane, $compiler" plane_match $compiler
  check "scenes, parts, solids: compiles, $compiler" program scene_behaviour $compiler -O1
  check "scenes, parts, solids, $compiler" runs scene_behaviour $compiler
  check "behaviour: compiles, $compiler" program behaviour $compiler -O1
  check "ground: compiles, $compiler" program ground_behaviour $compiler -O1
  check "ground, $compiler" runs ground_behaviour $compiler
  check "literals, ranges, results, $compiler" runs behaviour $compiler
  check "the README's example, $compiler" readme $compiler
  check "an older C++ is told so, $compiler" needs_cpp17 $compiler
  check "a literal, $compiler" literal $compiler 32767.9_q16
  for word in 32768_q16 2.0_q30 1e3_q16 0x10_q16 0.0000000001_q16; do
    check "$word is refused, $compiler" refused $compiler $word
  done
done
check 'scenes of the plane as of space' same_scenes
if have g++; then
  for max in 1 2 3; do
    check "a ceiling of $max" ceiling g++ $max
  done
else
  skip 'ceilings in C++' g++
fi
if [ -z "$(missing_package cortex-m3)" ] && have arm-none-eabi-g++; then
  check 'without a library, cortex-m3' freestanding arm-none-eabi-g++ -mcpu=cortex-m3 -mthumb
  check 'as small as C' as_small_as_c
else
  skip 'gjk.hpp for Cortex-M3' gcc-arm-none-eabi
fi
if have riscv64-unknown-elf-g++; then
  check 'without a library, rv32imc' freestanding riscv64-unknown-elf-g++ -march=rv32imc -mabi=ilp32
else
  skip 'gjk.hpp for RV32' gcc-riscv64-unknown-elf
fi
if have clang-format; then
  check 'layout' is_formatted
else
  skip 'layout of the C++ files' clang-format
fi
finish cpp
