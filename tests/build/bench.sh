#!/bin/sh
# Cost, and run time against error, on the host: bench.sh BUILD [SECONDS [PAIRS]]; 60 seconds and 1000 pairs by default.
#
# First what queries cost (bench-cost.sh), in the plane too (bench-plane.sh); then each method's error and time on families that are easy and hard, for
# SECONDS. Other libraries are measured too if their Debian packages are installed, and instructions are counted if
# valgrind is. Writes BUILD/bench.csv and BUILD/bench.html, and prints the same figures.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
seconds=${2:-60}
pairs=${3:-1000}
dir=$build/bench
mkdir -p "$dir"

sh tests/build/bench-cost.sh "$build" "$pairs" || exit 1
echo
sh tests/build/bench-plane.sh "$build" "$pairs" || exit 1

echo
echo 'run time against error'
find_peer ccd libccd libccd-dev
find_peer bullet Bullet libbullet-dev
find_peer fcl FCL libfcl-dev

rm -f "$build/gjk-bench"
make -s "$build/gjk-bench" BENCH_PEERS="$peers" >"$dir/make.log" 2>&1 ||
  { cat "$dir/make.log"; exit 1; }

pairs_counted=20
: >"$dir/instructions.csv"
if have valgrind; then
  echo "instructions: one pass over $pairs_counted pairs of each family under callgrind" >&2
  counted $pairs_counted "$dir" --branch-sim=no "$build/gjk-bench" --pairs $pairs_counted --instructions 1 >"$dir/counted.csv" || exit 1
  sed 's/,instructions,/&,/' "$dir/counted.csv" >"$dir/instructions.csv"
else
  skip 'instructions per query' valgrind
fi

about() {
  echo ",,,about,,$pairs pairs a family; 100 of them timed; medians of interleaved repetitions for $seconds s; each method warmed up by a pass of its own"
  echo ",,,about,,$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)"
  echo ",,,about,,$(${CC:-cc} --version | head -n 1) -O2; other libraries as Debian builds them"
  for peer in $peers; do
    echo ",,,about,,$peer $(pkg-config --modversion "$peer")"
  done
  echo ",,,about,,Every method gets the same posed integers: gjk and the reference as they are; the others in" \
    "units, vertices about a centre, boxes as hulls of 8 points. Tolerances as each library sets them, margins 0 or the" \
    "rounding; Bullet's box-box gets boxes with right angles."
}

# A library that does not come back must not hold this up for ever.
timeout $((seconds + pairs / 2 + 300)) "$build/gjk-bench" --pairs "$pairs" --seconds "$seconds" >"$dir/run.csv" || exit 1
{ cat "$dir/run.csv" "$dir/instructions.csv"; about; } >"$build/bench.csv"
scenes=$build/bench-scene.csv  # of make bench-scene, if that was run
[ -f "$scenes" ] || scenes=
echo "figures: $build/bench.csv"
if have python3; then
  python3 -B tests/measure/bench/report/report.py "$build/bench.csv" "$build/bench.html" ${scenes:+"$scenes"} || exit 1
  echo "page: $build/bench.html"
else
  skip 'tables and the page' python3
fi
