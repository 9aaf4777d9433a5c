#!/bin/sh
# The library as two files: they are complete by themselves, give the same bits, and have the same size to within 2 %.
# test_amalgamation.sh BUILD
. tests/build/count.sh
. tests/build/version.sh
build=$1
root=$(pwd)
dir=$build/amalgamation-test
rm -rf "$dir"
mkdir -p "$dir"
strict='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wno-unused-function -Werror'
# The comment that either file begins with says the version and every macro that a build may define: those with a default
# in the public headers and in gjk_port_defaults.h, and the port's header.
says_version_and_options() {
  sed -n '/^\/\//!q;p' "$dir/$1" >"$dir/heading"
  grep -q "^// gjk $version: " "$dir/heading" || return 1
  sed -n 's/^#ifndef \(GJK2\{0,1\}_[A-Z0-9_]*\)$/\1/p; s/^\/\/ \(GJK_CLZ32\)(x): .*/\1/p; s/^#ifdef \(GJK_PORT_HEADER\)$/\1/p' \
    src/arith/gjk_port_defaults.h include/*/*.h | grep -v '_H$' | sort -u >"$dir/options"
  [ "$(wc -l <"$dir/options")" -ge 7 ] || return 1
  while read -r option; do
    grep -qE "^//   ${option}[( ]" "$dir/heading" || { echo "$option is not named"; return 1; }
  done <"$dir/options"
}

# `make amalgamation` leaves the same.
the_same_by_make() {
  make -s amalgamation && cmp build/amalgamation/gjk.h "$dir/gjk.h" && cmp build/amalgamation/gjk.c "$dir/gjk.c"
}

# compiles NAME COMPILER FLAGS...: in that folder, with no include path
compiles() {
  name=$1
  shift
  # shellcheck disable=SC2086
  (cd "$dir" && "$@" -c -o "$name.o" gjk.c)
}

# The README's example, with the one header.
sed -n '/^```c$/,/^```$/{/^```/d;p;}' README.md | awk '/^#include <stdio.h>/ { n++ } n == 1 { print }' |
  sed 's|#include "gjk/gjk.h"|#include "gjk.h"|' >"$dir/example.c"
example() {
  (cd "$dir" && "$@" -c example.c -o example.o && "$1" example.o "$object.o" -o example && ./example) >"$dir/printed" &&
    sed -n 's|.*// prints: ||p' "$dir/example.c" | head -n 1 | diff - "$dir/printed"
}

# What asks the queries of the golden hash, made once.
glue() {
  # shellcheck disable=SC2086
  (cd "$dir" && gcc -std=c99 -O2 "-I$root/include" "-I$root" "-I$root/port" "-I$root/tests/support" -c \
    "$root/tests/check/target/golden.c" "$root/tests/check/target/golden_host.c" "$root/tests/check/target/plane_golden.c" \
    "$root/tests/check/target/motion_golden.c" "$root/tests/check/target/plane_motion_golden.c" "$root/tests/check/target/parts_golden.c" "$root/tests/check/target/hull_golden.c" \
    "$root/tests/support/scene/match.c" "$root/tests/check/target/scene_golden.c" "$root/tests/check/target/concave_golden.c" "$root/port/hosted/gjk_hosted.c")
}

# same_bits OBJECT LINKER: the golden hash with that object in the place of the library
same_bits() {
  "$2" "$dir/golden.o" "$dir/golden_host.o" "$dir/plane_golden.o" "$dir/motion_golden.o" "$dir/plane_motion_golden.o" "$dir/parts_golden.o" "$dir/hull_golden.o" \
    "$dir/match.o" "$dir/scene_golden.o" "$dir/concave_golden.o" "$dir/gjk_hosted.o" "$dir/$1.o" -o "$dir/$1.golden" && "$dir/$1.golden"
}

# within_two_percent MACROS...: what a program links of the one file, against what it links of the library
within_two_percent() {
  whole=$(sh tests/build/linked-size.sh "$build" cortex-m3 "$@") &&
    one=$(LIBRARY=$dir/m3.o sh tests/build/linked-size.sh "$build" cortex-m3 "$@") &&
    echo "$one bytes, $whole of the library" && [ $((one * 100)) -le $((whole * 102)) ]
}

check 'two files' sh tests/build/amalgamate.sh "$dir"
check 'the same by make' the_same_by_make
for file in gjk.h gjk.c; do
  check "$file says version and options" says_version_and_options $file
done
check 'no include of a file of its own' sh -c "! grep -nE '^ *#include \"' '$dir/gjk.h' && [ \$(grep -cE '^ *#include \"' '$dir/gjk.c') = 1 ]"
check 'the queries of the golden hash' glue
for compiler in gcc clang g++ clang++; do
  if ! have $compiler; then
    skip "one file with $compiler" $compiler
    continue
  fi
  case $compiler in
    *++) flags='-std=c++17 -x c++ -Wall -Wextra -Wno-unused-function -Werror' ;;
    *) flags="-std=c99 $strict" ;;
  esac
  case $compiler in  # all in one file is a test for the optimiser; once will do
    gcc) flags="$flags -O2" ;;
    *) flags="$flags -O0" ;;
  esac
  object=$(echo $compiler | tr + p)
  # shellcheck disable=SC2086
  check "one file compiles, $compiler" compiles $object $compiler $flags
  check "the same bits, $compiler" same_bits $object $compiler
  case $compiler in
    *++) check "the README's example, $compiler" example $compiler -std=c++17 -x c++ ;;
    *) check "the README's example, $compiler" example $compiler -std=c99 ;;
  esac
done
missing=$(missing_package cortex-m3)
if [ -z "$missing" ]; then
  LINKED_TOOLS=$(make -s print-TOOLS_cortex-m3 | sed 's/-fcallgraph-info=su//')
  export LINKED_TOOLS
  # shellcheck disable=SC2086
  check 'one file for Cortex-M3' compiles m3 $LINKED_TOOLS -std=c99 -Os -ffreestanding -ffunction-sections -fdata-sections
  check 'the library for Cortex-M3' library cortex-m3 -Os OPT=-Os
  check 'as small: boxes' within_two_percent -DSIZE_BOXES
  check 'as small: distance, with posing' within_two_percent -DSIZE_POSED
  check 'as small: contacts' within_two_percent -DSIZE_POSED -DSIZE_CONTACTS
else
  skip 'one file for Cortex-M3' "$missing"
fi
finish amalgamation
