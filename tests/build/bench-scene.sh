#!/bin/sh
# Cost of a scene's tick: instructions on an emulated Cortex-M4, then time on this machine into BUILD/bench-scene.csv.
# bench-scene.sh BUILD
. tests/build/count.sh
build=$1
missing="$(missing_package cortex-m4) $(missing_emulator cortex-m4)"
if [ -n "${missing# }" ]; then
  echo "no figures for Cortex-M4: needs $missing"
else
  make -s build/cortex-m4/scene_bench.elf TARGET=cortex-m4 >/dev/null || exit 1
  sh tests/build/emulate.sh cortex-m4 build/cortex-m4/scene_bench.elf >"$build/bench-scene-m4.txt" || exit 1
  awk -F'|' '
    BEGIN { printf "%-36s%10s%10s%28s\n", "instructions per tick, Cortex-M4", "mean", "worst", "pairs, of them queried" }
    { printf "%-36s%10d%10d%20d %7d\n", $1, $2, $3, $4, $9 + $10 }' "$build/bench-scene-m4.txt"
fi
echo
"$build/scene-bench" >"$build/bench-scene.csv" || exit 1
awk -F, '
  NR == 1 { printf "%-12s%8s%10s%14s%16s%10s%10s\n", "scene", "bodies", "% moving", "us a tick", "us all boxes", "faster",
    "% resting"; next }
  { printf "%-12s%8d%10d%14.1f%16.1f%10.1f%10.1f\n", $1, $2, $3, $4 / 1000, $5 / 1000, $6, $9 }' "$build/bench-scene.csv"
echo "all of it: $build/bench-scene.csv"
