#!/bin/sh
# The demo: its table, its picture, and its scene as C: test_query_demo.sh BUILD
build=$1
demo=$build/gjk-demo
dir=$build/demo-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

check 'the demo runs' status 0 "$demo" tests/data/arm.txt "$dir/arm.svg"
# Number, pair, answer, gap or minus the depth, way out and certificate; without the iterations.
grep -E '^ *[0-9]+  ' "$dir/out" |
  sed -E 's/ +[0-9]+  (proven|curved|WRONG)$/ \1/; s/ +/ /g; s/^ //' >"$dir/table"
check 'the table' diff tests/data/arm.expected "$dir/table"
check 'the summary' grep -q '^29 pairs: 20 proven in exact integers, 9 curved and .*, 0 wrong$' "$dir/out"
check 'the swing' grep -q '^swing: gripper-palm hits laser after 25.88[0-9] degrees, and not before: proven with 4 distances$' "$dir/out"
check 'the joints put the arm where it is' grep -q '^arm: 5 joints put 5 bodies within 2 LSB of the scene$' "$dir/out"

bodies=$(awk '/^case/ {gsub(":", "\n", $2); print $2}' tests/data/arm.txt | sort -u | wc -l | tr -d ' ')
check 'each body is drawn once' test "$(grep -c '<title>' "$dir/arm.svg")" = "$bodies"
for text in '48.2 mm' '0.015 mm' '24.4 mm deep' 'overlapping' 'touching' 'arm-elbow' 'hit after 25.89 degrees'; do
  check "the picture says $text" grep -q "$text" "$dir/arm.svg"
done
check 'the picture has numbers only' numbers_only "$dir/arm.svg"
check 'the picture is well formed' well_formed "$dir/arm.svg" 200
sed 's/arm-elbow/<\&>/' tests/data/arm.txt >"$dir/escaped.txt"
check 'names are escaped' sh -c "\"$demo\" \"$dir/escaped.txt\" \"$dir/escaped.svg\" && \
  grep -q '&lt;&amp;&gt;' \"$dir/escaped.svg\" && ! grep -q '<&' \"$dir/escaped.svg\""
check 'all kinds' status 2 "$demo" tests/data/query.txt "$dir/query.svg"
check 'a refused pair is named' grep -q '^negative-radius error GJK_ERROR_NEGATIVE' "$dir/err"

# The firmware's table, run on the host.
check 'the scene as C' sh -c "\"$demo\" --c-source tests/data/arm.txt >\"$dir/demo_scene.c\""
cat >"$dir/main.c" <<'END'
#include <stdio.h>
#include "demo_scene.h"
static void print(const char *text) { fputs(text, stdout); }
static uint32_t instructions(void) { return 0; }
int main(void) { return demo_firmware(print, instructions); }
END
# The tables with one gap changed: the firmware must notice.
sed 's/^   3159, /   3158, /' "$dir/demo_scene.c" >"$dir/wrong_scene.c"
for scene in demo wrong; do
  check "the C compiles: $scene" ${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -Iinclude \
    -Itests/programs/demo "$dir/main.c" "$dir/${scene}_scene.c" tests/programs/demo/firmware.c tests/programs/demo/arm.c "$build/host/libgjk.a" \
    "-o$dir/$scene"
done
check 'the same bits from the tables' status 0 "$dir/demo"
check 'the firmware sums up' grep -q '^29 pairs: 29 the same bits as on the host, 0 different' "$dir/out"
check 'the arm is the same' grep -q "^the arm's 5 joints, same bits: " "$dir/out"
check 'a changed bit is noticed' status 1 "$dir/wrong"
check 'a changed bit is named' grep -q 'arm-fore:rack-beam *DIFFERENT' "$dir/out"

check 'usage' status 2 "$demo"
check 'a missing scene' status 2 "$demo" "$dir/none.txt" "$dir/none.svg"
check 'a picture that cannot be written' status 2 "$demo" tests/data/arm.txt "$dir"
if [ -e /dev/full ]; then
  check 'a table that cannot be written' status 2 sh -c "\"$demo\" tests/data/arm.txt \"$dir/full.svg\" >/dev/full"
fi
printf 'case a:b\nA point\nB cube\n' >"$dir/bad.txt"
check 'a malformed scene' status 2 "$demo" "$dir/bad.txt" "$dir/bad.svg"
awk 'BEGIN {print "case a:b\nA hull 65"; for (i = 0; i < 65; i++) print i, i * i, 0; print "B point"}' \
  >"$dir/large.txt"
check 'a hull too large for the tables' status 2 "$demo" --c-source "$dir/large.txt"
awk 'BEGIN {for (i = 0; i < 130; i++) print "case a" i ":b\nA point\nA at", i, 0, 0, "\nB point"}' \
  >"$dir/many.txt"
check 'a scene too large' status 2 "$demo" "$dir/many.txt" "$dir/many.svg"

finish demo
