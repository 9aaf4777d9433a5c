#!/bin/sh
# What a query costs on the emulated cores, beside the reference in float and double: bench-target.sh BUILD [TARGET...]
#
# Instructions without a cache, mean and worst of 50 random pairs (1,000 of a skewed family); stack, painted and by the
# call graph of the compiler; the most workspace that the pairs need; linked code. All figures go to
# BUILD/bench/target.csv, one a line: TARGET,SOLVER,SUBJECT,MEASURE,FIGURE
. tests/build/count.sh
build=$1
shift
[ $# -gt 0 ] || set -- cortex-m0 cortex-m3 cortex-m4 cortex-m4-fpu cortex-m7 cortex-m7-fpu cortex-m33 rv32imc
variant=$(variant_of "$build")
csv=$build/bench/target.csv
mkdir -p "$build/bench"

# Instructions, iterations or contacts, painted stack, workspace.
count() {
  make -s "build/$1$variant/bench.elf" TARGET="$1" VARIANT="$variant" >/dev/null || return 1
  sh tests/build/emulate.sh "$1" "build/$1$variant/bench.elf" >"$build/bench/$1.txt" ||
    { cat "$build/bench/$1.txt" >&2; return 1; }
  awk -F'|' -v target="$1" '
    function row(subject, measure, figure) { print target "," $1 "," subject "," measure "," figure }
    {
      group = $2 ~ /: depth$/ ? "gjk_penetration" : $2 ~ /: contacts$/ ? "gjk_contacts" : $2 ~ /: impact$/ ? "gjk_time_of_impact" : "any query"
      row($2, "mean instructions", $3)
      row($2, "worst instructions", $4)
      row($2, group == "gjk_contacts" ? "mean contacts" : "mean iterations", sprintf("%.1f", $5 / 100))
      row($2, group == "gjk_contacts" ? "most contacts" : "most iterations", $6)
      if ((group == "gjk_penetration" || group == "gjk_contacts") && $1 == "gjk") row($2, "workspace", $8)
      if ($7 + 0 > deepest[$1 "," group] + 0) deepest[$1 "," group] = $7
    }
    END { for (group in deepest) print target "," group ",painted stack," deepest[group] }
  ' "$build/bench/$1.txt"
}

# What the queries need at most by the compiler's call graph.
stack() {
  awk -v roots='gjk_intersect gjk_within gjk_distance gjk_penetration gjk_contacts gjk_time_of_impact' -f tests/build/stack.awk \
    tests/build/indirect-calls.txt "build/$1$variant"/*.ci | awk -v target="$1" '
    /^gjk_(penetration|contacts|time_of_impact) / { print target ",gjk," $1 ",stack bound," $2; next }
    $2 > deepest { deepest = $2 }
    END { print target ",gjk,any query,stack bound," deepest }'
}

# code TARGET SOLVER SUBJECT MACRO...
code() {
  echo "$1,$2,$3,code,$(shift 3; sh tests/build/linked-size.sh "$build" "$target" "$@")"
}

# For cores without floating point in hardware.
codes() {
  library "$1" "$variant-Os" OPT=-Os &&
    code "$1" gjk 'gjk_intersect: boxes' -DSIZE_BOXES &&
    code "$1" gjk 'gjk_intersect: boxes; with posing' -DSIZE_BOXES -DSIZE_POSED &&
    code "$1" gjk 'gjk_distance: boxes and hulls; rounded' -DSIZE_HULLS &&
    code "$1" gjk 'gjk_distance: boxes and hulls; rounded; with posing' -DSIZE_POSED &&
    code "$1" gjk 'gjk_distance: every shape; with posing' -DSIZE_POSED -DSIZE_CURVED &&
    code "$1" gjk 'gjk_penetration: boxes and hulls; rounded' -DSIZE_HULLS -DSIZE_DEPTH &&
    code "$1" gjk 'gjk_penetration: boxes and hulls; rounded; with posing' -DSIZE_POSED -DSIZE_DEPTH &&
    code "$1" gjk 'gjk_contacts: boxes and hulls; rounded' -DSIZE_HULLS -DSIZE_CONTACTS &&
    code "$1" gjk 'gjk_contacts: boxes and hulls; rounded; with posing' -DSIZE_POSED -DSIZE_CONTACTS &&
    code "$1" gjk 'gjk_time_of_impact: boxes and hulls; rounded' -DSIZE_POSED -DSIZE_IMPACT &&
    code "$1" float 'reference: boxes and hulls' float &&
    code "$1" double 'reference: boxes and hulls' double
}

measured=
for target in "$@"; do
  missing="$(missing_package "$target") $(missing_emulator "$target")"
  if [ -n "${missing# }" ]; then
    echo "skipped: figures of $target: needs $missing" >&2
    continue
  fi
  echo "  $target" >&2
  count "$target" && stack "$target" || exit 1
  case $target in
    *-fpu) ;;
    *) codes "$target" || exit 1 ;;
  esac
  measured="$measured $target"
done >"$csv.part"
[ -s "$csv.part" ] || exit 1
mv "$csv.part" "$csv"
awk -f tests/build/bench-target.awk "$csv"
echo
echo "every figure: $csv"
