#!/bin/sh
# What a query costs on the host, by family of pairs: bench-cost.sh BUILD [PAIRS [REPETITIONS [DIR]]]; 1000, 15 and
# BUILD/bench by default.
#
# Instructions and branch mispredictions by callgrind, which repeat exactly, if valgrind is installed; then times, all
# methods in turn in one process, of each 50 pairs the least of the repetitions. Warm and cold, posing included and
# apart. Other libraries are measured too if their Debian packages are installed (WITHOUT_PEERS=1: not even then).
# Writes DIR/cost.csv.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
pairs=${2:-1000}
repetitions=${3:-15}
dir=${4:-$build/bench}
mkdir -p "$dir"
find_cost_peers >&2

make -s "$build/gjk-cost" BENCH_PEERS="$peers" >"$dir/make.log" 2>&1 || { cat "$dir/make.log"; exit 1; }
program=$build/gjk-cost

: >"$dir/counted.csv"
if have valgrind; then
  echo "instructions: $pairs pairs of each family under callgrind" >&2
  counted "$pairs" "$dir" --branch-sim=yes "$program" --pairs "$pairs" --count 1 >"$dir/counted.csv" || exit 1
else
  skip 'instructions and branch mispredictions' valgrind
fi

echo "times: $pairs pairs of each family, $repetitions times" >&2
# A library that does not come back must not hold this up for ever.
timeout $((60 + pairs * repetitions / 5)) "$program" --pairs "$pairs" --repetitions "$repetitions" >"$dir/timed.csv" || exit 1
cat "$dir/timed.csv" "$dir/counted.csv" >"$dir/cost.csv"

echo "$pairs pairs a family; $("${CC:-cc}" --version | head -n 1) -O2; $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)"
for peer in $peers; do
  echo "$peer $(pkg-config --modversion "$peer"), as Debian builds it"
done
if [ -n "$peers" ]; then
  cat <<'END'
settings: scans over all vertices, or (FCL) climbing along the edges of corners with faces; boxes, capsules and spheres are
each library's own; Bullet: margins 0, yes-or-no questions end once apart, warm by the last axis; FCL: warm by its guess,
no closed form left out; libccd: support functions written for it, vertices posed beforehand where posing is apart;
tolerances as each sets them. Of several methods of a library the cheapest that answers right counts.
END
fi
awk -F, -f tests/build/bench-cost.awk "$dir/cost.csv"
echo
echo "every figure: $dir/cost.csv"
