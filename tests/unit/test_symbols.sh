#!/bin/sh
# What the objects ask of their surroundings: nothing on Cortex-M3 and up; elsewhere the compiler's integer helpers
# below; no data that changes anywhere. test_symbols.sh BUILD
. tests/build/count.sh

# Each helper with its reason.
allowed() {
  case $1 in
    # 64-bit products and shifts, for which ARMv6-M has no instruction
    cortex-m0) echo '__aeabi_lmul __aeabi_llsl __aeabi_llsr __aeabi_lasr' ;;
    # 64-bit products and shifts, for which RV32 has none; GCC 12 calls memcpy for small structures at -Os
    rv32imc) echo '__muldi3 __ashldi3 __lshrdi3 __ashrdi3 memcpy' ;;
  esac
}

# undefined OBJECTS: symbols that no object of the library defines
undefined() {
  nm=$1
  shift
  "$nm" "$@" | awk 'NF == 2 && $1 == "U" { wanted[$2] } NF == 3 { defined[$3] } END { for (s in wanted) if (!(s in defined)) print s }'
}

only_allowed() {
  target=$1
  for symbol in $(undefined "$2" "build/$target$3"/*.o); do
    case " $(allowed "$target") " in
      *" $symbol "*) ;;
      *) echo "$target$3 needs $symbol"; bad=1 ;;
    esac
  done
  [ -z "$bad" ]
}

no_mutable_data() {
  "$1" "build/$2$3"/*.o | awk '$2 + 0 > 0 && $1 != "text" { print "data in " $6; bad = 1 } $3 + 0 > 0 { print "bss in " $6; bad = 1 } END { exit bad }'
}

for target in cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc; do
  case $target in
    rv32imc) prefix=riscv64-unknown-elf- ;;
    *) prefix=arm-none-eabi- ;;
  esac
  if [ -n "$(missing_package $target)" ]; then
    skip "symbols of $target" "$(missing_package $target)"
    continue
  fi
  for level in -O2 -Os; do
    check "$target $level compiles" make -s lib TARGET=$target OPT=$level VARIANT=$level
    check "$target $level needs nothing unlisted" only_allowed $target ${prefix}nm $level
    check "$target $level has no mutable data" no_mutable_data ${prefix}size $target $level
  done
done
finish symbols
