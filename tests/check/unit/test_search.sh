#!/bin/sh
# The search of polytopes that remembers the vertices it has seen, which few pairs need. It is built to remember from
# the first iterations on, and to take few steps among seen vertices before it tries all features. Answers are
# certified as usual and have the same bits. test_search.sh BUILD
. tests/build/count.sh
root=$1
dir=$1/search
support=$(make -s print-SUPPORT)
rm -rf "$dir"
mkdir -p "$dir"

# The sources that may depend on these numbers: those that include the headers with them.
headers=$(grep -lE 'GJK_PLAIN_ITERATIONS|GJK_RECALLS_MAX' src/*/*.h | sed 's|.*/|/|')
sources=$(grep -lF "$headers" "$root"/host/*.d | sed 's|.*/\(.*\)\.d$|\1.c|' | while read -r name; do echo src/*/"$name"; done)

# build NAME PLAIN RECALLS TEST: builds a test with such a library: those sources stand in for their objects in the archive
build() {
  program=$dir/$1
  numbers=$dir/$2-$3
  if ! [ -d "$numbers" ]; then
    mkdir -p "$numbers"
    for source in $sources; do
      ${CC:-cc} -std=c99 -O1 -DGJK_PORT_HEADER='"hosted/gjk_port.h"' -Iinclude -Iport "-DGJK_PLAIN_ITERATIONS=$2" \
        "-DGJK_RECALLS_MAX=$3" -c "$source" -o "$numbers/$(basename "$source" .c).o" || return 1
    done
  fi
  # shellcheck disable=SC2086
  ${CC:-cc} "$numbers"/*.o $4 $support "$root/host/libgjk.a" -lm -o "$program"
}

# certified PLAIN RECALLS SEED PAIRS
certified() {
  build "certificates-$1-$2" "$1" "$2" "$root/hosted/tests/check/unit/test_certificates.o" &&
    "$dir/certificates-$1-$2" "$3" "$4"
}

# worst PLAIN RECALLS: the pairs of tests/data/worst.txt, whatever their iterations
worst() {
  build "query-$1-$2" "$1" "$2" "$(make -s print-QUERY)" || return 1
  for ask in --distance --intersect; do
    "$dir/query-$1-$2" --certify $ask tests/data/worst.txt 2>&1 >"$dir/worst.txt" | grep -q ' 0 wrong$' || return 1
    [ "$(wc -l <"$dir/worst.txt")" -ge 23 ] || return 1
  done
}

check 'the search is built anew' sh -c "echo '$sources' | grep -q gjk_search.c"
check 'and what has a part of it in line' sh -c "echo '$sources' | grep -q gjk_intersect.c"
check 'remembering from iteration 1' certified 1 200 71 20000
check 'remembering from iteration 2, three steps among the seen' certified 2 3 72 1000
check 'remembering from iteration 1, all features tried each time' certified 1 0 73 800
check 'the most expensive pairs, remembering from iteration 1' worst 1 200
check 'the most expensive pairs, one step among the seen' worst 16 1
finish search
