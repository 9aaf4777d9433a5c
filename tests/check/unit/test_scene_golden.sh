#!/bin/sh
# A match of 10,000 ticks in a scene has the same hash from every build, through saves and rollbacks, on the emulated
# cores and on a big-endian machine. test_scene_golden.sh BUILD
. tests/build/count.sh
build=$1/scene_golden
mkdir -p "$build"
sources='tests/support/scene/match.c tests/check/target/scene_golden.c tests/check/target/scene_golden_host.c'

# host NAME RUNNER COMPILER FLAGS...
host() {
  program=$build/$1
  runner=$2
  shift 2
  # shellcheck disable=SC2086
  "$@" -std=c99 -Iinclude -I. -Iport -Itests/support src/*/*.c $sources -o "$program" && $runner "$program"
}

for compiler in gcc clang; do
  if have $compiler; then
    check "$compiler -O2" host $compiler '' $compiler -O2
    check "$compiler -Os, narrow multiplication" host $compiler-narrow '' $compiler -Os -DGJK_NARROW_MULTIPLY=1
  else
    skip "the match with $compiler" $compiler
  fi
done
if have gcc; then
  check 'undefined behaviour and addresses' host sanitized '' gcc -O1 -fsanitize=undefined,address \
    -fno-sanitize-recover=all
fi
if ! have s390x-linux-gnu-gcc; then
  skip 'the match on a big-endian machine' 'gcc-s390x-linux-gnu libc6-dev-s390x-cross'
elif ! have qemu-s390x; then
  skip 'the match on a big-endian machine' qemu-user
else
  check 'big-endian' host s390x qemu-s390x s390x-linux-gnu-gcc -O2 -static
fi

# target NAME
target() {
  make -s "build/$1/scene_golden.elf" TARGET="$1" && sh tests/build/emulate.sh "$1" "build/$1/scene_golden.elf"
}
for core in cortex-m3 cortex-m4 cortex-m33 rv32imc; do
  missing="$(missing_package $core) $(missing_emulator $core)"
  if [ -z "${missing# }" ]; then
    check $core target $core
  else
    skip "the match on $core" "$missing"
  fi
done
finish scene_golden
