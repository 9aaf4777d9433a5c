#!/bin/sh
# The README's tables of costs, and those of tests/measure/README.md, must be what a fresh count on Cortex-M3 gives. test_readme_figures.sh BUILD
. tests/build/count.sh

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
compiler=$(sed -n '/emulated cores, GCC /{s/.*, GCC \([0-9]*\.[0-9]*\) at -O2.*/\1/p;q;}' tests/measure/README.md)
check 'the tables name their compiler' test -n "$compiler"
if [ -z "${missing# }" ]; then
  case $(arm-none-eabi-gcc -dumpversion) in
    "$compiler".*) check 'the figures of Cortex-M3' sh tests/build/readme-figures.sh "$1" cortex-m3 ;;
    *) skip 'the figures of Cortex-M3' "gcc-arm-none-eabi $compiler, whose figures they are" ;;
  esac
else
  skip 'the figures of Cortex-M3' "$missing"
fi
finish readme_figures
