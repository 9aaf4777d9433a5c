#!/bin/sh
# The page in a headless Chromium (tests/check/page), and port/wasm by itself. test_page.sh BUILD
. tests/build/count.sh
build=$1

missing=
have clang || missing="$missing clang"
have wasm-ld || missing="$missing lld"
if [ -n "$missing" ]; then
  skip 'the page' "${missing# }"
  finish page
  exit
fi
check 'the page is built' make -s page
check 'the library alone is built' wasm_library "$build/page/gjk.wasm"

browser=
for name in chromium chromium-browser google-chrome; do
  [ -n "$browser" ] || ! have $name || browser=$name
done
if [ -z "$browser" ] || ! have python3; then
  skip 'the page in a browser' 'chromium python3'
  finish page
  exit
fi
python3 -B tests/check/page/test_page.py "$build" $browser >"$build/page-test.txt" 2>&1
status=$?
sed '$d' "$build/page-test.txt"
line=$(tail -n 1 "$build/page-test.txt")
case $line in
  'page: '*' passed, '*' failed')
    passed=$((passed + $(echo "$line" | sed 's/page: \([0-9]*\) .*/\1/')))
    failed=$((failed + $(echo "$line" | sed 's/.*, \([0-9]*\) failed/\1/')))
    ;;
  *)
    echo "$line"
    failed=$((failed + 1))
    ;;
esac
[ $status = 0 ] || [ $failed -gt 0 ] || failed=1
finish page
