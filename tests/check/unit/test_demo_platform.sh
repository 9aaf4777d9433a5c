#!/bin/sh
# The picture of the platform game is complete: test_demo_platform.sh BUILD
build=$1
demo=$build/gjk-demo-platform
dir=$build/demo-platform-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

# drawn COLOUR: how many lines of that colour
drawn() {
  grep -c "stroke=\"$1\"" "$dir/platform.svg"
}

check 'the game is drawn' "$demo" "$dir/platform.svg"
check 'at three moments' test "$(grep -c '<text' "$dir/platform.svg")" = 3
check 'with four sides of each crate and of the lift' test $(($(drawn '#c2410c') + $(drawn '#94a3b8'))) -ge $((3 * 4 * 81))
check 'the level and the way of the runner' test "$(drawn '#334155')" -ge 60 -a "$(drawn '#2563eb')" = 3
check 'most crates sleep in the end' test "$(sed -n '/tick 500/,$p' "$dir/platform.svg" | grep -c '#94a3b8')" -ge 280
check 'the picture has numbers only' numbers_only "$dir/platform.svg"
check 'the picture is well formed' well_formed "$dir/platform.svg" 1000
check 'a picture that cannot be written is an error' sh -c "! \"$demo\" \"$dir/none/platform.svg\" 2>\"$dir/err\""
check 'a call without a picture is one' sh -c "! \"$demo\" 2>\"$dir/err\""

finish demo-platform
