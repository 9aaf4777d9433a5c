#!/bin/sh
# Runs every test, two at a time, and adds up their counts: run-tests.sh BUILD
#
# A test is a program BUILD/test_* or a script tests/unit/test_*.sh BUILD; its last line is
# 'name: N passed, N failed' and may go on ', N skipped'. With GJK_NO_SKIP=1 a skip fails.
build=$1
logs=$build/log

run_one() {
  name=$(basename "$1" .sh)
  case $1 in
    *.sh) sh "$1" "$build" >"$logs/$name.log" 2>&1 ;;
    *) "$1" >"$logs/$name.log" 2>&1 ;;
  esac
  status=$?
  line=$(tail -n 1 "$logs/$name.log")
  case $line in
    *': '*' passed, '*' failed'*) ;;
    *) line="$name: 0 passed, 1 failed"; echo "$line" >>"$logs/$name.log" ;;
  esac
  grep -E 'skipped:' "$logs/$name.log"
  echo "$line"
  [ $status -eq 0 ] || { echo "--- $name, exit status $status"; tail -n 40 "$logs/$name.log"; echo "---"; }
  if [ $status -ne 0 ]; then
    case $line in
      *' 0 failed'*) echo "$name: 0 passed, 1 failed" >>"$logs/$name.log" ;;
    esac
  fi
}

if [ "$2" = one ]; then
  run_one "$3"
  exit 0
fi

mkdir -p "$logs"
rm -f "$logs"/*.log
for program in "$build"/test_*; do
  if [ -f "$program" ] && [ -x "$program" ]; then
    echo "$program"
  fi
done >"$logs/list"
ls tests/unit/test_*.sh >>"$logs/list" 2>/dev/null
xargs -P 2 -n 1 sh "$0" "$build" one <"$logs/list"

cat "$logs"/*.log | awk -v no_skip="${GJK_NO_SKIP:-0}" '
  /: [0-9]+ passed, [0-9]+ failed/ {
    match($0, /[0-9]+ passed/); passed += substr($0, RSTART, RLENGTH)
    match($0, /[0-9]+ failed/); failed += substr($0, RSTART, RLENGTH)
    if (match($0, /[0-9]+ skipped/)) skipped += substr($0, RSTART, RLENGTH)
  }
  END {
    if (no_skip == 1 && skipped > 0) { print skipped " tests were skipped, which is not allowed here"; failed += skipped }
    if (skipped > 0) printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
    else printf "%d passed, %d failed\n", passed, failed
    exit failed > 0 || passed == 0
  }'
