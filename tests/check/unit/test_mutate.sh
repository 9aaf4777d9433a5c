#!/bin/sh
# The list of mutants, and whether each argument of equivalent.txt is about one of them. test_mutate.sh BUILD
. tests/build/count.sh
dir=$1/mutate
mkdir -p "$dir"

list_mutants() {
  "${CC:-cc}" -std=c99 -O1 tests/check/mutate/mutate.c -o "$dir/mutate" || return 1
  for file in src/*/*.[ch]; do
    "$dir/mutate" list "$file" || return 1
  done >"$dir/all"
}

is_in_lines() {
  awk -F '\t' 'NF != 5 { print; bad = 1 } END { exit bad || NR < 10000 }' "$dir/all"
}

# argues_for_mutants ARGUMENTS: each for a mutant that there is
argues_for_mutants() {
  awk -F '\t' -f tests/build/mutants.awk "$1" "$dir/all" /dev/null >"$dir/sums"
  ! grep -e '^argues for no mutant' -e '^not of the form' "$dir/sums"
}

refuses() {
  { cat tests/check/mutate/equivalent.txt; echo "$1" | tr '@' '\t'; } >"$dir/forged"
  ! argues_for_mutants "$dir/forged" >"$dir/said"
}

check 'mutants are listed' list_mutants
check 'a mutant a line' is_in_lines
check 'each argument is of a mutant' argues_for_mutants tests/check/mutate/equivalent.txt
check 'one of no mutant is told' refuses 'src/gjk/gjk_search.c@no such line@< => <=@equivalent@forged'
check 'one without a reason is told' refuses 'src/gjk/gjk_search.c@for@< => <='
finish mutate
