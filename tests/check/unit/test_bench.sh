#!/bin/sh
# The benchmark at its smallest: it writes what it should, and the library is right in it. test_bench.sh BUILD
build=$1
dir=$build/bench-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

run() {
  "$build/gjk-bench" --pairs 40 --timed 5 --seconds 0 --repetitions 1 >"$dir/run.csv"
}
report() {
  python3 -B tests/measure/bench/report/report.py "$1" "$dir/${2:-page}.html" ${3:+"$3"} >"$dir/table.txt"
}
refused() {
  ! "$@" 2>/dev/null
}

# holds ROWS RULE: of the rows that the awk expression ROWS selects, and there are some, RULE is true.
holds() {
  awk -F, "NR > 1 && ($1) { rows++; if (!($2)) { print; bad = 1 } }
    END { if (!rows) print \"no such rows\"; exit bad || !rows }" "$dir/run.csv"
}

check 'it builds without other libraries' make -s "$build/gjk-bench"
check 'it runs' run
check 'columns' grep -qx 'family,query,method,measure,at,value' "$dir/run.csv"
check 'six fields a row' holds 1 'NF >= 6 && $4 != "" && $6 != ""'
for family in boxes hulls-8 hulls-32 hulls-128 hulls-512 near far slivers smallest; do
  for query in distance intersect; do
    for measure in pairs wrong undecided outside time; do
      check "$family, $query, $measure" \
        holds "\$1 == \"$family\" && \$2 == \"$query\" && \$3 == \"gjk cold\" && \$4 == \"$measure\"" '$6 >= 0'
    done
  done
done
for family in overlap-boxes overlap-hulls-8 overlap-hulls-32 overlap-hulls-128 shallow concentric rounded crosses \
  depths; do
  for measure in pairs wrong failed says_apart too_small too_large error_most time; do
    check "$family, depth, $measure" \
      holds "\$1 == \"$family\" && \$2 == \"depth\" && \$3 == \"gjk cold\" && \$4 == \"$measure\"" '$6 >= 0'
  done
done
for family in pressed-boxes pressed-hulls; do
  for measure in pairs wrong contacts error_most time; do
    check "$family, contacts, $measure" \
      holds "\$1 == \"$family\" && \$2 == \"contacts\" && \$3 == \"gjk cold\" && \$4 == \"$measure\"" '$6 >= 0'
  done
done
check 'times' holds '$4 == "time"' '$6 > 0'
check 'pairs' holds '$4 == "pairs"' '$6 == 40'

# The library: no wrong decision, half an LSB, bounds that hold, and errors within what was allowed.
check 'no wrong decisions' holds '$3 ~ /^gjk / && ($4 == "wrong" || $4 == "gap_wrong")' '$6 == 0'
check 'nothing undecided' holds '$3 ~ /^gjk (cold|warm)$/ && $4 == "undecided"' '$6 == 0'
check 'half an LSB' \
  holds '$2 == "distance" && $3 ~ /^gjk (cold|warm)$/ && $4 == "error_most"' '$6 <= 0.5000001'
check 'depths: an LSB' holds '$2 == "depth" && $3 ~ /^gjk / && $4 == "error_most"' '$6 < 1.000001'
check 'contacts: six LSB, two where none are left out' holds '$2 == "contacts" && $3 ~ /^gjk / && $4 == "error_most"' '$6 < 6.000001'
check 'four contacts, face to face' holds '$3 ~ /^gjk / && $4 == "contacts"' '$6 > 3.5 && $6 <= 4'
check 'small depths are proven in exact integers' holds '$1 ~ /overlap-(boxes|hulls-8)/ && $4 == "exact"' '$6 == 40'
check 'some of 32 points, too' holds '$1 == "overlap-hulls-32" && $4 == "exact"' '$6 >= 8'
check 'the depths spread' holds '$1 == "depths" && $3 == "gjk cold" && $4 == "gap_pairs"' '$6 < 20'
check 'the reference is close' \
  holds '$2 == "depth" && $3 == "reference double" && $1 != "shallow" && $4 == "error_mean"' '$6 < 0.01'
check 'bounds hold' holds '$4 == "outside"' '$6 == 0'
for error in 1 16 256; do
  check "to $error LSB" holds "\$3 == \"gjk to $error LSB\" && \$4 == \"error_most\"" "\$6 <= $error"
done
check 'wrong decisions are seen' holds '$1 == "smallest" && $3 ~ /^reference/ && $4 == "wrong"' '$6 > 0'
check 'a wrong option is refused' refused "$build/gjk-bench" --pairs

# The page: whole, and in need of nothing else.
if ! have python3; then
  skip 'the report' python3
  finish bench
  exit
fi
check 'the report' report "$dir/run.csv"
check 'the table' grep -q '^gjk cold  *1\.00 ' "$dir/table.txt"
check 'the table of depths' grep -q '^overlap-boxes, depth: ' "$dir/table.txt"
check 'it opens with one chart' test "$(grep -c '<figure class="opening">' "$dir/page.html")" -eq 1
check 'and one table' test "$(grep -c '<div class="wide opening">' "$dir/page.html")" -eq 1
check 'in which this library is never wrong' grep -q '<tr class="own"><td>gjk cold</td><td>1.00</td><td>0 %</td><td>1.00</td><td>0 %</td>' "$dir/page.html"
check 'plots' test "$(grep -c '<figure ' "$dir/page.html")" -gt 30
check 'plots of depths and contacts' grep -q 'figcaption>shallow: depth<' "$dir/page.html"
check 'a map of depths' grep -q 'figcaption>all families: depth<' "$dir/page.html"
check 'no numbers that are none' refused grep -qE '(nan|inf)[ "<]' "$dir/page.html"
check 'no external resources' refused grep -qE 'https?:|src=|href=|url\(|@import' "$dir/page.html"
check 'the page is closed' grep -q '</html>' "$dir/page.html"
check 'without scenes' refused grep -q 'Scenes' "$dir/page.html"
cat >"$dir/scenes.csv" <<'END'
scene,bodies,percent moving,gjk whole tick ns,all pairs ns,Bullet ns,gjk pairs,% resting,% motion,% boxes,% direction,% warm,% cold
sparse,1000,5,20000,1000000,,100,90,5,2,1,1,1
sparse,10000,5,300000,100000000,,1100,90,5,2,1,1,1
END
check 'with scenes' report "$dir/run.csv" scenes "$dir/scenes.csv"
check 'their lines' grep -q 'boxes of all pairs' "$dir/scenes.html"
check 'no line of what is not there' refused grep -q 'btDbvtBroadphase' "$dir/scenes.html"
check 'their shares' grep -q 'moved less than was proven: 5.0 %' "$dir/scenes.html"
check 'no numbers that are none there' refused grep -qE '(nan|inf)[ "<]' "$dir/scenes.html"
check 'other tables of scenes are refused' refused report "$dir/run.csv" no "$dir/run.csv"
printf 'family,query\n' >"$dir/bad.csv"
check 'other tables are refused' refused report "$dir/bad.csv"
finish bench
