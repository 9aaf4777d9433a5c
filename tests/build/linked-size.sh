#!/bin/sh
# Bytes of the library in a small Cortex-M3 program, built and linked for size: linked-size.sh BUILD MACRO...
# The macros choose the program, see tests/target/size.c. Code and constants; the program's own are not counted.
out=$1/linked
shift
mkdir -p "$out"
name=$out/program$(echo "$*" | tr -d ' ')
arm='arm-none-eabi-gcc -mthumb -mcpu=cortex-m3'
$arm -std=c99 -Os -ffreestanding -ffunction-sections -Iinclude "$@" -c tests/target/size.c -o "$name.o" &&
  $arm -nostdlib -Wl,--gc-sections -Wl,-esize_main "$name.o" build/cortex-m3-linked/libgjk.a -o "$name.elf" || exit 1
arm-none-eabi-size "$name.o" "$name.elf" | awk 'NR == 2 { own = $1 } NR == 3 { print $1 - own }'
