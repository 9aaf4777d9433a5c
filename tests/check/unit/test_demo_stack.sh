#!/bin/sh
# The pile of make demo-stack comes to rest, the same on every machine, and its picture is complete: test_demo_stack.sh
# BUILD
build=$1
demo=$build/gjk-demo-stack
dir=$build/demo-stack-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

check 'the pile falls' sh -c "\"$demo\" \"$dir/stack.svg\" >\"$dir/out\""
check 'it rests' grep -q '^30 bodies, 55 pairs in contact, the fastest at 0.0005 units a second' "$dir/out"
check 'each body and the tray are drawn at each of three moments' \
  test "$(grep -c 'fill="none" stroke=' "$dir/stack.svg")" = 105
check 'the picture has numbers only' numbers_only "$dir/stack.svg"
check 'the picture is well formed' well_formed "$dir/stack.svg" 200
check 'a picture that cannot be written is an error' sh -c "! \"$demo\" \"$dir/none/stack.svg\" 2>\"$dir/err\""
check 'a call without a picture is one' sh -c "! \"$demo\" 2>\"$dir/err\""

finish demo-stack
