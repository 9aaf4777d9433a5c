#!/bin/sh
# The figures of the README that are counted: readme-figures.sh BUILD [TARGET]
#
# Writes the tables between the marks '<!-- figures: NAME -->' and '<!-- end -->' of README.md from a fresh count on
# every target. With a TARGET it counts on that one alone, compares the README's column for it, the table of the most
# expensive pairs, and this library's and the reference's columns of wrong decisions, and changes nothing.
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

if [ -z "$target" ]; then
  if [ "$(head -n 1 "$figures/decisions" | tr -cd '|' | wc -c)" -lt 7 ]; then
    echo 'the table of decisions stays: libccd-dev, libfcl-dev and libbullet-dev are needed' >&2
    sed -n '/^<!-- figures: decisions -->$/,/^<!-- end -->$/{/^|/p;}' README.md >"$figures/decisions"
  fi
  awk -v folder="$figures" '
    /^<!-- end -->$/ { inside = 0 }
    !inside { print }
    /^<!-- figures: [a-z]+ -->$/ {
      inside = 1
      while ((getline line < (folder "/" $3)) > 0) print line
    }' README.md >"$figures/README.md" && cp "$figures/README.md" README.md
  exit
fi

# The README's tables without the columns of cores that the fresh ones don't have.
heads=$(grep -ohE '(Cortex|RV32)[^|]* \|' "$figures/cost" | sort -u)
awk -F'|' -v heads="$heads" '
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
  /^<!-- figures: cost -->$/ { inside = 1 }' README.md >"$figures/readme-cost"
diff "$figures/readme-cost" "$figures/cost" || exit 1
sed -n '/^<!-- figures: ceiling -->$/,/^<!-- end -->$/{/^|/p;}' README.md | diff - "$figures/ceiling" || exit 1
sed -n '/^<!-- figures: decisions -->$/,/^<!-- end -->$/{/^|/p;}' README.md | cut -d '|' -f 1-4 |
  diff - "$(cut -d '|' -f 1-4 "$figures/decisions" >"$figures/own-decisions"; echo "$figures/own-decisions")"
