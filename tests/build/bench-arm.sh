#!/bin/sh
# Edges of an arm of seven joints among crates, balls and hulls, other libraries beside them: bench-arm.sh BUILD [EDGES
# [REPETITIONS]]; 200 of each family and 3 by default. Prints a table: microseconds an edge, and how many touches each
# method misses. FCL and Bullet are measured if their Debian packages are installed (WITHOUT_PEERS=1: not even then).
. tests/build/count.sh
. tests/build/peers.sh
edges=${2:-200}
if [ -z "$WITHOUT_PEERS" ]; then
  find_peer bullet Bullet libbullet-dev >&2
  find_peer fcl FCL libfcl-dev >&2
fi
mkdir -p "$1/bench"
make -s build/gjk-arms BENCH_PEERS="$peers" >"$1/bench/arm.log" 2>&1 || { cat "$1/bench/arm.log"; exit 1; }
build/gjk-arms "$edges" "${3:-3}" >"$1/bench/arm.csv" || exit 1
awk -F, 'BEGIN {
    print "| edges | method | touches missed | false alarms | us an edge |"
    print "|---|---|---|---|---|"
  }
  { printf "| %s | %s | %d of %d | %d of %d | %.0f |\n", $1, $2, $4, $3, $6, $5, $7 }' "$1/bench/arm.csv"
