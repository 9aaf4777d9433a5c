#!/bin/sh
# The query tool: test_query.sh BUILD
build=$1
tool=$build/gjk-query
data=tests/data
dir=$build/query-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

# Without what may change with the way to an answer.
plain() {
  sed 's/ normal=[-0-9,]*//; s/ iterations=[0-9]*//'
}

# The answers of a file, in units or raw, from a file or a pipe, with any end of line.

check 'answers all kinds' status 0 "$tool" $data/query.txt
plain <"$dir/out" >"$dir/plain"
check 'answers known by hand' diff $data/query.expected "$dir/plain"
mv "$dir/out" "$dir/answers"
number='-?[0-9]+'
triple="$number,$number,$number"
grep -vE ' error GJK_ERROR_[A-Z]+ [AB]: ' "$dir/answers" >"$dir/lines"
points="a=$triple b=$triple normal=$triple"
grep -vE "^[^ ]+ separated distance=[0-9]+ $points iterations=[0-9]+( saturated)?\$" "$dir/lines" | grep -vE '^[^ ]+ intersecting iterations=[0-9]+$' >"$dir/strange"
check 'the form of each line' diff /dev/null "$dir/strange"

sed 's/$/\r/' $data/query.txt >"$dir/crlf.txt"
check 'CRLF' status 0 "$tool" "$dir/crlf.txt"
check 'CRLF: the same answers' diff "$dir/answers" "$dir/out"
{ printf '\357\273\277'; sed 's/ /\t  /g; s/$/ \t/' $data/query.txt; printf '\n\n'; } >"$dir/tabs.txt"
check 'byte order mark, tabs, trailing blanks' status 0 "$tool" "$dir/tabs.txt"
check 'tabs: the same answers' diff "$dir/answers" "$dir/out"
check 'standard input' status 0 sh -c "\"$tool\" <$data/query.txt"
check 'standard input: the same answers' diff "$dir/answers" "$dir/out"
cat "$dir/answers" "$dir/answers" "$dir/answers" >"$dir/thrice"
check 'several files' status 0 sh -c "\"$tool\" $data/query.txt - -- \"$dir/crlf.txt\" <$data/query.txt"
check 'several files: the same answers' diff "$dir/thrice" "$dir/out"
printf 'case a\nA point\nB point\nB at 1 0 0' >"$dir/no-newline.txt"
check 'no newline at the end' status 0 "$tool" "$dir/no-newline.txt"
check 'no newline: answered' grep -q '^a separated distance=1 ' "$dir/out"
check 'empty input' status 0 "$tool" /dev/null
check 'empty input: no answer' diff /dev/null "$dir/out"

# Questions.

answer() {
  "$tool" "$@" | sed 's/ iterations=[0-9]*$//'
}
printf 'case gap\nA sphere 1.0\nB box 1.0 1.0 1.0\nB at 3.0 0.0 0.0\n' >"$dir/gap.txt"
printf 'case gap\nA box 1.0 2.0 0.5\nA turn 0.0 0.6 0.0 0.8\nB hull 4\n0 0 0\n9.0 0 0\n0 9.0 0\n0 0 9.0\nB at 1.5 -1.0 1.0\n' >"$dir/boxes.txt"
check 'intersect' is 'gap separated' "$(answer --intersect "$dir/gap.txt")"
check 'just not within' is 'gap beyond' "$(answer --within 65535 "$dir/gap.txt")"
check 'just within' is 'gap within' "$(answer "$dir/gap.txt" --within 65536)"
check 'within in units' is 'gap within' "$(answer --within 1.0 "$dir/gap.txt")"
check 'within 0' is 'gap beyond' "$(answer --within 0 "$dir/gap.txt")"
check 'within, open after an iteration' is 'gap open' "$(answer --within 1.0 --iterations 1 "$dir/boxes.txt")"
check 'within, settled after three' is 'gap beyond' "$(answer --iterations 3 --within 1.0 "$dir/boxes.txt")"
check 'within, settled by the spheres' is 'gap beyond iterations=0' "$("$tool" --within 1 --iterations 1 "$dir/gap.txt")"
check 'open is not certified' is 'gap open iterations=1 uncertified: open after 1 iterations' \
  "$("$tool" --certify --within 1.0 --iterations 1 "$dir/boxes.txt")"
check 'settled is' is 'gap beyond iterations=3' "$("$tool" --certify --within 1.0 --iterations 9 "$dir/boxes.txt")"
check 'the last question counts' is 'gap separated' "$(answer --within 9.0 --intersect "$dir/gap.txt")"
sed 's/3.0/2.0/' "$dir/gap.txt" >"$dir/touch.txt"
check 'touching: intersect' is 'gap intersecting' "$(answer --intersect "$dir/touch.txt")"
check 'touching: within 0' is 'gap within' "$(answer --within 0 "$dir/touch.txt")"
check 'touching: distance' is 'gap intersecting' "$(answer --distance "$dir/touch.txt")"

check 'penetration' is 'deep intersecting depth=98304 a=65536,0,0 b=-32768,0,0 normal=1073741824,0,0' \
  "$(printf 'case deep\nA sphere 1.0\nB sphere 1.0\nB at 0.5 0.0 0.0\n' | answer --penetration)"
printf 'case pair\nA box 1.0 1.0 1.0\nB box 0.5 0.5 1.0\nB at 0 0 131172\n' >"$dir/contacts.txt"
corners() {
  "$tool" --contacts "$@" "$dir/contacts.txt" |
    grep -c '^  contact a=-*32768,-*32768,65536 b=-*32768,-*32768,65636 distance=100 id='
}
check 'contacts' is 4 "$(corners 0.01)"
check 'contacts, too far apart' is 0 "$(corners 99)"
check 'contacts below the line of the distance' is "$(answer "$dir/contacts.txt")" \
  "$(answer --contacts "$dir/contacts.txt")"
cube='A hull 8
-1.0 -1.0 -1.0
1.0 -1.0 -1.0
-1.0 1.0 -1.0
1.0 1.0 -1.0
-1.0 -1.0 1.0
1.0 -1.0 1.0
-1.0 1.0 1.0
1.0 1.0 1.0'
faces='A faces 6
0 4 6 2
1 3 7 5
0 1 5 4
2 6 7 3
0 2 3 1
4 5 7 6  # the top'
beside='B box 0.5 0.5 0.5
B at 1.25 0.0 0.25'
# points FACES: contacts of the cube and a box that reaches a quarter into it
points() {
  printf 'case cube\n%s\n%s\n%s\n' "$cube" "$1" "$beside" | "$tool" --contacts |
    grep -c '^  contact a=65536,-*32768,[-0-9]* b=49152,-*32768,[-0-9]* distance=-16384 id='
}
check 'contacts of a hull with faces' is 4 "$(points "$faces")"
check 'contacts of a hull without' is 1 "$(printf 'case cube\n%s\n%s\n' "$cube" "$beside" | "$tool" --contacts | grep -c contact)"
# refused_faces LINES: is the case refused with this message?
refused_faces() {
  printf 'case cube\n%s\n%s\n%s\n' "$cube" "$1" "$beside" | "$tool" --contacts 2>&1 | grep -q "$2"
}
check 'faces: none' refused_faces 'A faces 0' 'expected a number of faces'
check 'faces: too few lines' refused_faces 'A faces 2
0 4 6 2' "expected face 2: up to 12 vertex numbers, found 'B'"
check 'faces: too many corners' refused_faces 'A faces 1
0 1 2 3 4 5 6 7 0 1 2 3 4' "expected face 1: up to 12 vertex numbers, found '4'"
check 'faces: of two corners' refused_faces 'A faces 1
0 1' 'cube error GJK_ERROR_'
check 'faces: of a vertex that is not there' refused_faces 'A faces 1
0 1 8' 'cube error GJK_ERROR_'
check 'faces: of a box' sh -c "printf 'case box\nA box 1 1 1\nA faces 1\n0 1 2\nB point\n' | '$tool' 2>&1 | grep -q \"expected 'A hull\""
check 'a negative margin' status 2 "$tool" --contacts -1 "$dir/contacts.txt"
check 'penetration, apart' is "$(answer "$dir/gap.txt")" "$(answer --penetration "$dir/gap.txt")"

# Depths known by hand; of the curved pair, within 4 LSB.

for who in '' --reference; do
  # shellcheck disable=SC2086
  check "depths certified $who" status 0 "$tool" --penetration --certify $who $data/query.txt
  check "depths proven $who" grep -q '^certify: 15 certified, 4 uncertified, 0 wrong$' "$dir/err"
  grep -v '^cylinder-in-box ' "$dir/out" | plain | sed 's/ uncertified.*//' >"$dir/plain"
  check "depths $who" diff $data/query.depths "$dir/plain"
  check "depth of a curved pair $who" grep -qE '^cylinder-in-box intersecting depth=327(6[4-9]|7[0-2]) ' "$dir/out"
done
check 'depths of trackers' status 0 "$tool" --penetration --certify $data/trackers.txt
check 'depths of trackers proven' grep -q '^certify: 33 certified, 0 uncertified, 0 wrong$' "$dir/err"
check 'a depth of trackers' grep -q '^c009 intersecting depth=6554 ' "$dir/out"
check 'the reference on depths of trackers' status 1 "$tool" --penetration --reference --certify $data/trackers.txt
check 'the reference on depths is mostly right' \
  grep -qE '^certify: (2[89]|3[0-2]) certified, 0 uncertified, [1-5] wrong' "$dir/err"

# The reported failures of other libraries, certified; double is wrong about some, and the tool says so.

for question in --distance --intersect '--within 0.5' '--within 3'; do
  # shellcheck disable=SC2086
  check "trackers certified $question" status 0 "$tool" --certify $question $data/trackers.txt
  check "trackers all proven $question" grep -q '^certify: 33 certified, 0 uncertified, 0 wrong$' "$dir/err"
done
check 'trackers certified' status 0 "$tool" --certify $data/trackers.txt
cp "$dir/out" "$dir/certified"
check 'trackers' status 0 "$tool" $data/trackers.txt
check 'a proof adds nothing to the line' diff "$dir/out" "$dir/certified"
awk '/^case/ {id = $2} /^# exact/ {
  print id, ($3 == "separated" ? "separated distance=" sprintf("%d", $4 + 0.5) : "intersecting")
}' $data/trackers.txt >"$dir/exact"
sed 's/\( distance=[0-9]*\) .*/\1/; s/ iterations.*//' "$dir/certified" >"$dir/brief"
check 'trackers as stated in the file' diff "$dir/exact" "$dir/brief"

check 'the reference on trackers' status 1 "$tool" --reference --certify $data/trackers.txt
check 'the reference is caught' \
  grep -qE '^c049 separated distance=0 .* WRONG: the other answer is proven$' "$dir/out"
check 'the reference is mostly right' \
  grep -qE '^certify: (2[89]|3[0-2]) certified, 0 uncertified, [1-5] wrong' "$dir/err"
check 'the reference on plain cases' status 0 "$tool" --reference --certify $data/query.txt
plain <"$dir/out" | sed 's/ uncertified.*//' >"$dir/plain"
check 'the reference agrees' diff $data/query.expected "$dir/plain"
check 'curved shapes' status 0 "$tool" --certify $data/query.txt
check 'curved shapes say so' sh -c "[ \$(grep -c ' uncertified: curved; ' \"$dir/out\") = 4 ]"
check 'the far pair is proven' grep -q '^certify: 15 certified, 4 uncertified, 0 wrong$' "$dir/err"
printf 'case t\nA cylinder 1.0 1.0\nB cylinder 1.0 1.0\nB at 2.0 0.0 0.0\n' >"$dir/zero.txt"
for question in --distance --penetration; do
  check "touching, certified $question" status 0 "$tool" --certify $question "$dir/zero.txt"
  check "touching $question: the bounds are told" grep -q 'accurate bounds are -*0\.[01] to 0\.0$' "$dir/out"
  check "touching $question: no zero has a sign" sh -c "! grep -q -e '-0\.0' \"$dir/out\""
done

# Malformed cases: one message with file, line and expectation, no answer, and the others are answered.

word=case
. tests/build/malformed.sh
bad 4 "'case ID'" 'case'
long=0123456789012345678901234567890123456789012345678901234567890123
bad 4 "'case ID' with an ID of 1 to 63" "case $long\\nA point\\nB point"
bad 5 'point, segment' 'case x\nA cube 1 1 1\nB point'
bad 5 'point, segment' 'case x\nA\nB point'
bad 5 "'A ...', 'B ...' or 'case ID', found 'C'" 'case x\nC point\nB point'
bad 6 "'A ...', 'B ...' or 'case ID', found '1'" 'case x\nA point\n1 2 3\nB point'
bad 6 'one shape for A' 'case x\nA point\nA point\nB point'
bad 7 'one shape for B' 'case x\nA point\nB point\nB box 1 1 1'
bad 6 "'B KIND ...'" 'case x\nA point'
bad 7 "'A KIND ...'" 'case x\nB point\nA at 1 2 3'
bad 5 'hx hy hz' 'case x\nA box 1 1\nB point'
bad 5 "the end of the line, found '4'" 'case x\nA box 1 2 3 4\nB point'
bad 5 "the end of the line, found 'here'" 'case x\nA point here\nB point'
bad 5 "r after 'sphere'" 'case x\nA sphere\nB point'
bad 5 "r h after 'capsule'" 'case x\nA capsule 1\nB point'
bad 5 "r after 'sphere': a raw 32-bit integer" 'case x\nA sphere big\nB point'
bad 5 "r after 'sphere': a raw 32-bit integer" 'case x\nA sphere 2147483648\nB point'
bad 5 "r after 'sphere': a raw 32-bit integer" 'case x\nA sphere 32768.0\nB point'
bad 5 "r after 'sphere': a raw 32-bit integer" 'case x\nA sphere 1e3\nB point'
bad 5 "r after 'sphere': a raw 32-bit integer" 'case x\nA sphere 1\0002\nB point'
bad 6 "x y z w after 'turn': a raw 32-bit integer, or with a decimal point a value from -2.0" \
  'case x\nA point\nA turn 0.0 0.0 0.0 2.0\nB point'
bad 6 'x y z w' 'case x\nA point\nA turn 0 0 1\nB point'
bad 7 "'A at' only once" 'case x\nA point\nA at 1 2 3\nA at 1 2 3\nB point'
bad 7 "'A round' only once" 'case x\nA point\nA round 1\nA round 1\nB point'
bad 7 "'A turn' only once" 'case x\nA point\nA turn 0.0 0.0 0.0 1.0\nA turn 0.0 0.0 0.0 1.0\nB point'
bad 8 "a radius and 'round' of A" 'case x\nA sphere 20000.0\nA round 20000.0\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case x\nA hull 0\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case x\nA hull -3\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case x\nA hull 65536\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case x\nA hull 4.0\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case x\nA hull\nB point'
bad 7 'vertex 2 of 3, x y z' 'case x\nA hull 3\n1 2 3\nB point'
bad 7 'vertex 2 of 3, x y z: 2 of 3 numbers' 'case x\nA triangle\n1 2 3\n1 2\n1 2 3\nB point'
bad 6 "vertex 1 of 3, x y z, found 'case'" 'case x\nA triangle'
bad 7 'the end of the line' 'case x\nA hull 2\n1 2 3\n1 2 3 4\nB point'
blanks=$(awk 'BEGIN {printf "%1100s", ""}')
bad 5 'a line of at most 1023 characters' "case x\\nA point $blanks 1\\nB point"

printf 'A point\nB point\ncase a\nA point\nB hull 2\n1 2 3\n' >"$dir/both.txt"
check 'two malformed' status 2 "$tool" "$dir/both.txt"
check 'before the first case' grep -q "/both.txt:1: expected 'case ID'" "$dir/err"
check 'at the end of the file' grep -q '/both.txt:6: expected vertex 2 of 2, x y z, found the end of' "$dir/err"
check 'two messages' is 2 "$(wc -l <"$dir/err" | tr -d ' ')"
check 'a long comment' sh -c "printf '# $blanks x\ncase a $blanks x\nA point\nB point\n' | \"$tool\""

# Files and options.

check 'a missing file' status 2 "$tool" "$dir/none.txt" "$dir/gap.txt"
check 'a missing file is named' grep -q '/none.txt: ' "$dir/err"
check 'the next file is answered' grep -q '^gap separated' "$dir/out"
check 'a folder' status 2 "$tool" "$dir"
check 'a folder is named, and what is wrong with it' grep -q "^$dir: cannot be read: [^ ].*directory" "$dir/err"
check 'help' status 0 "$tool" --help
for word in --intersect --within --iterations --distance --penetration --contacts --reference --certify ellipsoid 'Exit status'; do
  check "help has $word" grep -q -e "$word" "$dir/out"
done
check 'an unknown option' status 2 "$tool" --fast
check 'an unknown option is named' grep -q -e '--fast' "$dir/err"
check 'within without a distance' status 2 "$tool" --within
for iterations in 0 256 -1 one ''; do
  check "iterations $iterations" status 2 "$tool" --within 1 --iterations "$iterations" "$dir/gap.txt"
done
check 'within a word' status 2 "$tool" --within far "$dir/gap.txt"
check 'within a negative distance' status 2 "$tool" --within -1 "$dir/gap.txt"
if [ -e /dev/full ]; then
  check 'answers that cannot be written' status 2 sh -c "\"$tool\" $data/query.txt >/dev/full"
  check 'help that cannot be written' status 2 sh -c "\"$tool\" --help >/dev/full"
fi

# 100,000 cases under a limit on memory that a leak of one hull per case would burst.

awk 'BEGIN {
  srand(7)
  for (c = 0; c < 100; c++) {
    printf "case c%d\nA hull 12\n", c
    for (i = 0; i < 12; i++) printf "%d %d %d\n", rand() * 90000, rand() * 90000, rand() * 90000
    printf "B box 1.0 0.5 0.25\nB at %d 0 0\n", rand() * 300000
  }
}' >"$dir/hundred.txt"
"$tool" "$dir/hundred.txt" >"$dir/hundred"
awk '{text = text $0 "\n"} END {for (i = 0; i < 1000; i++) printf "%s", text}' "$dir/hundred.txt" \
  >"$dir/stream.txt"
check 'few cases under the limit' status 0 sh -c "ulimit -v 16384; \"$tool\" \"$dir/hundred.txt\""
check '100,000 cases in constant memory' status 0 sh -c "ulimit -v 16384; \"$tool\" <\"$dir/stream.txt\""
check '100,000 answers' is 100000 "$(wc -l <"$dir/out" | tr -d ' ')"
sort -u "$dir/out" >"$dir/unique"
sort "$dir/hundred" >"$dir/sorted"
check 'no answer depends on the cases before' diff "$dir/sorted" "$dir/unique"
separated=$(grep -c ' separated ' "$dir/hundred")
check 'the stream has both answers' test "$separated" -gt 20 -a "$separated" -lt 80
rm -f "$dir/stream.txt" "$dir/out"

finish query
