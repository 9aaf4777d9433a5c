#!/bin/sh
# What queries in the plane cost on the host, other libraries beside them: bench-plane.sh BUILD [PAIRS [REPETITIONS]];
# 1000 and 15 by default.
#
# Instructions by callgrind, which repeat exactly, if valgrind is installed; then times, all methods in turn in one
# process, of each 50 pairs the least of the repetitions. Shapes are posed beforehand, caches are cold. Box2D and
# Chipmunk2D are measured if their Debian packages are installed (WITHOUT_PEERS=1: not even then). Writes
# BUILD/bench/plane.csv.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
pairs=${2:-1000}
repetitions=${3:-15}
dir=$build/bench
mkdir -p "$dir"
find_plane_peers >&2

make -s build/gjk-plane PLANE_PEERS="$plane_peers" >"$dir/plane.log" 2>&1 || { cat "$dir/plane.log"; exit 1; }
: >"$dir/plane.counted"
if have valgrind; then
  counted "$pairs" "$dir" --branch-sim=no build/gjk-plane count "$pairs" >"$dir/plane.counted" || exit 1
else
  skip 'instructions in the plane' valgrind
fi
timeout $((60 + pairs * repetitions / 50)) build/gjk-plane costs "$pairs" "$repetitions" >"$dir/plane.timed" || exit 1
cat "$dir/plane.timed" "$dir/plane.counted" >"$dir/plane.csv"

echo "in the plane: $pairs pairs a family, shapes posed beforehand, nothing remembered; ns of others in parts of gjk2's"
echo "polygon radii 0 throughout; Box2D in float, its answers at 10 epsilons or at 0; Chipmunk2D and the reference in double"
awk -F, '
  { value[$1, $2, $3] = $4 }
  $3 == "sum" && !(($1) in seen) { seen[$1]; family[++families] = $1 }
  $3 == "sum" && $2 != "nothing" && !(($2) in known) { known[$2]; method[++methods] = $2 }
  function cost(f, m, measure) { return value[f, m, measure] - value[f, "nothing", measure] }
  END {
    for (f = 1; f <= families; f++) {
      of = family[f]
      printf "\n%-34s%14s%10s\n", of, "instructions", "ns"
      for (i = 1; i <= methods; i++) {
        by = method[i]
        if (!((of, by, "ns") in value)) continue
        off = value[of, by, "sum"] / value[of, "gjk", "sum"] - 1
        printf "  %-32s%14s", by, (of, by, "instructions") in value ? sprintf("%.0f", cost(of, by, "instructions")) : "-"
        printf by == "gjk" ? "%10.0f" : "%10.2f", by == "gjk" ? cost(of, by, "ns") : cost(of, by, "ns") / cost(of, "gjk", "ns")
        printf "%s\n", (off > 0.01 || off < -0.01) ? sprintf("   its sum of answers is off by %.1f %%", 100 * off) : ""
      }
    }
  }' "$dir/plane.csv"
echo
echo "every figure: $dir/plane.csv"
