#!/bin/sh
# The most expensive pairs that a search finds: worst-case.sh BUILD [SEED [ITERATIONS [INSTRUCTIONS]]]
#
# For each family it makes so many measurements on the host, of iterations and of the work between them, then of
# instructions on an emulated Cortex-M3. A pair that costs more than one of tests/data/worst.txt replaces it there.
# Then it searches the plane: all pairs of polygons on a lattice, of which it prints the most iterations.
# With 'replay' instead of a SEED it only counts the known pairs afresh, prints 'ID|iterations|instructions' and
# changes nothing.
. tests/build/count.sh
build=$1
seed=${2:-1}
on_host=${3:-2000000}
on_target=${4:-20000}
data=tests/data/worst.txt
dir=$build/worst
elf=build/cortex-m3/worst.elf
mkdir -p "$dir"

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -n "${missing# }" ]; then
  echo "skipped: the search on Cortex-M3: needs $missing" >&2
  exit 1
fi

# firmware DEFINE...: runs it on the cases of $dir/known.txt
firmware() {
  awk -f tests/build/worst-cases.awk "$dir/known.txt" >"$build/worst_cases.c" || return 1
  rm -f "$elf"
  library cortex-m3 '' OPT=-O2 || return 1
  make -s "$elf" TARGET=cortex-m3 WORST_CASES="$build/worst_cases.c" FIRMWARE_DEFINES="$*" \
    >"$dir/log" 2>&1 || { cat "$dir/log" >&2; return 1; }
  sh tests/build/emulate.sh cortex-m3 "$elf"
}

# annotate FILE: its cases with the figures of a fresh replay
annotate() {
  cp "$1" "$dir/known.txt"
  firmware >"$dir/replay" || { cat "$dir/replay" >&2; return 1; }
  awk -F'|' '
    FNR == NR { line[$1] = "# iterations " $2 " instructions " $3; next }
    /^# iterations / { next }
    { print }
    /^case / { split($0, word, " "); print line[word[2]] }' "$dir/replay" "$1" >"$dir/annotated" &&
    cp "$dir/annotated" "$1"
}

if [ "$seed" = replay ]; then
  cp $data "$dir/known.txt"
  firmware
  exit
fi

sed -n '/^case /q; p' $data >"$dir/head"
sed -n '/^case /,$p' $data >"$dir/found.txt"
make -s build/host/libgjk.a build/hosted/port/hosted/gjk_hosted.o >/dev/null && annotate "$dir/found.txt" || exit 1
"${CC:-cc}" -O2 -std=c99 -Iinclude -I. -Itests/support tests/measure/target/worst.c tests/measure/target/worst_host.c "$build/worst_cases.c" \
  -Itests/support build/host/libgjk.a build/hosted/port/hosted/gjk_hosted.o -o "$dir/worst_host" || exit 1
families=$(grep -o '"[a-z0-9]*-[a-z]*", .kind = WORST_' tests/measure/target/worst.c | wc -l)

family=0
while [ $family -lt "$families" ]; do
  "$dir/worst_host" $family "$seed" "$on_host" >"$dir/one.txt" || exit 1
  sed -n 's/^case //p; s/^#//p' "$dir/one.txt" | paste -s -d ' '
  awk -f tests/build/worst-merge.awk "$dir/found.txt" "$dir/one.txt" >"$dir/merged.txt"
  cp "$dir/merged.txt" "$dir/found.txt"
  family=$((family + 1))
done
annotate "$dir/found.txt" || exit 1

family=0
while [ $family -lt "$families" ]; do
  cp "$dir/found.txt" "$dir/known.txt"
  firmware "-DWORST_FAMILY=$family" "-DWORST_SEED=$seed" "-DWORST_MEASUREMENTS=$on_target" >"$dir/one.txt" || exit 1
  sed -n 's/^case //p; s/^#//p' "$dir/one.txt" | paste -s -d ' '
  awk -f tests/build/worst-merge.awk "$dir/found.txt" "$dir/one.txt" >"$dir/merged.txt"
  cp "$dir/merged.txt" "$dir/found.txt"
  family=$((family + 1))
done
annotate "$dir/found.txt" && cat "$dir/head" "$dir/found.txt" >$data || exit 1

make -s build/test_plane_lattice >/dev/null && build/test_plane_lattice 4 1 8
