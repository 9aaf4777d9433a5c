#!/bin/sh
# Proves the absence of undefined behaviour with Frama-C's Eva: prove.sh BUILD [RUN...]
#
# A run is a driver of tests/prove with its case and variant, such as shape-BOX-int32. Without RUN all are made. What
# Eva cannot show by itself must stand in two lists. tests/prove/assumed.txt says why it holds. tests/prove/open.txt
# says for which runs, in how many places, and which statements the runs do not reach; a run fails if it finds more, or
# less. What Eva refutes always fails.
# `prove.sh BUILD --list [RUN...]` writes into open.txt what the last analysis of those runs has found, or of all runs
# that BUILD holds. `prove.sh BUILD --changed [RUN...]` makes the runs that did not yet hold on this code, and notes in
# digests.txt which do; `--stale` names those that held on other code and not on this. tests/prove/README.md tells the rest.
. tests/build/count.sh
LC_ALL=C.UTF-8
export LC_ALL
build=$1
dir=$build/prove
shift

. tests/build/prove-setup.sh
. tests/build/prove-digest.sh

# analyse NAME SOURCES OPTIONS...: leaves NAME.txt, what Eva says, and NAME.csv, a line per property.
analyse() {
  name=$1
  sources=$2
  shift 2
  if [ -n "$joined" ]; then  # statics have unique names over all of src
    echo "$sources" | tr ' ' '\n' | sed -n 's|^src/.*|#include "&"|p' >"$dir/$name.c"
    sources="$dir/$name.c $(echo "$sources" | tr ' ' '\n' | grep '^tests/' | tr '\n' ' ')"
  fi
  # shellcheck disable=SC2086
  frama-c $sources -eva $contracts -warn-signed-downcast \
    -eva-msg-key=-initial-state,-final-states -eva-split-return full -eva-min-loop-unroll 0 \
    -eva-auto-loop-unroll 64 "$@" -then -metrics-eva-cover -report-csv "$dir/$name.csv" >"$dir/$name.txt" 2>&1
}

# What RUN leaves open, from its table and report, sorted.
facts() {
  run=$1
  shift
  awk -v driver="${run%%-*}" -v contracts="${contracts#-eva-use-spec }" "$@" -f tests/build/prove-facts.awk \
    "$dir/$run.csv" "$dir/$run.txt" | sort
}

# expected MODE...: open.txt at length.
expected() {
  runs >"$dir/runs.$$"
  awk -v mode=split "$@" -f tests/build/prove-runs.awk "$dir/runs.$$" tests/prove/open.txt
  rm "$dir/runs.$$"
}

# What assumed.txt gives a reason for: FILE FUNCTION, a line each.
assumptions() {
  grep -v '^#' tests/prove/assumed.txt | awk -v RS='[ \n]+' '
    NF == 0 { next }
    { name = $1; sub(/;$/, "", name) }
    name ~ /[.][ch]$/ { file = name; next }
    { print file, name }' | sort -u
}

# What the contracts say of vectors' lengths, by an SMT solver.
prove_lengths() {
  WHY3CONFIG=$dir/why3.conf
  export WHY3CONFIG
  why3 config detect >/dev/null 2>&1
  frama-c -wp -wp-prover z3 -wp-timeout 60 -machdep gcc_x86_32 tests/prove/lengths.c >"$dir/lengths.txt" 2>&1
  cat "$dir/lengths.txt"
  grep -qE '^\[wp\] Proved goals: *([0-9]+) / \1$' "$dir/lengths.txt"
}

prove_one() {
  name=$1
  code_of "$name" >"$dir/$name.code"
  set_up "$name"
  start=$(date +%s)
  # shellcheck disable=SC2086
  analyse "$name" "$sources" $options -machdep $machine -cpp-extra-args="-Iinclude -I. $defines -include tests/prove/contracts.h"
  if ! [ -s "$dir/$name.csv" ] || ! grep -q 'coverage' "$dir/$name.txt"; then
    echo "failed: $name: no analysis: $dir/$name.txt"
    return
  fi
  facts "$name" >"$dir/$name.facts"
  facts "$name" -v full=1 >"$dir/$name.places"
  expected -v only="$name" | cut -f 2- | sort >"$dir/$name.expected"
  grep '^refuted' "$dir/$name.facts" | sed 's/^/refuted: /' >"$dir/$name.wrong"
  comm -13 "$dir/$name.expected" "$dir/$name.facts" | grep -v '^refuted' | sed 's/^/not in open.txt: /' >>"$dir/$name.wrong"
  comm -23 "$dir/$name.expected" "$dir/$name.facts" | sed 's/^/only in open.txt: /' >>"$dir/$name.wrong"
  reached=$(sed -n 's/.*, \([0-9]* statements reached (out of [0-9]*)\): \([0-9]*%\).*/\1, \2/p' "$dir/$name.txt")
  echo "$name: $(wc -l <"$dir/$name.wrong") unexpected, $(grep -vc '^unreached' "$dir/$name.facts") open, $reached," \
    "$(($(date +%s) - start)) s"
  sed "s/^/failed: $name: /" "$dir/$name.wrong"
  # The properties of what is not listed.
  sed -n 's/^not in open.txt: [a-z]*	[0-9]*	//p' "$dir/$name.wrong" | while read -r what; do
    grep -F "	$what	" "$dir/$name.places" | sed 's/^/  /'
  done
}

# list RUN...: what they found becomes what is expected.
list() {
  for run in "$@"; do
    [ -e "$dir/$run.facts" ] || { echo "not analysed in $dir: $run"; exit 1; }
  done
  for run in "$@"; do
    echo "$run"
  done >"$dir/listed"
  {
    expected -v without="$dir/listed"
    for run in "$@"; do
      sed "s/^/$run	/" "$dir/$run.facts"
    done
  } >"$dir/all"
  runs >"$dir/runs"
  {
    grep '^#' tests/prove/open.txt
    echo
    grep -v '	refuted	' "$dir/all" | sort -t '	' -k 4 -k 2 | awk -v mode=join -f tests/build/prove-runs.awk "$dir/runs" - |
      sort -t '	' -k 2,2 -k 1,1
  } >"$dir/open"
  cat "$dir/open" >tests/prove/open.txt
  normalize
  sign "$@"
  ! grep '	refuted	' "$dir/all"
}

# Each function that a run leaves something open in has its reason, each reason a run that needs it.
is_explained() {
  assumptions >"$dir/assumed"
  grep -v '^#' tests/prove/open.txt | grep . | grep -v '^unreached' | cut -f 3 | awk -v RS=', |\n' '{ print $1, $2 }' |
    sort -u | awk '
      FNR == NR { reason[$0]; next }
      {
        everywhere = $0
        sub(/^[a-z_]*\//, "*/", everywhere)
        if ($0 in reason) needed[$0]
        else if (everywhere in reason) needed[everywhere]
        else print "without a reason: " $0
      }
      END { for (what in reason) if (!(what in needed)) print "needed by no run: " what }' "$dir/assumed" - >"$dir/explained"
  cat "$dir/explained"
  [ ! -s "$dir/explained" ]
}

if [ "$1" = --one ]; then
  prove_one "$2"
  exit 0
fi
mkdir -p "$dir"
if [ "$1" = --stale ]; then
  normalize
  stale
  exit
fi
if ! have frama-c; then
  skip 'the proof' frama-c-base
  finish prove
  exit
fi
if [ "$1" = --list ]; then
  shift
  # shellcheck disable=SC2046
  [ $# -gt 0 ] || set -- $(runs | while read -r run; do [ ! -e "$dir/$run.facts" ] || echo "$run"; done)
  list "$@"
  check 'nothing is refuted' [ $? = 0 ]
  check 'what is open has its reason, and each reason a need' is_explained
  finish prove
  exit
fi
rm -rf "${dir:?}"/*
normalize
all=
signs=
[ $# -gt 0 ] || all=1
if [ "$1" = --changed ]; then
  signs=1
  shift
  # shellcheck disable=SC2046
  [ $# -gt 0 ] || set -- $(unsigned)
  [ $# -gt 0 ] || { echo 'each run has held on this code'; exit 0; }
fi
# shellcheck disable=SC2046
[ $# -gt 0 ] || set -- $(runs)
for run in "$@"; do
  echo "$run"
done | nice xargs -P 2 -n 1 sh "$0" "$build" --one | tee "$dir/report"
for run in "$@"; do
  check "$run: open and unreached is what is listed" grep -q "^$run: 0 unexpected" "$dir/report"
done
check 'what is open has its reason, and each reason a need' is_explained
[ -z "$all$signs" ] || sign "$@"
if [ -n "$all" ]; then
  if have why3 && have z3; then
    check 'what contracts say of lengths' prove_lengths
  else
    skip 'what contracts say of lengths' 'why3 z3'
  fi
  check 'what is assumed holds as it runs' nice sh tests/build/bounds.sh "$build" 20000 1
fi
echo "$(assumptions | wc -l) assumptions"
finish prove
