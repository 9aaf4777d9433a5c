#!/bin/sh
# The README's table of what queries in the plane cost on emulated cores: plane-cost.sh BUILD [TARGET...]
# Instructions without a cache, mean of 1,000 random pairs; every family: tests/measure/target/plane_bench.c.
. tests/build/count.sh
build=$1
shift
[ $# -gt 0 ] || set -- cortex-m0 cortex-m3
variant=$(variant_of "$build")
for target in "$@"; do
  make -s "build/$target$variant/plane_bench.elf" TARGET="$target" VARIANT="$variant" >/dev/null || exit 1
  sh tests/build/emulate.sh "$target" "build/$target$variant/plane_bench.elf" | sed "s/^/$target|/" || exit 1
done >"$build/plane-cost.txt"
awk -f tests/build/grouped.awk -f tests/build/plane-cost.awk "$build/plane-cost.txt"
