#!/bin/sh
# What queries cost, at its smallest: figures are read right, counts repeat exactly, and all methods give the same sums.
# test_bench_cost.sh BUILD
build=$1
dir=$build/bench-cost-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"
pairs=12

run() {
  sh tests/build/bench-cost.sh "$build" $pairs 1 "$dir" >"$dir/tables.txt"
}
refused() {
  ! "$@" 2>/dev/null
}
same() {
  printf '%s\n' "$1" >"$dir/expected" && diff "$dir/expected" "$2"
}

# rows ROWS RULE: of the rows of timed.csv that the awk expression ROWS selects, and there are some, RULE is true.
rows() {
  awk -F, "NR > 1 && ($1) { rows++; if (!($2)) { print; bad = 1 } }
    END { if (!rows) print \"no such rows\"; exit bad || !rows }" "$dir/timed.csv"
}

# The parser of callgrind's dumps: with and without branches; a dump at the end, which has no name, is none.
cat >"$dir/dump.1" <<'END'
version: 1
desc: Trigger: Client Request: distance: boxes,gjk,gjk,cold
events: Ir Bc Bcm Bi Bim
fn=(1) pass
16 5
totals: 3000 700 40 90 10
END
cat >"$dir/dump.2" <<'END'
desc: Trigger: Client Request: depth: boxes,gjk,gjk,cold
events: Ir
totals: 500
END
cat >"$dir/dump.3" <<'END'
desc: Trigger: Program termination
events: Ir
totals: 7
END
parse() {
  awk -v pairs=10 -f tests/build/callgrind.awk "$dir"/dump.[123] >"$dir/parsed"
}
check 'dumps are read' parse
check 'instructions and mispredictions a pair' same 'distance: boxes,gjk,gjk,cold,instructions,300.000000
distance: boxes,gjk,gjk,cold,mispredictions,5.000000
depth: boxes,gjk,gjk,cold,instructions,50.000000' "$dir/parsed"

# The tables: the loop's own cost is subtracted, of a library the cheapest method that answers right counts, less than
# this library is marked.
cat >"$dir/made.csv" <<'END'
family,library,method,mode,measure,value
f,nothing,nothing,cold,ns,4
f,gjk,gjk,cold,sum,100
f,gjk,gjk,cold,ns,104
f,Other,Other dear,cold,sum,100.5
f,Other,Other dear,cold,ns,254
f,Other,Other cheap,cold,sum,99.5
f,Other,Other cheap,cold,ns,54
f,Other,Other wrong,cold,sum,102
f,Other,Other wrong,cold,ns,14
g,nothing,nothing,cold,ns,4
g,gjk,gjk,cold,sum,0
g,gjk,gjk,cold,ns,24
g,Other,Other dear,cold,sum,0
g,Other,Other dear,cold,ns,64
END
tables() {
  awk -F, -f tests/build/bench-cost.awk "$dir/made.csv" >"$dir/made.txt"
}
check 'tables' tables
check 'the cheapest that is right, less than this library' grep -qE '^f +100 +0\.50 <$' "$dir/made.txt"
check 'more than this library' grep -qE '^g +20 +3\.00  $' "$dir/made.txt"
check 'what answers otherwise is named' grep -q 'f, Other wrong (cold): off by 2.0 %, left out' "$dir/made.txt"
check 'where others are ahead' grep -qE '^  f +Other cheap +50 of 100$' "$dir/made.txt"
check 'and only there' refused grep -qE '^  (g|f +Other (dear|wrong)) .* of ' "$dir/made.txt"
check 'no table without figures' refused grep -q 'instructions a query' "$dir/made.txt"
markdown() {
  awk -F, -v markdown=1 -f tests/build/bench-cost.awk "$dir/made.csv" >"$dir/made.md"
}
check 'the table of the README' markdown
check 'a row of it' grep -qF '| f |  |  | 100 |  |  | 0.5 |' "$dir/made.md"

# The program, with the libraries that are installed.
check 'it runs' run
check 'columns' grep -qx 'family,library,method,mode,measure,value' "$dir/timed.csv"
check 'six fields a row' rows 1 'NF == 6 && $6 != ""'
for family in 'distance: boxes apart' 'distance: 8-point hulls apart' 'distance: 8-point hulls close' \
  'distance: 64-point hulls apart' 'distance: 64-point hulls close' 'distance: 256-point hulls apart' \
  'distance: capsules apart' 'distance: sphere to 8-point hull' 'intersect: boxes close' \
  'intersect: 8-point hulls close' 'intersect: 64-point hulls close' 'contacts: boxes' 'contacts: boxes flush' \
  'contacts: boxes turned' 'contacts: boxes yawed' 'contacts: boxes lifted' 'contacts: sphere and box' 'contacts: capsules'; do
  for mode in cold warm posed 'posed warm'; do
    check "$family, $mode" rows "\$1 == \"$family\" && \$3 == \"gjk\" && \$4 == \"$mode\" && \$5 == \"ns\"" '$6 > 0'
  done
done
for family in 'depth: boxes' 'depth: 8-point hulls' 'depth: 32-point hulls' 'depth: 64-point hulls'; do
  for mode in cold posed; do
    check "$family, $mode" rows "\$1 == \"$family\" && \$3 == \"gjk\" && \$4 == \"$mode\" && \$5 == \"ns\"" '$6 > 0'
  done
done
for family in 'posing: box' 'posing: 8-point hull' 'posing: 64-point hull' 'posing: 256-point hull'; do
  check "$family" rows "\$1 == \"$family\" && \$3 == \"gjk\" && \$5 == \"ns\"" '$6 > 0'
done
check 'close pairs: half of them touch' rows '$1 ~ /^intersect/ && $2 == "gjk" && $5 == "sum"' "\$6 == $pairs / 2"
check 'boxes at rest have contacts' rows '$1 ~ /^contacts: boxes (flush|turned|yawed)/ && $2 == "gjk" && $5 == "sum"' \
  "\$6 > 2.5 * $pairs"
check 'overlapping pairs have depths' rows '$1 ~ /^depth/ && $2 == "gjk" && $5 == "sum"' '$6 > 0'

# This library: the same sum to the bit in every mode, baked or lazy. Others: off by a percent, or by an answer where
# they count touching pairs; else the tables leave them out, which only depths may cause.
check 'its own sums agree' awk -F, '
  $2 == "gjk" && $5 == "sum" { if ($1 in sum && sum[$1] != $6) { print; bad = 1 } sum[$1] = $6; count++ }
  END { exit bad || count < 50 }' "$dir/timed.csv"
check 'the sums of others agree' awk -F, '
  $2 == "gjk" && $5 == "sum" { sum[$1] = $6 }
  $2 != "gjk" && $2 != "nothing" && $5 == "sum" && $1 !~ /^depth: [0-9]/ {
    off = $6 - sum[$1]
    if ((off < 0 ? -off : off) > ($1 ~ /^intersect/ ? 1 : 0.01 * sum[$1])) { print; bad = 1 }
  }
  END { exit bad }' "$dir/timed.csv"
check 'the tables say so' grep -q '^  all methods in the tables give the sum of this library' "$dir/tables.txt"

count() {
  rm -f "$dir"/again.*
  strip -g -o "$dir/gjk-cost" "$build/gjk-cost"
  valgrind --tool=callgrind --branch-sim=yes --instr-atstart=no --callgrind-out-file="$dir/again" \
    "$dir/gjk-cost" --pairs $pairs --count 1 2>"$dir/valgrind.log" &&
    awk -v pairs=$pairs -f tests/build/callgrind.awk "$dir"/again.* | sort >"$dir/again.csv"
}
repeats() {
  sort "$dir/counted.csv" | grep '^[^,]*,gjk,' >"$dir/first" && grep '^[^,]*,gjk,' "$dir/again.csv" | diff "$dir/first" -
}
if have valgrind; then
  check 'it is counted' grep -q 'distance: boxes apart,gjk,gjk,cold,mispredictions,' "$dir/counted.csv"
  check 'and counted again' count
  check 'counts repeat exactly' repeats
  check 'the loop is no query' awk -F, '$2 == "nothing" && $5 == "instructions" && $6 > 20 { bad = 1 } END { exit bad }' "$dir/counted.csv"
  check 'a table of instructions' grep -q '^instructions a query$' "$dir/tables.txt"
  check 'a table of mispredictions' grep -q '^branch mispredictions a query$' "$dir/tables.txt"
else
  check 'without valgrind it says so' grep -q '^skipped: instructions and branch mispredictions: needs valgrind' "$dir/tables.txt"
fi
check 'a wrong option is refused' refused "$build/gjk-cost" --pairs
check 'without callgrind there is no count' refused "$build/gjk-cost" --pairs 2 --count 1
finish bench_cost
