#!/bin/sh
# Instructions per query on emulated cores, cold, mean and worst of 50 random pairs: bench-target.sh BUILD [TARGET...]
. tests/build/count.sh
build=$1
shift
[ $# -gt 0 ] || set -- cortex-m0 cortex-m3 cortex-m4 rv32imc
results=$build/bench
mkdir -p "$results"
rm -f "$results"/*.txt

for target in "$@"; do
  missing="$(missing_package "$target") $(missing_emulator "$target")"
  if [ -n "${missing# }" ]; then
    echo "no figures for $target: needs$missing" >&2
    continue
  fi
  make -s "build/$target/bench.elf" TARGET="$target" >/dev/null || exit 1
  sh tests/build/emulate.sh "$target" "build/$target/bench.elf" >"$results/$target.txt" ||
    { cat "$results/$target.txt" >&2; exit 1; }
done

ls "$results"/*.txt >/dev/null 2>&1 || exit 1
awk -F'|' '
  FNR == 1 { target[++targets] = FILENAME; sub(/.*\//, "", target[targets]); sub(/\.txt$/, "", target[targets]) }
  { if (!($1 in mean)) name[++names] = $1; mean[$1]; at = $1 SUBSEP targets; m[at] = $2; w[at] = $3; stack[at] = $6
    rounds[$1] = $4 / 100; most[$1] = $5 }
  END {
    printf "%-40s%-14s", "instructions per query: mean (worst)", "rounds"
    for (t = 1; t <= targets; t++) printf "%18s", target[t]
    printf "\n"
    for (n = 1; n <= names; n++) {
      printf "%-40s%-14s", name[n], sprintf("%.2f (%d)", rounds[name[n]], most[name[n]])
      for (t = 1; t <= targets; t++) printf "%18s", m[name[n], t] " (" w[name[n], t] ")"
      printf "\n"
    }
    printf "%-40s%-14s", "bytes of stack used, most", ""
    for (t = 1; t <= targets; t++) {
      deepest = 0
      for (n = 1; n <= names; n++) if (stack[name[n], t] + 0 > deepest) deepest = stack[name[n], t] + 0
      printf "%18s", deepest
    }
    printf "\n"
  }' "$results"/*.txt
