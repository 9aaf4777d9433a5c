#!/bin/sh
# The README's table of what queries in the plane cost on emulated cores: plane-cost.sh BUILD [TARGET...]
# Instructions without a cache, mean of 1,000 random pairs; every family: tests/measure/target/plane_bench.c.
. tests/build/count.sh
build=$1
shift
[ $# -gt 0 ] || set -- cortex-m0 cortex-m3
variant=$(variant_of "$build")
for target in "$@"; do
  count_on_core "$target" plane_bench "$variant" | sed "s/^/$target|/" || exit 1
done >"$build/plane-cost.txt"
awk -v head=query -v rows='boxes apart: distance;8-gons apart: distance;8-gons close: intersect;8-gons overlapping: depth;8-gons face to face: contacts' \
  -f tests/build/grouped.awk -f tests/build/cost-table.awk "$build/plane-cost.txt"
