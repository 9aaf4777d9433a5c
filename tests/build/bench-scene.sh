#!/bin/sh
# Cost of a scene's tick: instructions on an emulated Cortex-M4, then time on this machine into BUILD/bench-scene.csv; then
# scenes at rest and falling, with all contacts, into BUILD/rest/rest.csv. bench-scene.sh BUILD [rest]: only those.
. tests/build/count.sh
. tests/build/peers.sh
build=$1

# Poses are recorded once, by the project's own solvers: BUILD/rest/*.poses.
rest() {
  dir=$build/rest
  mkdir -p "$dir"
  make -s "$build/gjk-rest" BENCH_PEERS="$peers" >"$dir/make.log" 2>&1 || { cat "$dir/make.log"; return 1; }
  [ -n "$(find "$dir" -name recorded -newer "$build/gjk-rest")" ] || { "$build/gjk-rest" record "$dir" && : >"$dir/recorded"; } || return 1
  "$build/gjk-rest" time "$dir" >"$dir/rest.csv" || return 1
  if have valgrind; then
    counted 20 "$dir" --branch-sim=yes "$build/gjk-rest" count "$dir" >"$dir/rest.counted" || return 1
    sed 's/,\([a-z]*\),\([0-9.]*\)$/;\1;\2/' "$dir/rest.counted" >>"$dir/rest.csv"
  else
    skip 'instructions and branch mispredictions' valgrind
  fi
  awk -F';' '
    function number(x) { return x == "" ? "-" : sprintf("%.1f", x / 1000) }
    BEGIN { n = 0 }
    !(($1, $2) in seen) { seen[$1, $2] = 1; scene[n] = $1; method[n++] = $2 }
    { of[$1, $2, $3] = $4 }
    END {
      printf "%-32s%-22s%10s%18s%18s\n", "a tick, in thousands", "", "ns", "instructions", "mispredictions"
      for (i = 0; i < n; i++) {
        printf "%-32s%-22s%10s%18s%18s   %s\n", scene[i], method[i], number(of[scene[i], method[i], "ns"]),
          number(of[scene[i], method[i], "instructions"]), number(of[scene[i], method[i], "mispredictions"]),
          of[scene[i], method[i], "found"]
      }
    }' "$dir/rest.csv"
  echo 'CPU time: medians of 15 passes over 20 ticks, all methods in turn in one process. All of it: '"$dir/rest.csv"
}

if [ "$2" = rest ]; then
  find_peer bullet Bullet libbullet-dev
  find_peer ode ODE libode-dev
  rest
  exit
fi
missing="$(missing_package cortex-m4) $(missing_emulator cortex-m4)"
if [ -n "${missing# }" ]; then
  echo "no figures for Cortex-M4: needs $missing"
else
  count_on_core cortex-m4 scene_bench '' >"$build/bench-scene-m4.txt" || exit 1
  awk -F'|' '
    BEGIN { printf "%-36s%10s%10s%28s\n", "instructions per tick, Cortex-M4", "mean", "worst", "pairs, of them queried" }
    { printf "%-36s%10d%10d%20d %7d\n", $1, $2, $3, $4, $9 + $10 }' "$build/bench-scene-m4.txt"
fi
echo

# Other libraries' broad phases beside it, where they are installed.
find_peer bullet Bullet libbullet-dev
find_peer fcl FCL libfcl-dev
find_peer ode ODE libode-dev
rm -f "$build/scene-bench"
make -s "$build/scene-bench" BENCH_PEERS="$peers" >"$build/bench-scene.log" 2>&1 ||
  { cat "$build/bench-scene.log"; exit 1; }

"$build/scene-bench" >"$build/bench-scene.csv" || exit 1
echo 'CPU time in microseconds a tick, medians over repetitions of 10 ticks, all methods on the same motion in one process.'
echo 'whole: moves with posing, tree, pairs, exact answers. broad: moves with posing, tree, pairs; no pair tested. posing:'
echo 'the bodies that changed, and their boxes; it is in whole and broad, but not in Bullet and FCL, which get the boxes'
echo 'ready made, nor in all boxes.'
awk -F, '
  function us(ns) { return ns == "" ? "-" : sprintf("%.1f", ns / 1000) }
  NR == 1 { printf "%-10s%7s%9s%11s%11s%9s%11s%11s%12s\n", "scene", "bodies", "% moving", "whole", "broad", "posing",
    "Bullet", "FCL", "all boxes"; next }
  { printf "%-10s%7d%9d%11s%11s%9s%11s%11s%12s\n", $1, $2, $3, us($4), us($5), us($6), us($7), us($8), us($9) }
' "$build/bench-scene.csv"
echo
echo '10,000 bodies, 5 % moving: how many times as long as the library takes'
awk -F, '
  function times(x, y) { return x == "" ? "-" : sprintf("%.2f", x / y) }
  NR == 1 { printf "%-10s%18s%16s%16s%14s%14s\n", "scene", "all boxes/whole", "Bullet/whole", "Bullet/broad", "FCL/whole",
    "FCL/broad" }
  $2 == 10000 && $3 == 5 {
    printf "%-10s%18s%16s%16s%14s%14s\n", $1, times($9, $4), times($7, $4), times($7, $5), times($8, $4), times($8, $5)
  }' "$build/bench-scene.csv"
echo
rest || exit 1
echo "all of it: $build/bench-scene.csv; plots: make bench, or again with its figures of before: $build/bench.html"
if [ -f "$build/bench.csv" ] && have python3; then
  python3 -B tests/measure/bench/report/report.py "$build/bench.csv" "$build/bench.html" "$build/bench-scene.csv" >/dev/null
fi
