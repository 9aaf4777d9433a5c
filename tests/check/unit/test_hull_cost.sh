#!/bin/sh
# What hulls of points on a sphere take on an emulated Cortex-M3: instructions, of 64 points at most 400,000. test_hull_cost.sh BUILD
. tests/build/count.sh
build=$1

# at_most POINTS INSTRUCTIONS
at_most() {
  awk -v points="$1" -v most="$2" '
    $3 == points { found = 1; print; if ($7 + 0 <= 0 || $7 > most) bad = 1 }
    END { exit bad || !found }' "$build/hull_cost.txt"
}

lacking="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -z "${lacking# }" ]; then
  library cortex-m3 '' OPT=-O2 && make -s build/cortex-m3/hull_bench.elf TARGET=cortex-m3 >/dev/null
  check 'hulls are built' sh -c "sh tests/build/emulate.sh cortex-m3 build/cortex-m3/hull_bench.elf >$build/hull_cost.txt"
  # What src/README.md says, and 5 % more.
  check '16 points' at_most 16 46000
  check '64 points' at_most 64 265000
  check '256 points' at_most 256 1310000
else
  skip 'instructions of hulls' "$lacking"
fi
finish 'hull cost'
