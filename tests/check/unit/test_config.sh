#!/bin/sh
# A wrong setting stops the build with an #error that names the remedy. test_config.sh BUILD
. tests/build/count.sh
scratch=$1/config
mkdir -p "$scratch"
compiler=${CC:-cc}

# stops REMEDY FLAGS... FILE: the compiler refuses, and its message holds REMEDY
stops() {
  remedy=$1
  shift
  if "$compiler" -std=c99 -Iinclude -Iport -fsyntax-only "$@" >"$scratch/message" 2>&1; then
    echo "compiled"
    return 1
  fi
  grep '#error' "$scratch/message" | grep -qF -- "$remedy" || { cat "$scratch/message"; return 1; }
}

compiles() {
  "$compiler" -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude -Iport -fsyntax-only "$@"
}

check 'GJK_NARROW_MULTIPLY is 0 or 1' stops 'set it to 1 in the port header' -DGJK_NARROW_MULTIPLY=2 src/arith/gjk_wide.c
check 'GJK_VECTORS is 0 or 1' stops 'set it to 0 in the port header' -DGJK_VECTORS=2 src/arith/gjk_wide.c
check 'GJK_VECTORS needs vectors' stops 'set it to 0 in the port header' -DGJK_VECTORS=1 -DGJK_NARROW_MULTIPLY=1 \
  src/arith/gjk_wide.c
check 'GJK_INT128 is 0 or 1' stops 'set it to 1 in the port header' -DGJK_INT128=2 src/arith/gjk_wide.c
check 'GJK_INT128 comes with a type' stops 'define GJK_INT128_TYPE' -DGJK_INT128=1 src/arith/gjk_wide.c
check 'the arena has a size' stops 'say -DGJK_ARENA_BYTES=' -DGJK_ARENA_BYTES=32 port/generic/gjk_arena.c
check 'the arena is a multiple of its alignment' stops 'say -DGJK_ARENA_BYTES=' -DGJK_ARENA_BYTES=100 \
  port/generic/gjk_arena.c
check 'the arena of another size' compiles -DGJK_ARENA_BYTES=64 port/generic/gjk_arena.c
check 'the library in one file' sh tests/build/amalgamate.sh "$scratch"
for port in generic hosted template; do
  check "every source with the $port port" compiles -Wno-unused-function "-DGJK_PORT_HEADER=\"$port/gjk_port.h\"" "$scratch/gjk.c"
done

# settles MACRO VALUE COMPILER FLAGS...: the value that the library settles on
settles() {
  macro=$1 value=$2
  shift 2
  settled=$(printf '#include "src/arith/gjk_port_defaults.h"\nsettled: %s\n' "$macro" |
    "$@" -std=c99 -ffreestanding -I. -Iport -I"$scratch" -E -P -x c -)
  printf '%s\n' "$settled" | grep -qx "settled: $value" || { printf '%s\n' "$settled" | tail -n 1; return 1; }
}

takes() {
  settles GJK_NARROW_MULTIPLY "$@"
}

# What the compiler predefines says whether the core has a long multiplication; a definition from outside overrides it.
printf '#define GJK_NARROW_MULTIPLY 0\n' >"$scratch/long_port.h"
printf '#define GJK_NARROW_MULTIPLY 1\n' >"$scratch/narrow_port.h"
check 'a long multiplication is the default' takes 0 "$compiler"
for core in '-D__ARM_ARCH_6M__' '-D__ARM_ARCH_8M_BASE__' '-D__AVR__' '-D__riscv'; do
  check "$core: narrow" takes 1 "$compiler" "$core"
  check "$core: overridden" takes 0 "$compiler" "$core" -DGJK_NARROW_MULTIPLY=0
  check "$core: overridden by the port" takes 0 "$compiler" "$core" '-DGJK_PORT_HEADER="long_port.h"'
done
check '-D__riscv_mul: long' takes 0 "$compiler" -D__riscv -D__riscv_mul
check 'narrow by definition' takes 1 "$compiler" -DGJK_NARROW_MULTIPLY=1
check 'narrow by the port' takes 1 "$compiler" '-DGJK_PORT_HEADER="narrow_port.h"'

# core VALUE FLAGS... with the cross compiler CROSS, where there is one
core() {
  if ! have "$cross"; then
    skip "what $cross predefines" "$cross"
    return
  fi
  value=$1
  shift
  check "$cross $*" takes "$value" "$cross" "$@"
}

cross=arm-none-eabi-gcc
for cpu in m0 m0plus m1 m23; do core 1 -mthumb -mcpu=cortex-$cpu; done
for cpu in m3 m4 m7 m33; do core 0 -mthumb -mcpu=cortex-$cpu; done
cross=riscv64-unknown-elf-gcc
core 1 -march=rv32ic -mabi=ilp32
core 0 -march=rv32imc -mabi=ilp32
cross=avr-gcc
core 1 -mmcu=atmega2560

# Vectors where the core has them, unless the port says no or code is to be small.
printf '#define GJK_VECTORS 0\n' >"$scratch/scalar_port.h"
case $(uname -m) in
  x86_64 | aarch64)
    check 'vectors' settles GJK_VECTORS 1 "$compiler" -O2
    check 'vectors: not where code is to be small' settles GJK_VECTORS 0 "$compiler" -Os
    check 'vectors: small, but asked for' settles GJK_VECTORS 1 "$compiler" -Os -DGJK_VECTORS=1
    check 'vectors: overridden by the port' settles GJK_VECTORS 0 "$compiler" '-DGJK_PORT_HEADER="scalar_port.h"'
    check 'vectors: none with a narrow multiplication' settles GJK_VECTORS 0 "$compiler" -DGJK_NARROW_MULTIPLY=1
    check 'vectors: none with another compiler' settles GJK_VECTORS 0 "$compiler" -U__GNUC__
    ;;
esac
for cross in arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc; do
  if have $cross; then check "vectors: none with $cross" settles GJK_VECTORS 0 $cross; fi
done

check 'the template of allocation' compiles port/template/gjk_template.c
finish config
