#!/bin/sh
# The demo of the plane: two processes stay the same, end where they always end, and collide on the way; its picture is
# complete. A side that is fed other inputs is found. test_demo_plane.sh BUILD
. tests/build/count.sh
build=$1
demo=$build/gjk-demo-plane
dir=$build/demo-plane-test
rm -rf "$dir"
mkdir -p "$dir"

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
sides=1
if [ -n "${missing# }" ]; then
  skip 'the plane against firmware' "$missing"
else
  sides=$((sides + 1))
fi
if ! have s390x-linux-gnu-gcc || ! have qemu-s390x; then
  skip 'the plane against a big-endian machine' 'gcc-s390x-linux-gnu qemu-user'
else
  sides=$((sides + 1))
fi

check 'two sides stay the same' sh -c "sh tests/build/demo-plane.sh \"$build\" 240 2>\"$dir/said\""
check 'in each match' test "$(grep -c '^240 ticks, the same hash after each' "$dir/said")" = $sides
check 'they end where they always end' test "$(grep -c 'end 0x478c17b377125d73, 3686 contact points of pairs, 11874 of ground' "$dir/said")" = $sides

picture=$build/plane.svg
check 'the level, each body and its start and its path are drawn' sh -c "
  [ \$(grep -c 'class=\"earth\"' \"$picture\") = 2 ] && [ \$(grep -c 'class=\"thin\"' \"$picture\") = 2 ] &&
  [ \$(grep -c 'class=\"b[0-4]\"' \"$picture\") = 16 ] && [ \$(grep -c 'class=\"start\"' \"$picture\") = 16 ] &&
  [ \$(grep -c 'class=\"path p' \"$picture\") = 16 ]"
check 'the picture has numbers only' sh -c "! grep -qE 'nan|inf[^o]' \"$picture\""

# The sides agree about what each was told, so another input plays another match, the same for both.
sed 's/^1 70 L/1 70 R/' tests/data/platformer.txt >"$dir/other.txt"
mkfifo "$dir/forth" "$dir/back"
other_match() {
  "$demo" 1 "$dir/other.txt" 240 <"$dir/forth" >"$dir/back" &
  "$demo" 0 tests/data/platformer.txt 240 2>"$dir/other.said" >"$dir/forth" <"$dir/back" && wait $!
}
check 'other inputs are another match' other_match
check 'with another end' sh -c "grep -q 'the same hash after each' \"$dir/other.said\" && ! grep -q 7ea0e162c5c975e6 \"$dir/other.said\""

# A side whose state goes another way is found at that tick.
wrong_hash() {
  printf 'i 0000000000000000 0000000000000000\nh 0000000000000000 0000000000000001\n' |
    "$demo" 0 tests/data/platformer.txt 240 >"$dir/sent" 2>"$dir/wrong.said"
  [ $? = 1 ] && grep -q '^0 ticks, then they differ' "$dir/wrong.said"
}
refused() {
  "$@" </dev/null >"$dir/sent" 2>&1
  [ $? = 2 ]
}
check 'another hash is found' wrong_hash
check 'a link that ends is found' refused "$demo" 0 tests/data/platformer.txt 240
printf '0 ten L\n' >"$dir/bad.txt"
check 'a bad line is refused' refused "$demo" 0 "$dir/bad.txt" 240
check 'a file that is not there is refused' refused "$demo" 0 "$dir/none.txt" 240
check 'a call without a file is refused' refused "$demo" 0
finish demo-plane
