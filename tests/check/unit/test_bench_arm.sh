#!/bin/sh
# Edges of an arm beside other libraries, at their smallest: the library misses no touch. test_bench_arm.sh BUILD
build=$1
dir=$build/bench-arm-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

edges() {
  sh tests/build/bench-arm.sh "$dir" 8 1 >"$dir/edges.md"
}

check 'edges' edges
check 'two families, by the edge and by samples' test "$(grep -c '^| [a-z]* | gjk; ' "$dir/edges.md")" = 4
check 'no touch is missed' test "$(grep -c '^| [a-z]* | gjk; the whole edge | 0 of ' "$dir/edges.md")" = 2
check 'each edge is free or touches' awk -F, '$3 + $5 != 8 { exit 1 }' "$dir/bench/arm.csv"
finish bench_arm
