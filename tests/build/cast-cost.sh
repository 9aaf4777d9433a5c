#!/bin/sh
# The README's table of what casts and times of impact cost on emulated cores: cast-cost.sh BUILD [TARGET...]
# Instructions, mean of 200 casts or rays, in the plane of 1,000, of 50 times of impact of hulls. Every family:
# tests/measure/target/cast_bench.c, plane_bench.c; times of impact are those that bench-target.sh BUILD has counted.
. tests/build/count.sh
build=$1
shift
[ $# -gt 0 ] || set -- cortex-m0 cortex-m3
variant=$(variant_of "$build")
for target in "$@"; do
  {
    count_on_core "$target" cast_bench "$variant" &&
      count_on_core "$target" plane_bench "$variant" | sed 's/^/in the plane: /' &&
      sed -n 's/^gjk|//p' "$build/bench/$target.txt"
  } | sed "s/^/$target|/" || exit 1
done >"$build/cast-cost.txt"
awk -v head='cast or ray' -v rows='ray misses 8-point hull by the spheres;ray passes 8-point hull;ray hits 8-point hull;8-point hulls pass;8-point hulls hit;boxes pass;boxes hit;ball hits box;8-point hulls that turn: impact;in the plane: boxes apart: cast;in the plane: 8-gons apart: cast;in the plane: 8-gon: ray;in the plane: 8-gons apart: impact, turning' \
  -f tests/build/grouped.awk -f tests/build/cost-table.awk "$build/cast-cost.txt"
