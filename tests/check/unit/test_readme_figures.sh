#!/bin/sh
# The README's tables of costs, and those of tests/measure/README.md, must be what a fresh count on Cortex-M3 gives. test_readme_figures.sh BUILD
. tests/build/count.sh

# as_they_are TARGET SUFFIX LEVEL: the figures are built in folders of their own; they begin with the objects that there are.
as_they_are() {
  library "$1" "$2" "OPT=$3" && rm -rf "build/$1-figures$2" && cp -a "build/$1$2" "build/$1-figures$2"
}

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
compiler=$(sed -n '/emulated cores, GCC /{s/.*, GCC \([0-9]*\.[0-9]*\) at -O2.*/\1/p;q;}' tests/measure/README.md)
check 'the tables name their compiler' test -n "$compiler"
if [ -z "${missing# }" ]; then
  case $(arm-none-eabi-gcc -dumpversion) in
    "$compiler".*)
      check 'the libraries, as they are' as_they_are cortex-m3 '' -O2
      check 'and at -Os' as_they_are cortex-m3 -Os -Os
      check 'the figures of Cortex-M3' sh tests/build/readme-figures.sh "$1" cortex-m3
      ;;
    *) skip 'the figures of Cortex-M3' "gcc-arm-none-eabi $compiler, whose figures they are" ;;
  esac
else
  skip 'the figures of Cortex-M3' "$missing"
fi
finish readme_figures
