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
# rounds were used; elsewhere nothing changes. Other queries say so, too, or answer as usual.
holds() {
  paste -d ' ' "$dir/128.txt" "$dir/$1.txt" | awk -v max="$1" '
    # The status in the field and the n fields after it, to those of the usual ceiling.
    function same(field, n,   i, differ) {
      if ($(14 + field) == -10) return 0
      for (i = 0; i <= n; i++) differ = differ || $(field + i) != $(14 + field + i)
      if (differ) { print field ": " $0; bad = 1 }
      return 1
    }
    $16 == -10 { limited++; if ($17 > $3 + 2 || $18 < $3 - 2 || $19 != max) { print; bad = 1 } if ($17 > 0) useful++ }
    { same(2, 3); undecided += !same(6, 1); unpierced += !same(8, 2); unmeasured += !same(11, 1); unmet += !same(13, 1) }
    END {
      print limited + 0, useful + 0, undecided + 0, unpierced + 0, unmeasured + 0, unmet + 0
      exit bad || limited < 400 || useful < limited / 4 || undecided < 20 || unpierced < 20 || unmeasured < 100 || unmet < 100
    }'
}

check 'the usual ceiling' bounds_of 128
check 'no pair reaches it' awk '$2 != 0 || $6 != 0 || $5 >= 64 { print; bad = 1 } END { exit bad }' "$dir/128.txt"
for max in 2 3 4; do
  check "a ceiling of $max" bounds_of $max
  check "a ceiling of $max holds its bounds" holds $max
done
finish limit
