#!/bin/sh
# Runs tests, two at a time, and adds up their counts: run-tests.sh BUILD TEST...
#
# A test is a program, or a script that gets BUILD. Its last line is 'NAME: N passed, N failed', perhaps with ', N
# skipped'. It counts as failed also if its exit status is bad, that line is missing, it counts nothing at all, or
# there is no result: it was never started, or was killed with the shell that watched it. Its output is kept in
# BUILD/log, and shown if it fails. With GJK_NO_SKIP=1 a skip is a failure. BUILD/log/seconds says what processor time
# each took.
build=$1
logs=$build/log
shift

run_one() {
  name=$(basename "$1" .sh)
  log=$logs/$name.log
  case $1 in
    *.sh) sh "$1" "$build" >"$log" 2>&1 ;;
    *) "$1" >"$log" 2>&1 ;;
  esac
  status=$?
  times >"$logs/$name.times"
  line=$(tail -n 1 "$log" | grep -E ': [0-9]+ passed, [0-9]+ failed(, [0-9]+ skipped)?$')
  case $status:$line in
    *:) line="$name: 0 passed, 1 failed: no result, exit status $status" ;;
    *': 0 passed, 0 failed') line="$name: 0 passed, 1 failed: it counts nothing" ;;
    0:*) ;;
    *' 0 failed'*) line="$name: 0 passed, 1 failed: exit status $status" ;;
  esac
  echo "$line" | tee "$logs/$name.result"
  grep '^skipped: ' "$log"
  if [ $status != 0 ]; then
    { grep -a -E 'failed|error' "$log" | head -n 20; tail -n 40 "$log"; } | sed 's/^/    /'
    echo "    all of it: $log"
  fi
}

if [ "$1" = --one ]; then
  run_one "$2"
  exit 0
fi

# Two tests of one name would share a log and a result.
twice=$(for test in "$@"; do
  basename "$test" .sh
done | sort | uniq -d)
if [ -n "$twice" ]; then
  echo "run-tests: 0 passed, 1 failed: more than one test named $twice"
  exit 1
fi

# Tests that call make must not share this one's job server.
unset MAKEFLAGS MFLAGS MAKELEVEL
export GJK_BY_ROOMS=1
# Where python3 is a script that looks for the interpreter, that takes longer than most of what tests ask of it.
if python=$(python3 -c 'import sys; print(sys.executable)' 2>/dev/null); then
  PATH=${python%/*}:$PATH
fi
mkdir -p "$logs"
rm -f "$logs"/*
for test in "$@"; do
  echo "$test"
done | xargs -P 2 -n 1 sh "$0" "$build" --one
ended=$?

# xargs starts no more when a shell that watches a test is killed.
if [ $ended != 0 ]; then
  echo "run-tests: 0 passed, 1 failed: xargs ends with status $ended" | tee "$logs/run-tests.result"
fi
for test in "$@"; do
  name=$(basename "$test" .sh)
  [ -s "$logs/$name.result" ] || echo "$name: 0 passed, 1 failed: not run to its end" | tee "$logs/$name.result"
done

for test in "$logs"/*.times; do
  awk -v name="$(basename "$test" .times)" 'NR == 2 {
      split($0, t, /[ms ]+/)
      printf "%.1f %s\n", 60 * (t[1] + t[3]) + t[2] + t[4], name
    }' "$test"
  rm "$test"
done | sort -rn >"$logs/seconds"
# What failed is said once more at the end, where a log that was cut short still shows it.
for result in "$logs"/*.result; do
  grep -q ' 0 failed' "$result" || { cat "$result"; tail -n 5 "${result%.result}.log" | sed 's/^/    /'; }
done
cat "$logs"/*.result | awk -v no_skip="${GJK_NO_SKIP:-0}" '
  {
    sub(/^[^:]*: /, "")
    passed += $1
    failed += $3
    skipped += $5
  }
  END {
    if (no_skip == 1 && skipped > 0) {
      print skipped " skipped, which counts as failed here"
      failed += skipped
      skipped = 0
    }
    printf "%d passed, %d failed", passed, failed
    if (skipped > 0) printf ", %d skipped", skipped
    printf "\n"
    exit failed > 0 || passed == 0
  }'
