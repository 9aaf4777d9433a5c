#!/bin/sh
# gjk-convert --decompose: samples with known answers, options, what it writes, what it says about files that bound no solid.
# usage: test_decompose_tool.sh BUILD
set -u
. tests/build/count.sh
build=$1
convert=$build/gjk-convert
work=$build/decompose
meshes=tests/data/meshes
rm -rf "$work"
mkdir -p "$work"
awk -f $meshes/torus.awk >"$work/torus.obj"

info() {
  "$convert" --decompose --info "$@" 2>&1
}

# Exact ones, in units and in millimetres.
for scale in --units --millimetres; do
  check "l_bracket $scale" is 'parts=2 excess=0 enclosed=yes' "$(info $scale tests/data/hulls/l_bracket.obj)"
  check "u_channel $scale" is 'parts=3 excess=0 enclosed=yes' "$(info $scale tests/data/hulls/u_channel.obj)"
  check "bracket $scale" is 'parts=9 excess=0 enclosed=yes' "$(info $scale $meshes/bracket.obj)"
done

# The L as a modeller writes it: two faces of six corners that are not convex, from each corner on.
for first in 0 1 2 3 4 5; do
  awk -v first="$first" 'BEGIN {
    n = split("0 0 4 0 4 1 1 1 1 4 0 4", at, " ") / 2
    for (z = 0; z < 2; z++) for (i = 0; i < n; i++) print "v", at[2 * i + 1], at[2 * i + 2], z
    line = "f"; for (i = 0; i < n; i++) line = line " " n + 1 + (first + i) % n
    print line
    line = "f"; for (i = n; i > 0; i--) line = line " " 1 + (first + i) % n
    print line
    for (i = 0; i < n; i++) print "f", 1 + i, 1 + (i + 1) % n, 1 + n + (i + 1) % n, 1 + n + i
  }' >"$work/six.obj"
  check "six corners from $first" is 'parts=2 excess=0 enclosed=yes' "$(info "$work/six.obj")"
done

# Turned so that no coordinate is whole: as many parts, a few LSB.
awk '/^v/ { x = $2 * .8 - $3 * .6; y = $2 * .6 + $3 * .8; printf "v %.6f %.6f %.6f\n", x, y * .28 - $4 * .96, y * .96 + $4 * .28 }
  /^f/' tests/data/hulls/u_channel.obj >"$work/turned.obj"
for scale in --units --millimetres; do
  check "turned $scale" is 'parts=3 enclosed=yes few' "$(info $scale "$work/turned.obj" |
    awk '{ split($2, e, "="); print $1, $3, e[2] < 64 ? "few" : e[2] }')"
done

# A torus: a number of parts, an excess. 10 % above the best arrangement found by hand, which is so many equal sectors.
limits() { # NAME PARTS EXCESS OPTIONS...
  name=$1
  parts=$2
  excess=$3
  shift 3
  check "$name" is 'enclosed=yes few near' "$(info --millimetres "$@" |
    awk -v parts="$parts" -v excess="$excess" '{ split($1, p, "="); split($2, e, "=");
      print $3, p[2] <= parts ? "few" : p[2], e[2] <= excess ? "near" : e[2] }')"
}
limits 'torus, 12 parts' 12 80 --parts 12 "$work/torus.obj"
limits 'torus, one part' 1 1660 --parts 1 "$work/torus.obj"
limits 'torus, 300 LSB' 8 300 --excess 300 "$work/torus.obj"
limits 'rock, 400 LSB' 9 400 --excess 400 $meshes/rock.obj

# C that compiles, and cases that gjk-query answers: the first part overlaps itself and touches its neighbour.
"$convert" --decompose $meshes/bracket.obj >"$work/bracket.c" 2>"$work/told"
${CC:-cc} -std=c99 -Wall -Wextra -Werror -Iinclude -c "$work/bracket.c" -o "$work/bracket.o"
check 'bracket.c compiles' is 0 $?
check 'its parts' is 1 "$(grep -c 'const gjk_compound_part bracket\[9\]' "$work/bracket.c")"
check 'what is told' is 1 "$(grep -c '9 parts, enclosing it, proven' "$work/told")"
check 'as cases' is 'intersecting intersecting' \
  "$("$convert" --decompose --case tests/data/hulls/l_bracket.obj 2>/dev/null | "$build/gjk-query" - |
    awk '{ printf "%s%s", (NR > 1 ? " " : ""), $2 }')"
"$convert" --decompose --info --picture "$work/bracket.svg" $meshes/bracket.obj >/dev/null
check 'a picture' is '0 1' "$? $(grep -c '</svg>' "$work/bracket.svg")"
"$convert" --decompose --info --picture "$work/none/bracket.svg" $meshes/bracket.obj >/dev/null 2>&1
check 'a picture nowhere' is 2 $?

# The C, run: points around the compound are as far from it as from the nearest part that the cases tell.
cat >"$work/run.c" <<'END'
#include <stdio.h>

#include "bracket.c"

int main(void) {
  static gjk_compound_node nodes[GJK_COMPOUND_NODES(9)];
  static const gjk_vec3 corner[1] = {{0, 0, 0}};
  static const gjk_shape point = GJK_HULL(corner, 1);
  gjk_compound compound;
  gjk_collider collider = {0};
  bool good = gjk_compound_build(bracket, 9, nodes, GJK_COMPOUND_NODES(9), &compound) == GJK_OK &&
              gjk_collider_init(&collider, &point, NULL, 0) == GJK_OK;
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  for (long n = 0; n < 64 && good; n++) {
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_distance_result result = {0};
    uint32_t part;
    pose.position.x = (gjk_q16)(n % 4 * 300000 - 100000);
    pose.position.y = (gjk_q16)(n / 4 % 4 * 400000 - 100000);
    pose.position.z = (gjk_q16)(n / 16 * 700000 - 100000);
    good = gjk_collider_pose(&collider, &pose) == GJK_OK &&
           gjk_parts_distance(&body, &collider, &part, &result) == GJK_OK;
    printf("%ld %ld\n", n, (long)result.distance);
  }
  return good ? 0 : 1;
}
END
${CC:-cc} -std=c99 -Wall -Wextra -Werror -Iinclude -I"$work" "$work/run.c" "$build/host/libgjk.a" -o "$work/run"
check 'the program is built' is 0 $?
"$work/run" >"$work/run.txt"
check 'it runs' is 0 $?
"$convert" --decompose --case $meshes/bracket.obj 2>/dev/null | awk '
  /^case/ { part++; taken = 0 }
  /^B/ { taken = 1; sub(/^B/, "A") }
  taken { parts[part] = parts[part] $0 "\n" }
  END {
    for (n = 0; n < 64; n++) for (p = 1; p <= part; p++) {
      printf "case %d\n%sB point\n", n, parts[p]
      printf "B at %d %d %d\n", n % 4 * 300000 - 100000, int(n / 4) % 4 * 400000 - 100000, int(n / 16) * 700000 - 100000
    }
  }' | "$build/gjk-query" - | awk '
  { split($3, d, "="); far = $2 == "separated" ? d[2] + 0 : 0 }
  !($1 in least) || far < least[$1] { least[$1] = far }
  END { for (n = 0; n < 64; n++) print n, least[n] }' >"$work/queried.txt"
check 'distances from the compound' is "$(cat "$work/queried.txt")" "$(cat "$work/run.txt")"
check 'some are apart, some within' is yes "$(awk '{ n[$2 > 0]++ } END { print (n[0] > 2 && n[1] > 30 ? "yes" : n[0]) }' "$work/run.txt")"

# The same with the triangles the other way round, and turned inside out.
grep '^v' $meshes/bracket.obj >"$work/back.obj"
grep '^f' $meshes/bracket.obj | sort -r >>"$work/back.obj"
check 'another order' is "$("$convert" --decompose --name b $meshes/bracket.obj 2>/dev/null | cksum)" \
  "$("$convert" --decompose --name b "$work/back.obj" 2>/dev/null | cksum)"
awk '/^f/ { print "f", $2, $4, $3; next } /^v/' $meshes/bracket.obj >"$work/inside.obj"
check 'inside out' is "$("$convert" --decompose --name b $meshes/bracket.obj 2>/dev/null | cksum)" \
  "$("$convert" --decompose --name b "$work/inside.obj" 2>/dev/null | cksum)"

# No solids: a message, status 2.
refused() { # FILE MESSAGE
  found=$(info "$work/$1")
  check "$1: status" is 2 $?
  check "$1" is "$work/$1$2" "$found"
}
sed '$d' tests/data/hulls/l_bracket.obj >"$work/open.obj"
refused open.obj ': not watertight, so no solid: the edge from (0 0 1966080) to (0 3276800 0) LSB of face 19 has no opposite'

# box FILE LOW HIGH [WAY]: adds a box of 12 triangles between (LOW LOW LOW) and (HIGH HIGH HIGH); WAY -1: turned inwards.
box() {
  awk -v low="$2" -v high="$3" -v way="${4:-1}" 'BEGIN {
    for (i = 0; i < 8; i++) print "v", (i % 2 ? high : low), (int(i / 2) % 2 ? high : low), (i > 3 ? high : low)
    split("1342 5687 1265 3784 1573 2486", side, " ")
    for (i = 1; i <= 6; i++) for (j = 0; j < 2; j++) {
      a = substr(side[i], 1, 1) - 9; b = substr(side[i], 2 + j, 1) - 9; c = substr(side[i], 3 + j, 1) - 9
      print "f", a, (way > 0 ? b : c), (way > 0 ? c : b)
    }
  }' >>"$work/$1"
}

# Shells that cross, lie in each other, or are there twice: their union. What is wound around twice counts once.
box crossing.obj 0 4
box crossing.obj 1 6
check 'two boxes that cross' is 'parts=2 excess=0 enclosed=yes' "$(info "$work/crossing.obj")"
box within.obj 0 4
box within.obj 1 3
check 'a box in a box' is 'parts=1 excess=0 enclosed=yes' "$(info "$work/within.obj")"
box twice.obj 0 4
box twice.obj 0 4
check 'a box twice' is 'parts=1 excess=0 enclosed=yes' "$(info "$work/twice.obj")"
for copy in 1 2 3; do
  box hollow.obj 0 4
  box hollow.obj 1 3 -1
  check "a hollow box $copy times" is 'enclosed=yes excess=0 6 to 8 parts' "$(info "$work/hollow.obj" |
    awk '{ split($1, p, "="); print $3, $2, (p[2] >= 6 && p[2] <= 8 ? "6 to 8 parts" : p[2]) }')"
done
# An excess that so few parts do not reach is told.
check 'excess not reached' is 'LSB instead of 5' "$(info --parts 1 --excess 5 tests/data/hulls/l_bracket.obj | sed -n 's/.*LSB instead/LSB instead/p')"
check 'excess asked for and reached' is '' "$(info --excess 5 "$work/within.obj" | grep instead)"
box sheet.obj 0 4
printf 'f 1 2 3\nf 1 3 2\n' >>"$work/sheet.obj"
check 'a triangle and its back' is 'parts=1 excess=0 enclosed=yes' "$(info "$work/sheet.obj")"
box touching.obj 0 4
printf 'v 2 2 4\nv 1 1 6\nv 3 1 6\nv 2 3 6\nf -4 -2 -3\nf -4 -1 -2\nf -4 -3 -1\nf -3 -2 -1\n' >>"$work/touching.obj"
check 'a corner on a face' is 'parts=2 excess=0 enclosed=yes' "$(info "$work/touching.obj")"
box thin.obj 0 4
printf 'v 2 0 0\nf 1 9 2\nf 9 1 2\nf 1 1 2\n' >>"$work/thin.obj"
check 'triangles without area' is 'parts=1 excess=0 enclosed=yes' "$(info "$work/thin.obj")"
# A tube along a figure of eight crosses itself in the middle.
awk 'BEGIN {
  n = 10; m = 4; turn = 6.283185307179586
  for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
    a = turn * (i + .5) / n; b = turn * j / m; x = 3 * cos(a); y = 4 * cos(2 * a); l = sqrt(x * x + y * y)
    printf "v %.4f %.4f %.4f\n", 3 * sin(a) - .6 * cos(b) * y / l, 2 * sin(2 * a) + .6 * cos(b) * x / l, .6 * sin(b)
  }
  for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
    k = (i + 1) % n * m + 1; l = (j + 1) % m
    print "f", i * m + j + 1, k + j, k + l; print "f", i * m + j + 1, k + l, i * m + l + 1
  }
}' >"$work/eight.obj"
check 'a tube through itself' is 'enclosed=yes' "$(info "$work/eight.obj" | cut -d ' ' -f 3)"

# A shell that is inside out bounds a hole only where another one is around it.
box hole.obj 0 4
box hole.obj 1 3 -1
check 'a hole' is 'parts=6 excess=0 enclosed=yes' "$(info "$work/hole.obj")"
box apart.obj 0 4
box apart.obj 3 6 -1
refused apart.obj ': beside face 3 a shell is turned inwards, with no other one around it'
box double.obj 0 4
printf 'f 1 3 4\n' >>"$work/double.obj"
refused double.obj ': not watertight, so no solid: the edge from (0 0 0) to (0 262144 0) LSB of face 1 has no opposite; face 13 runs along it the same way'
box turned_over.obj 0 4
sed '12s/f \(.*\) \(.*\) \(.*\)/f \1 \3 \2/' "$work/turned_over.obj" >"$work/over.obj"
refused over.obj ': not watertight, so no solid: the edge from (0 0 262144) to (0 262144 262144) LSB of face 4 has no opposite; face 9 runs along it the same way'
awk 'BEGIN {
  print "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1"
  for (i = 0; i < 1025; i++) print "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3"
}' >"$work/many.obj"
refused many.obj ': 4100 triangles, and a solid takes 4096'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n' >"$work/flat.obj"
refused flat.obj ': the surface encloses no volume'
printf '0 0 0\n1 1 1\n' >"$work/points.txt"
refused points.txt ': no triangles, and a solid is made of them'
printf 'v 0 0 0\nv 8191 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >"$work/wide.obj"
refused wide.obj ': the solid is 8191 units wide or more'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 q\n' >"$work/word.obj"
refused word.obj ":3: 'q' is not a number"
for options in '--excess' '--excess -1' '--excess x' '--parts 0' '--parts 1.5' '--parts 1001' '--picture'; do
  # shellcheck disable=SC2086 # words are wanted
  "$convert" --decompose --info $options tests/data/hulls/l_bracket.obj >/dev/null 2>&1
  check "options $options: status" is 2 $?
done

# The picture of three such solids.
make -s demo-parts >"$work/demo.txt" 2>&1
check 'make demo-parts: status' is 0 $?
check 'make demo-parts: the solids' is 3 "$(grep -c ' parts, excess .* contacts$' "$work/demo.txt")"

finish decompose_tool
