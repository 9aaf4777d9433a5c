#!/bin/sh
# The query tool on cases of the plane, and what --trace shows of both dimensions: test_query_plane.sh BUILD
build=$1
tool=$build/gjk-query
data=tests/data
dir=$build/query-plane-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

# Answers known exactly, and the form of each line.

check 'answers all kinds' status 0 "$tool" --penetration $data/plane.txt
sed 's/ a=.*//' "$dir/out" >"$dir/plain"
check 'exact answers' diff $data/plane.expected "$dir/plain"
number='-?[0-9]+'
pair="$number,$number"
grep -vE " error GJK_ERROR_[A-Z]+ A: |^[^ ]+ (separated distance|intersecting depth)=[0-9]+ a=$pair b=$pair normal=$pair iterations=[0-9]+\$" \
  "$dir/out" >"$dir/strange"
check 'the form of each line' diff /dev/null "$dir/strange"
for question in --distance --intersect --penetration '--within 0.5' '--within 3' '--within 0'; do
  # shellcheck disable=SC2086
  check "certified $question" status 0 "$tool" --certify $question $data/plane.txt
  check "all proven $question" grep -q '^certify: 38 certified, 1 uncertified, 0 wrong$' "$dir/err"
done
for question in --distance --penetration; do
  check "the reference $question" status 0 "$tool" --reference --certify $question $data/plane.txt
done
printf 'case space\nA point\nB point\nB at 1 0 0\ncase2 plane\nA point\nB point\nB at 2 0\ncase again\nA point\nB point\n' \
  >"$dir/both.txt"
check 'both dimensions in a file' is 'space separated distance=1,plane separated distance=2,again intersecting iterations=1,' \
  "$("$tool" "$dir/both.txt" | sed 's/ a=.*//' | tr '\n' ',')"
check 'contacts' is '  contact a=65536,-16384 b=65536,-16384 distance=0,  contact a=65536,49152 b=65536,49152 distance=0,' \
  "$(printf 'case2 c\nA box 1.0 1.0\nB box 0.5 0.5\nB at 1.5 0.25\n' | "$tool" --contacts | sed -n 's/ id=.*//p' | sort | tr '\n' ',')"
check 'open' is 'o open iterations=1' \
  "$(printf 'case2 o\nA box 1.0 2.0\nA turn 0.6 0.8\nB box 1.0 1.0\nB at 3.3 1.4\n' | "$tool" --within 0.6 --iterations 1)"

# Malformed cases: one message with file, line and expectation, no answer, and the others are answered.

plain() {
  sed 's/ iterations.*//'
}
word=case2
. tests/build/malformed.sh
bad 4 "'case2 ID' with an ID of 1 to 63" 'case2'
bad 5 'point, segment, triangle, box, polygon, circle' 'case2 x\nA sphere 1\nB point'
bad 5 'point, segment, triangle, box, polygon, circle' 'case2 x\nA\nB point'
bad 5 "hx hy after 'box': 1 of 2 numbers" 'case2 x\nA box 1\nB point'
bad 5 "the end of the line, found '3'" 'case2 x\nA box 1 2 3\nB point'
bad 5 "r h after 'capsule'" 'case2 x\nA capsule 1\nB point'
bad 5 'a number of vertices from 1 to 65535' 'case2 x\nA polygon 0\nB point'
bad 7 'vertex 2 of 3, x y' 'case2 x\nA polygon 3\n1 2\nB point'
bad 7 "vertex 2 of 3, x y, found 'case2'" 'case2 x\nA triangle\n1 2'
bad 6 "x y after 'at'" 'case2 x\nA point\nA at 1\nB point'
bad 6 "c s after 'turn': a raw 32-bit integer, or with a decimal point a value from -2.0" \
  'case2 x\nA point\nA turn 2.0 0.0\nB point'
bad 7 "'A turn' only once" 'case2 x\nA point\nA turn 1.0 0.0\nA turn 1.0 0.0\nB point'
bad 7 'one shape for B' 'case2 x\nA point\nB point\nB box 1 1'
bad 6 "'B KIND ...'" 'case2 x\nA point'
bad 8 "a radius and 'round' of A" 'case2 x\nA circle 20000.0\nA round 20000.0\nB point'

# The trace has as many iterations as the answer, and ends as the answer does.

# traced OPTION... FILE: says where they differ.
traced() {
  "$tool" --trace "$@" >"$dir/traced" || return 1
  awk '
    function ends() {
      if (id == "" || refused) return
      if (lines != wanted || stops != 1 || (together != stopped_together && stop != "limit")) {
        print id, lines " iterations instead of " wanted, stop; bad = 1
      }
      traces++
    }
    /^[^ ]/ {
      ends()
      id = $1
      refused = $2 == "error"
      together = $2 == "intersecting" || $2 == "within"
      wanted = $0; sub(/.*iterations=/, "", wanted); sub(/ .*/, "", wanted)
      lines = stops = 0
    }
    /^  iteration / { if ($2 != ++lines) { print id, "iteration", $2; bad = 1 } }
    # The query took another way: it says how many iterations that took.
    /^  walk / { if ($2 + 0 != wanted) { print id, "walk", $2; bad = 1 } wanted = lines; walks++ }
    /^  stop / {
      stops++
      stop = $2; sub(/:$/, "", stop)
      stopped_together = stop == "enclosing" || stop == "near"
    }
    END { ends(); exit bad || traces == 0 }' "$dir/traced"
}
# Radii may make two cores that are nearest within them intersect: that is told after the search.
grep -v '^#' $data/trackers.txt >"$dir/trackers.txt"
for question in --distance --intersect '--within 0.5'; do
  # shellcheck disable=SC2086
  check "trace of trackers $question" traced $question "$dir/trackers.txt"
  # shellcheck disable=SC2086
  check "trace of the plane $question" traced $question $data/plane.txt
  # shellcheck disable=SC2086
  check "trace of plain cases $question" traced $question $data/query.txt
done
check 'a long search' traced $data/worst.txt
check 'a trace does not change the answers' is "$("$tool" $data/plane.txt | cksum)" \
  "$("$tool" --trace $data/plane.txt | grep '^[^ ]' | cksum)"
step='d=[-0-9,]+ A[0-9]+=[-0-9,]+ B[0-9]+=[-0-9,]+ w[0-9]+=[-0-9,]+ before=[w0-9,-]+ after=[w0-9,-]+'
check 'the form of an iteration' is 4 "$("$tool" --trace $data/trace.txt | sed -n '2,5p' | grep -cE "^  iteration [1-4] $step\$")"
check 'the reason' grep -q '^  stop nearest: no vertex of A - B is nearer' "$dir/traced"
check 'pairs of the page are not walked' sh -c "! \"$tool\" --trace $data/trace.txt | grep '^  walk'"
# w is the difference of the support points.
check 'a vertex is a difference' sh -c "\"$tool\" --trace $data/plane.txt | awk '
  /^  iteration/ {
    split(\$4, a, /[=,]/); split(\$5, b, /[=,]/); split(\$6, w, /[=,]/); n++
    if (a[2] - b[2] != w[2] || a[3] - b[3] != w[3]) { print; bad = 1 }
  }
  END { exit bad || n < 50 }'"

# The picture: a panel for each iteration, and one around the origin where shapes of the plane almost touch.

# drawn PANELS FILE
drawn() {
  "$tool" --trace-svg "$dir/trace.svg" "$2" >/dev/null || return 1
  is "$1" "$(grep -c 'class="panel"' "$dir/trace.svg")" || return 1
  ! grep -nE 'nan|inf[^o]' "$dir/trace.svg" || return 1
  opened=$(grep -oE '<[a-zA-Z]' "$dir/trace.svg" | wc -l)
  closed=$(grep -oE '</|/>' "$dir/trace.svg" | wc -l)
  test "$opened" = "$closed" || { echo "$opened elements, $closed ends"; return 1; }
}
# panels FILE: iterations of its traces
panels() {
  "$tool" --trace "$1" | grep -c '^  iteration'
}
check 'the picture of all kinds' drawn "$(panels $data/query.txt)" $data/query.txt
check 'the picture of trackers' drawn "$(panels "$dir/trackers.txt")" "$dir/trackers.txt"
printf 'case2 c\nA box 1.0 1.0\nB box 0.5 0.5\nB at 1.5 1.5\n' >"$dir/corner.txt"
check 'the picture of a touch has a panel more' drawn $(($(panels "$dir/corner.txt") + 1)) "$dir/corner.txt"
check 'it magnifies' grep -q 'Around the origin' "$dir/trace.svg"
printf 'case2 c\nA box 1.0 1.0\nB box 0.5 0.5\nB at 1.6 1.6\n' >"$dir/apart.txt"
check 'the picture of a gap has not' drawn "$(panels "$dir/apart.txt")" "$dir/apart.txt"
printf 'case2 <&>\nA ellipse 1.0 0.5\nB capsule 0.25 0.5\nB at 2.0 0.0\n' >"$dir/escaped.txt"
check 'curved shapes, and names are escaped' drawn "$(panels "$dir/escaped.txt")" "$dir/escaped.txt"
check 'names are escaped' grep -q '&lt;&amp;&gt;: separated' "$dir/trace.svg"
check 'a picture that cannot be written' status 2 "$tool" --trace-svg "$dir" "$dir/gap.txt"
check 'a picture without a name' status 2 "$tool" --trace-svg
check 'the page' sh tests/build/demo-trace.sh "$build" $data/trace.txt
check 'the page has all pairs' is "$(grep -c '^case' $data/trace.txt)" "$(grep -c '<figure>' "$build/trace.html")"
check 'the page says where double is wrong' is 2 "$(grep -c 'WRONG: the other answer is proven' "$build/trace.html")"
check 'the page is one file' sh -c "! grep -qE '(src|href)=' \"$build/trace.html\""
check 'help' status 0 "$tool" --help
for word in case2 --trace --trace-svg 'ellipse rx ry'; do
  check "help has $word" grep -q -e "$word" "$dir/out"
done

finish query-plane
