#!/bin/sh
# The ceiling on rounds: a build that has a low one reports it, with bounds that hold. test_limit.sh BUILD
. tests/build/count.sh
dir=$1/limit
mkdir -p "$dir"

# bounds_of MAX: what the program prints when built with that ceiling
bounds_of() {
  ${CC:-cc} -std=c99 -O2 "-DGJK_ITERATIONS_MAX=$1" -Iinclude -Isrc -Itests src/*.c tests/limit/bounds.c -o "$dir/bounds" &&
    "$dir/bounds" >"$dir/$1.txt"
}

# holds MAX: wherever MAX rounds do not settle it, the bounds hold the distance (2 LSB of curved shapes apart) and MAX
# rounds were used; elsewhere nothing changes.
holds() {
  paste -d ' ' "$dir/128.txt" "$dir/$1.txt" | awk -v max="$1" '
    $9 == -10 { limited++; if ($10 > $3 + 2 || $11 < $3 - 2 || $12 != max) { print; bad = 1 } if ($10 > 0) useful++ }
    $9 != -10 && ($2 != $9 || $3 != $10 || $4 != $11 || $5 != $12) { print; bad = 1 }
    $13 == -10 { undecided++ }
    $13 != -10 && ($6 != $13 || $7 != $14) { print; bad = 1 }
    END { print limited + 0, useful + 0, undecided + 0; exit bad || limited < 400 || useful < limited / 4 || undecided < 20 }'
}

check 'the usual ceiling' bounds_of 128
check 'no pair reaches it' awk '$2 != 0 || $6 != 0 || $5 >= 64 { print; bad = 1 } END { exit bad }' "$dir/128.txt"
for max in 2 3 4; do
  check "a ceiling of $max" bounds_of $max
  check "a ceiling of $max holds its bounds" holds $max
done
finish limit
