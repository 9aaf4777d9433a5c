#!/bin/sh
# The figures that are counted, of README.md, tests/measure/README.md and port/README.md: readme-figures.sh BUILD [TARGET]
#
# Writes the tables between the marks '<!-- figures: NAME -->' and '<!-- end -->' from a fresh count on every target. With a
# TARGET it counts on that one alone, compares the columns for it, the table of the most expensive pairs, and this library's
# and the reference's columns of wrong decisions in space and in the plane, and changes nothing. test_size.sh compares the
# sizes of whole programs.
pages='README.md tests/measure/README.md port/README.md'
build=$1
target=$2
figures=$build/figures
mkdir -p "$figures"

# shellcheck disable=SC2086
if ! sh tests/build/bench-target.sh "$figures" $target >"$figures/log" 2>&1 || grep -q '^skipped' "$figures/log"; then
  cat "$figures/log" >&2
  exit 1
fi
awk -f tests/build/grouped.awk -f tests/build/readme-figures.awk "$figures/bench/target.csv" >"$figures/cost"
sh tests/build/worst-case.sh "$figures" replay >"$figures/replay" || exit 1
awk -f tests/build/grouped.awk -f tests/build/readme-ceiling.awk "$figures/replay" >"$figures/ceiling"

# Wrong decisions, without other libraries where only those of Cortex-M3 are compared.
WITHOUT_PEERS=$target sh tests/build/decisions.sh "$build" >"$figures/decisions" || exit 1
WITHOUT_PEERS=$target sh tests/build/plane-decisions.sh "$build" >"$figures/plane" || exit 1
# shellcheck disable=SC2086
sh tests/build/plane-cost.sh "$build" $target >"$figures/planecost" || exit 1
# shellcheck disable=SC2086
sh tests/build/cast-cost.sh "$figures" $target >"$figures/castcost" || exit 1

# shown NAME: the table of that name.
shown() {
  # shellcheck disable=SC2086
  cat $pages | sed -n "/^<!-- figures: $1 -->\$/,/^<!-- end -->\$/{/^|/p;}"
}

# Some rows of the table of costs, of two cores at most, without the worst.
awk -F' *[|] *' '
  !/^[|]/ { exit }
  NR == 1 { for (i = 2; i < NF; i++) if ($i == "Cortex-M0" || $i == "Cortex-M3") column[++count] = i }
  NR <= 2 || $2 ~ /^(boxes apart: distance|8-point hulls (close: intersect|overlapping: depth)|boxes face to face: contacts|stack of (intersect|gjk_contacts).*|code, bytes: gjk_distance: every.*)$/ {
    line = "| " $2
    for (i = 1; i <= count; i++) line = line " | " $(column[i])
    gsub(/ \([0-9,]*\)|, by the call graph \(used\)|, by the call graph/, "", line)
    print NR == 2 ? substr("|---|---|---|", 1, 4 * count + 5) : line " |"
  }' "$figures/cost" >"$figures/short"

if [ -z "$target" ]; then
  sh tests/build/sizes-kinds.sh "$build" && cp "$build/linked/kinds" "$build/linked/planekinds" "$figures" || exit 1
  if [ "$(head -n 1 "$figures/decisions" | tr -cd '|' | wc -c)" -lt 7 ]; then
    echo 'the table of decisions stays: libccd-dev, libfcl-dev and libbullet-dev are needed' >&2
    shown decisions >"$figures/decisions"
  fi
  if [ "$(head -n 1 "$figures/plane" | tr -cd '|' | wc -c)" -lt 6 ]; then
    echo 'the table of decisions in the plane stays: libbox2d-dev and libchipmunk-dev are needed' >&2
    shown plane >"$figures/plane"
  fi
  for page in $pages; do
    awk -v folder="$figures" '
      /^<!-- end -->$/ { inside = 0 }
      !inside { print }
      /^<!-- figures: [a-z]+ -->$/ {
        inside = 1
        while ((getline line < (folder "/" $3)) > 0) print line
      }' "$page" >"$figures/page" && cp "$figures/page" "$page"
  done
  exit
fi

# The tables shown, without the columns of cores that the fresh ones don't have.
heads=$(grep -ohE '(Cortex|RV32)[^|]* \|' "$figures/cost" | sort -u)
# shellcheck disable=SC2086
cat $pages | awk -F'|' -v heads="$heads" '
  /^<!-- end -->$/ { inside = 0 }
  inside && !/^\|/ { table = 0; print }
  inside && /^\|/ {
    if (!table) {
      table = 1
      for (i = 2; i < NF; i++) dropped[i] = $i ~ /Cortex|RV32/ && index(heads, substr($i, 2) "|") == 0
    }
    line = "|"
    for (i = 2; i < NF; i++) if (!dropped[i]) line = line $i "|"
    print line
  }
  /^<!-- figures: (short|cost) -->$/ { inside = 1; table = 0 }' >"$figures/shown"
cat "$figures/short" "$figures/cost" | diff "$figures/shown" - || exit 1
shown ceiling | diff - "$figures/ceiling" || exit 1
for table in planecost castcost; do  # the column of Cortex-M3
  shown $table | cut -d '|' -f 1,2,4,5 | diff - "$figures/$table" || exit 1
done
for table in decisions plane; do
  cut -d '|' -f 1-4 "$figures/$table" >"$figures/own-$table"
  shown $table | cut -d '|' -f 1-4 | diff - "$figures/own-$table" || exit 1
done
