#!/bin/sh
# The same bits from every build: compilers, optimisation, with and without 128-bit integers and long
# multiplications, and on the emulated cores. test_golden.sh BUILD
. tests/build/count.sh
build=$1/golden
mkdir -p "$build"

# host NAME compiler flags...
host() {
  program=$build/$1
  shift
  "$@" -std=c99 -Iinclude -Isrc -Iport src/*.c tests/target/golden.c tests/target/golden_host.c \
    port/hosted/gjk_hosted.c -o "$program" && "$program"
}

for compiler in gcc clang; do
  for level in -O0 -O2 -Os; do
    if have $compiler; then
      check "$compiler $level" host "$compiler$level" $compiler $level
      check "$compiler $level, 128-bit integers" host "$compiler$level-wide" $compiler $level \
        '-DGJK_PORT_HEADER="hosted/gjk_port.h"'
      check "$compiler $level, narrow multiplication" host "$compiler$level-narrow" $compiler $level \
        -DGJK_NARROW_MULTIPLY=1
    else
      skip "golden hash with $compiler $level" $compiler
    fi
  done
done
if have gcc; then
  check 'undefined behaviour and addresses' host sanitized gcc -O1 -fsanitize=undefined,address -fno-sanitize-recover=all
fi

# target NAME OPT [DEFINE]: builds the firmware and runs it
target() {
  elf=build/$1-golden$2/golden.elf
  rm -f "$elf"
  make -s "$elf" TARGET="$1" OPT="$2" VARIANT="-golden$2" FIRMWARE_DEFINES="$3" &&
    sh tests/build/emulate.sh "$1" "$elf"
}
for core in cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc avr; do
  missing="$(missing_package $core) $(missing_emulator $core)"
  few=
  [ $core = avr ] && few=-DGOLDEN_RUN_PAIRS=GOLDEN_FEW_PAIRS
  for level in -O2 -Os; do
    if [ -z "${missing# }" ]; then
      check "$core $level" target $core $level "$few"
    else
      skip "golden hash on $core $level" "$missing"
    fi
  done
done
missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -z "${missing# }" ]; then
  check 'the scene of the demo on cortex-m3' sh tests/build/demo-target.sh "$1" tests/data/arm.txt
else
  skip 'the scene of the demo on cortex-m3' "$missing"
fi
finish golden
