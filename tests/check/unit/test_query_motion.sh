#!/bin/sh
# The query tool on casts, rays and times of impact, in space and in the plane: test_query_motion.sh BUILD
build=$1
tool=$build/gjk-query
data=tests/data
dir=$build/query-motion-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

# Without what may change with the way to an answer.
plain() {
  sed 's/ a=[-0-9,]*//; s/ b=[-0-9,]*//; s/ normal=[-0-9,]*//; s/ iterations=[0-9]*//'
}

# Exact fractions, worked out elsewhere; and places of rest, by hand.

check 'casts' status 0 "$tool" --cast --certify $data/cast.txt
check 'casts proven' grep -q '^certify: 26 certified, 0 uncertified, 0 wrong$' "$dir/err"
plain <"$dir/out" | sed 's/ at=[-0-9,]*//' >"$dir/plain"
sed 's/ dim=[0-9]*//' $data/cast.exact >"$dir/exact"
check 'fractions known exactly' diff "$dir/exact" "$dir/plain"
number='-?[0-9]+'
triple="$number,$number,$number"
grep -vE "^[^ ]+ hit fraction=[0-9]+ a=$triple b=$triple normal=$triple at=$triple iterations=[0-9]+\$" "$dir/out" |
  grep -vE '^[^ ]+ miss iterations=[0-9]+$' >"$dir/strange"
check 'the form of each line' diff /dev/null "$dir/strange"
check 'casts known by hand' status 0 "$tool" --cast --certify $data/motion.txt
plain <"$dir/out" >"$dir/plain"
check 'fractions and places of rest' diff $data/motion.casts "$dir/plain"
check 'both dimensions proven' grep -q '^certify: 16 certified, 0 uncertified, 0 wrong$' "$dir/err"
check 'the last question counts' is 'stands separated distance=131072' \
  "$("$tool" --cast --distance $data/motion.txt | sed -n 's/^\(stands separated distance=[0-9]*\).*/\1/p')"

# Rays.

check 'rays' status 0 "$tool" --ray --certify $data/motion.txt
for id in bullet stands inside inside2; do
  check "the ray $id is the point's cast" is "$(grep "^$id " $data/motion.casts)" "$(plain <"$dir/out" | grep "^$id ")"
done
check 'a box is no ray' grep -q '^faces error GJK_ERROR_UNSUPPORTED not a ray: B must be a point' "$dir/out"
check 'in the plane neither' grep -q '^faces2 error GJK_ERROR_UNSUPPORTED not a ray: B must be a point' "$dir/out"
check 'no ray is wrong' grep -q ' 0 wrong$' "$dir/err"

# Margins, radii, and what turns.

printf 'case gap\nA box 1.0 1.0 1.0\nB box 1.0 1.0 1.0\nB at 6.0 0.0 0.0\nB to 2.0 0.0 0.0\n' >"$dir/gap.txt"
# fraction OPTIONS...: of the only case
fraction() {
  "$tool" "$@" | sed -n 's/.* fraction=\([0-9]*\) .*/\1/p'
}
check 'contact at the end' is 1073741824 "$(fraction --cast "$dir/gap.txt")"
near() {
  if [ "$1" -gt "$2" ] || [ "$2" -gt "$3" ]; then
    echo "$2 is not between $1 and $3"
    return 1
  fi
}
# 1/2 of the way of 262144 LSB, and 2 LSB before.
check 'a margin' near 536862720 "$(fraction --cast 2.0 "$dir/gap.txt")" 536870912
check 'a margin in LSB' near 1073725440 "$(fraction --cast 2 "$dir/gap.txt")" 1073733632
sed 's/B box 1.0 1.0 1.0/B sphere 1.0/' "$dir/gap.txt" >"$dir/ball.txt"
check 'a ball' near 1073733632 "$(fraction --cast "$dir/ball.txt")" 1073741824
check 'a ball, certified as far as can be' status 0 "$tool" --cast --certify "$dir/ball.txt"
check 'impacts' status 0 "$tool" --impact --certify $data/motion.txt
check 'impacts: none is wrong' grep -q '^certify: 0 certified, 16 uncertified, 0 wrong$' "$dir/err"
check 'impacts: the form' sh -c "! grep -vE '^[^ ]+ (hit lower=[0-9]+ upper=[0-9]+ distance=[0-9]+ (overlap|a=.* b=.* normal=.* at=[-0-9,]+)|miss|open lower=[0-9]+) iterations=[0-9]+ uncertified: ' \"$dir/out\""
# between ID FRACTION: is it between lower, or what it takes to move by 32 LSB of a way of 4 units before, and upper?
between() {
  sed -n "s/^$1 hit lower=\([0-9]*\) upper=\([0-9]*\) .*/\1 \2/p" "$dir/out" |
    awk -v exact="$2" 'NF == 2 { good = $1 <= exact && exact - 150000 <= $1 && $2 <= exact } END { exit !good }'
}
check 'impacts: half of the way' between faces 536870912
check 'impacts: a quarter, both' between both 268435456
check 'impacts: in the plane' between faces2 536870912
check 'impacts: overlap' grep -qE '^inside hit lower=0 upper=0 distance=0 overlap ' "$dir/out"
check 'impacts: miss' grep -qE '^stands miss ' "$dir/out"
# A bar of 6 units turns by 90 degrees in the plane of x and z. Its corner, (0.1, 3.0), meets the edge at (-0.5, 1.0).
printf 'case bar\nA box 1.0 1.0 1.0\nB box 0.1 0.1 3.0\nB at 1.5 0.0 0.0\nB turn-to 0.0 0.707106781 0.0 0.707106781\n' >"$dir/bar.txt"
check 'a bar does not move, for a cast' is 'bar miss' "$("$tool" --cast "$dir/bar.txt" | plain)"
check 'but it turns into the box' grep -q ' hit ' <<END
$("$tool" --impact "$dir/bar.txt")
END
sed 's/B turn-to.*/B spin 0.0 1.5707963 0.0/' "$dir/bar.txt" >"$dir/spin.txt"
lower() {
  "$tool" --impact "$1" | sed -n 's/.* lower=\([0-9]*\) .*/\1/p'
}
check 'a spin is the same turn' near $(($(lower "$dir/bar.txt") - 50000)) "$(lower "$dir/spin.txt")" $(($(lower "$dir/bar.txt") + 50000))
check 'a tolerance' status 0 "$tool" --impact --tolerance 0.01 --certify "$dir/bar.txt"
check 'a margin of an impact' status 0 "$tool" --impact 0.25 --certify "$dir/bar.txt"
check 'a margin comes earlier' near 0 "$(lower "$dir/gap.txt")" 1073741824

# Malformed cases and options.

# malformed LINE 'expected' 'text of the case, printf format'
malformed() {
  # shellcheck disable=SC2059
  printf "$3\ncase last\nA point\nB point\n" >"$dir/bad.txt"
  status 2 "$tool" --cast "$dir/bad.txt" || return 1
  message=$(cat "$dir/err")
  case $message in
    "$dir/bad.txt:$1: expected $2"*) ;;
    *) echo "line $1, expected $2, but: $message"; return 1 ;;
  esac
  is 'last hit fraction=0 at=0,0,0' "$(plain <"$dir/out")"
}

bad() {
  check "malformed: $2: $3" malformed "$@"
}

bad 4 "x y z after 'to': 2 of 3 numbers" 'case x\nA point\nB point\nB to 1 2'
bad 5 "'B to' only once" 'case x\nA point\nB point\nB to 1 2 3\nB to 1 2 3'
bad 4 "x y z w after 'turn-to'" 'case x\nA point\nB point\nA turn-to 0 0 1'
bad 4 "x y z w after 'turn-to': a raw 32-bit integer, or with a decimal point a value from -2.0" \
  'case x\nA point\nB point\nB turn-to 0.0 0.0 0.0 9.0'
bad 4 "x y z after 'spin': a raw" 'case x\nA point\nB point\nB spin fast 0 0'
bad 4 "x y after 'to': 1 of 2 numbers" 'case2 x\nA point\nB point\nB to 1'
bad 4 "c s after 'turn-to'" 'case2 x\nA point\nB point\nB turn-to 1.0'
bad 4 "angle after 'spin'" 'case2 x\nA point\nB point\nB spin'
bad 3 'point, segment' 'case x\nA point\nB move 1 2 3\nB point'

printf 'case far\nA point\nA at -32768.0 0.0 0.0\nA to 32767.0 0.0 0.0\nB point\nB at 32767.0 0.0 0.0\nB to -32768.0 0.0 0.0\n' >"$dir/far.txt"
check 'too long a way' is 'far error GJK_ERROR_RANGE a centre leaves the world on its way, or the way of one against the other is too long' \
  "$("$tool" --cast "$dir/far.txt")"
printf 'case s\nA sphere -1\nB point\n' >"$dir/negative.txt"
check 'a shape that is refused' is 's error GJK_ERROR_NEGATIVE A: a negative radius or half extent' "$("$tool" --cast "$dir/negative.txt")"
check 'help' status 0 "$tool" --help
for word in --cast --ray --impact --tolerance turn-to spin fraction=; do
  check "help has $word" grep -q -e "$word" "$dir/out"
done
check 'a negative margin' status 2 "$tool" --cast -1 "$dir/gap.txt"
check 'a negative margin is named' grep -q "expected a margin of 0 or more after --cast, found '-1'" "$dir/err"
check 'a negative margin of an impact' status 2 "$tool" --impact -1 "$dir/gap.txt"
for tolerance in 0 -1 wide ''; do
  check "tolerance $tolerance" status 2 "$tool" --impact --tolerance "$tolerance" "$dir/gap.txt"
done
check 'no reference' status 2 "$tool" --cast --reference "$dir/gap.txt"
check 'no trace' status 2 "$tool" --impact --trace "$dir/gap.txt"
finish query_motion
