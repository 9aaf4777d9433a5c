#!/bin/sh
# Decisions and costs in the plane at their smallest: this library is never wrong, all methods give the same sums, and
# counts repeat exactly. test_bench_plane.sh BUILD
build=$1
dir=$build/bench-plane-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir/bench"
pairs=40

refused() {
  ! "$@" 2>/dev/null
}
decisions() {
  sh tests/build/plane-decisions.sh "$dir" 200 >"$dir/decisions.md"
}
costs() {
  sh tests/build/bench-plane.sh "$dir" $pairs 2 >"$dir/costs.txt"
}

# rows FILE ROWS RULE: of the rows that the awk expression ROWS selects, and there are some, RULE is true.
rows() {
  awk -F, "($2) { rows++; if (!($3)) { print; bad = 1 } }
    END { if (!rows) print \"no such rows\"; exit bad || !rows }" "$1"
}

check 'decisions' decisions
check 'eight families, two lines above' test "$(grep -c '^|' "$dir/decisions.md")" = 10
check 'this library and the reference' grep -q '^| pairs in the plane | gjk2 | GJK in `double`, tolerance 1e-32 |' "$dir/decisions.md"
check 'this library is never wrong' test "$(grep -c '^| [^|]* | \*\*0\*\* |' "$dir/decisions.md")" = 8
build/gjk-plane decisions 500 >"$dir/decisions.csv"
check 'in figures' rows "$dir/decisions.csv" '$2 == "gjk"' '$3 == 500 && $4 == 0'
check 'the reference is good at game sizes' rows "$dir/decisions.csv" '$1 == "game" && $2 == "double"' '$4 == 0'
if grep -q ',Box2D' "$dir/decisions.csv"; then
  check 'and so is Box2D' rows "$dir/decisions.csv" '$1 == "game" && $2 ~ /^Box2D/' '$4 <= 1'
  check 'which is wrong at smallest determinants' rows "$dir/decisions.csv" '$1 ~ /^smallest/ && $2 ~ /^Box2D/' '$4 > 25'
fi

check 'costs' costs
for family in 'distance: boxes apart' 'distance: 8-gons apart' 'intersect: 8-gons close' 'depth: 8-gons' \
  'contacts: 8-gons face to face' 'contacts: circles' 'contacts: capsules' 'contacts: box on a chain'; do
  check "$family" rows "$dir/bench/plane.csv" "\$1 == \"$family\" && \$2 == \"gjk\" && \$3 == \"ns\"" '$4 > 0'
done
check 'half of the close pairs touch' rows "$dir/bench/plane.csv" '$1 ~ /^intersect/ && $2 == "gjk" && $3 == "sum"' "\$4 == $pairs / 2"
check 'two contacts face to face' rows "$dir/bench/plane.csv" '$1 ~ /^contacts: (8-gons|boxes)/ && $2 == "gjk" && $3 == "sum"' "\$4 > 1.9 * $pairs"
check 'all give the same sums' awk -F, '
  $3 == "sum" && $2 == "gjk" { own[$1] = $4 }
  $3 == "sum" && $2 != "nothing" { off = $4 - own[$1]; count++; if ((off < 0 ? -off : off) > 0.02 * own[$1]) { print; bad = 1 } }
  END { exit bad || count < 9 }' "$dir/bench/plane.csv"
if have valgrind; then
  check 'it is counted' rows "$dir/bench/plane.csv" '$3 == "instructions" && $2 == "gjk"' '$4 > 200 && $4 < 20000'
  grep ',gjk,instructions,' "$dir/bench/plane.csv" >"$dir/first"
  check 'and counted again' costs
  grep ',gjk,instructions,' "$dir/bench/plane.csv" >"$dir/again"
  check 'counts repeat exactly' diff "$dir/first" "$dir/again"
else
  check 'without valgrind it says so' grep -q '^skipped: instructions in the plane: needs valgrind' "$dir/costs.txt"
fi
check 'a wrong option is refused' refused build/gjk-plane
check 'without callgrind there is no count' refused build/gjk-plane count 2
finish bench_plane
