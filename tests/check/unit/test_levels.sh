#!/bin/sh
# Builds for fewer kinds of shapes, by GJK_SHAPES: the same bits for those as from the whole library, on the host and on an
# emulated core; other kinds are refused; each is one file without a warning. test_levels.sh BUILD
. tests/build/count.sh
build=$1/levels
mkdir -p "$build/objects"
sources='tests/check/target/levels.c tests/check/target/plane_levels.c tests/check/target/levels_host.c port/hosted/gjk_hosted.c'

# programs: the objects that the program links with each library
programs() {
  folder=$(pwd)
  # shellcheck disable=SC2046,SC2086
  (cd "$build/objects" && ${CC:-cc} -std=c99 -O1 "-I$folder/include" "-I$folder" "-I$folder/port" "-I$folder/tests/support" -c \
    $(printf "$folder/%s " $sources))
}

# host NAME OBJECTS...: the program with that library, at build/levels/host-NAME
host() {
  program=$build/host-$1
  shift
  ${CC:-cc} "$build"/objects/*.o "$@" -o "$program"
}

# same LEVEL: its set by its build and by that of all shapes
same() {
  "$build/host-5" 5 "$1" 3000 >"$build/all-$1.txt" && "$build/host-$1" "$1" "$1" 3000 | diff "$build/all-$1.txt" -
}

# firmware LEVEL NAME
firmware() {
  "$build/host-5" 5 "$1" 200 >"$build/few-$1.txt"
  level_library '' "$2" || return 1
  make -s "build/cortex-m3-Os-$2/levels.elf" TARGET=cortex-m3 VARIANT="-Os-$2" "OPT=-Os -DGJK_SHAPES=GJK_SHAPES_$2" \
    "SOURCES=$(level_sources)" "FIRMWARE_DEFINES=-DLEVELS_LEVEL=$1" >"$build/log" 2>&1 || { cat "$build/log"; return 1; }
  sh tests/build/emulate.sh cortex-m3 "build/cortex-m3-Os-$2/levels.elf" >"$build/firmware-$1.txt" &&
    diff "$build/few-$1.txt" "$build/firmware-$1.txt"
}

# ground LEVEL: ground, and a game on it, of boxes and capsules
ground() {
  ${CC:-cc} -std=c99 -O1 "-DGJK_SHAPES=$1" -Iinclude -I. -Iport -Itests/support tests/check/target/ground_golden.c \
    tests/check/target/ground_golden_host.c port/hosted/gjk_hosted.c "$build/$1.o" -o "$build/ground-$1" && "$build/ground-$1"
}

# one_file COMPILER FLAGS...
one_file() {
  (cd "$build/one" && "$@" gjk.c)
}

refused_value() {
  ! ${CC:-cc} -std=c99 -Iinclude -DGJK_SHAPES=GJK_SHAPES_CUBES -fsyntax-only src/place/gjk_collider.c 2>"$build/message" &&
    grep -q GJK_SHAPES_POINTS "$build/message"
}

check 'the library of all shapes' library host ''
check 'the program' programs
check 'all shapes' host 5 build/host/gjk*.o
check 'one file' sh tests/build/amalgamate.sh "$build/one"
missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
for level in 1 2 3 4; do
  strict="-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror -DGJK_SHAPES=$level"
  # shellcheck disable=SC2086
  check "level $level: one file, gcc, no function is unused" one_file gcc -std=c99 -O0 $strict -c -o "../$level.o"
  if have clang; then
    # shellcheck disable=SC2086
    check "level $level: one file, clang" one_file clang -std=c99 -fsyntax-only $strict -Wno-unused-function
  else
    skip "level $level: one file" clang
  fi
  check "level $level" host $level "$build/$level.o"
  check "level $level: the same bits, and others are refused" same $level
  [ $level -lt 3 ] || check "level $level: ground has its hash" ground $level
done
for level in 1-POINTS 3-BOXES; do  # the host has shown all levels; two show that the core adds nothing
  if [ -z "${missing# }" ]; then
    check "level $level on cortex-m3" firmware "${level%-*}" "${level#*-}"
  else
    skip "level $level on cortex-m3" "$missing"
  fi
done
check 'a level that is none stops the build' refused_value
finish levels
