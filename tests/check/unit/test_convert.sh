#!/bin/sh
# gjk-convert: exact answers of point sets, each format, what it writes, and what it says about broken files.
# usage: test_convert.sh BUILD
set -u
. tests/build/count.sh
build=$1
convert=$build/gjk-convert
work=$build/convert
rm -rf "$work"
mkdir -p "$work"

# Sets that break hull builders with tolerances; their exact answers.
while read -r name expected; do
  check "$name" is "$expected" "$("$convert" --hull --info "tests/data/hulls/$name.txt")"
done <tests/data/hulls/expected
check 'all samples are in the list' is "$(find tests/data/hulls -name '*.txt' | wc -l)" "$(wc -l <tests/data/hulls/expected)"

# One tetrahedron in each format.
cat >"$work/t.obj" <<END
# a tetrahedron
v 0 0 0
v 1 0 0 1.0
v 0 2.5e-1 0
v 0 0 -0.5
vn 0 0 1
f 1 2 3
f 1//1 4/2/1 -3/1
f 2 4 \\
  3
f 1 3 4
END
cat >"$work/t.off" <<END
OFF 4 4 6 # counts
0 0 0
1 0 0

0 0.25 0
0 0 -0.5
3 0 1 2 255 0 0
3 0 3 1
3 1 3 2
3 0 2 3
END
cat >"$work/t.ply" <<END
ply
format ascii 1.0
comment a tetrahedron
element vertex 4
property float x
property float y
property uchar red
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 9 0
1 0 9 0
0 0.25 9 0
0 0 9 -0.5
3 0 1 2
3 0 3 1
3 1 3 2
3 0 2 3
END
{
  echo 'solid t'
  for corners in '0 0 0,1 0 0,0 .25 0' '0 0 0,0 0 -.5,1 0 0' '1 0 0,0 0 -.5,0 .25 0' '0 0 0,0 .25 0,0 0 -.5'; do
    echo 'facet normal 0 0 0'
    echo '  outer loop'
    echo "$corners" | tr ',' '\n' | sed 's/^/    vertex /'
    echo '  endloop'
    echo 'endfacet'
  done
  echo 'endsolid t'
} >"$work/t.stl"

# Bytes of floats: 0, 1, 0.25, -0.5, little-endian and big-endian.
zero='\000\000\000\000'
one='\000\000\200\077'
quarter='\000\000\200\076'
half='\000\000\000\277'
point0=$zero$zero$zero
point1=$one$zero$zero
point2=$zero$quarter$zero
point3=$zero$zero$half
{
  head -c 80 /dev/zero
  printf '\004\000\000\000'
  for points in "$point0$point1$point2" "$point0$point3$point1" "$point1$point3$point2" "$point0$point2$point3"; do
    printf '%b' "$zero$zero$zero$points\\000\\000"
  done
} >"$work/bytes.stl"
ply_header() { # FORMAT
  printf 'ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n' "$1"
  printf 'element face 4\nproperty list uchar ushort vertex_index\nend_header\n'
}
{
  ply_header binary_little_endian
  printf '%b' "$point0$point1$point2$point3"
  printf '\003\000\000\001\000\002\000\003\000\000\003\000\001\000\003\001\000\003\000\002\000\003\000\000\002\000\003\000'
} >"$work/little.ply"
{
  ply_header binary_big_endian
  printf '\000\000\000\000\000\000\000\000\000\000\000\000\077\200\000\000\000\000\000\000\000\000\000\000'
  printf '\000\000\000\000\076\200\000\000\000\000\000\000\000\000\000\000\000\000\000\000\277\000\000\000'
  printf '\003\000\000\000\001\000\002\003\000\000\000\003\000\001\003\000\001\000\003\000\002\003\000\000\000\002\000\003'
} >"$work/big.ply"

# Six times its volume: 1 times 1/4 times 1/2 unit, in LSB.
volume=35184372088832
for file in t.obj t.off t.ply little.ply big.ply; do
  check "$file" is "points=4 vertices=4 faces=4 volume6=$volume watertight=yes" "$("$convert" --info "$work/$file")"
done
for file in t.stl bytes.stl; do
  check "$file" is "points=12 vertices=4 faces=4 volume6=$volume watertight=yes" "$("$convert" --info "$work/$file")"
done
# Lines that end otherwise, and a byte order mark before the first one.
tr '\n' '\r' <"$work/t.obj" >"$work/cr.obj"
awk '{ printf "%s\r\n", $0 }' "$work/t.obj" >"$work/crlf.obj"
{ printf '\357\273\277' && sed 1d "$work/t.obj"; } >"$work/mark.obj"
tr '[:lower:]' '[:upper:]' <"$work/t.stl" >"$work/upper.stl"
check 'upper.stl' is "points=12 vertices=4 faces=4 volume6=$volume watertight=yes" "$("$convert" --info "$work/upper.stl")"
for file in cr.obj crlf.obj mark.obj; do
  check "$file" is "points=4 vertices=4 faces=4 volume6=$volume watertight=yes" "$("$convert" --info "$work/$file")"
done
sed '$d' "$work/t.obj" >"$work/open.obj"
check 'open' is "points=4 vertices=4 faces=4 volume6=$volume watertight=no" "$("$convert" --info "$work/open.obj")"
awk -f tests/data/meshes/torus.awk >"$work/torus.obj"
for mesh in tests/data/hulls/l_bracket.obj "$work/torus.obj" tests/data/hulls/u_channel.obj; do
  check "$mesh" is 'watertight=yes' "$("$convert" --millimetres --info "$mesh" | sed 's/.* //')"
done
printf '0 0 0\n7 7 7\n3 3 3\n' >"$work/line.txt"
check 'a line' is 'points=3 vertices=2 faces=0 volume6=0 watertight=no' "$("$convert" --info "$work/line.txt")"

# C that compiles, and a case that gjk-query answers: the hull touches itself moved by its own length.
for name in cyl32 dup_cube4 ico2_20lsb; do
  "$convert" "tests/data/hulls/$name.txt" >"$work/$name.c" 2>/dev/null
  ${CC:-cc} -std=c99 -Wall -Wextra -Werror -Iinclude -c "$work/$name.c" -o "$work/$name.o"
  check "$name.c compiles" is 0 $?
  check "$name as a case" is "$name intersecting" \
    "$("$convert" --case "tests/data/hulls/$name.txt" 2>/dev/null | "$build/gjk-query" - | sed "s/ iterations.*//")"
done
# The constants have the same bits as the hull that is built where they are compiled, and a table that is proven; here, with
# 32 bits, and big-endian.
cat >"$work/same.c" <<END
#include <stdio.h>
#include <string.h>
#include "gjk/hull.h"
#include "gjk/table.h"
extern const gjk_shape shape;
int main(void) {
  static gjk_vec3 vertex[256];
  static uint32_t workspace[GJK_HULL_WORKSPACE(256) / 4];
  static uint16_t corner[2000], end[1000];
  const gjk_hull_faces *given = shape.faces;
  gjk_hull hull;
  gjk_hull_faces faces;
  gjk_hull_report report;
  if (gjk_hull_build(shape.vertices, shape.count, workspace, sizeof workspace, &hull) != GJK_OK ||
      gjk_hull_vertices(&hull, vertex, 256) != GJK_OK ||
      gjk_hull_write_faces(&hull, corner, 2000, end, 1000, &faces) != GJK_OK ||
      gjk_hull_check(shape.vertices, shape.count, given, &report) != GJK_OK) {
    return 1;
  }
  printf("%d %d %d %d fault %d table %d\\n", hull.vertices == shape.count, faces.count == given->count,
         memcmp(vertex, shape.vertices, shape.count * sizeof vertex[0]) == 0,
         memcmp(end, given->end, given->count * sizeof end[0]) == 0 &&
             memcmp(corner, given->corner, end[given->count - 1] * sizeof corner[0]) == 0,
         report.fault, gjk_hull_table_check(shape.vertices, shape.count, shape.user));
  return 0;
}
END
# same_constants NAME COMPILER EMULATOR: prints what the program says of the hull of a file
same_constants() {
  # shellcheck disable=SC2086 # a compiler with its options
  $2 -std=c99 -O1 -Iinclude "$work/same.c" "$work/$1.c" src/hull/*.c src/arith/*.c src/shape/*.c src/gjk/*.c -o "$work/same" 2>&1 &&
    $3 "$work/same"
}
for name in cyl32 cell44_0 dup_cube4; do
  "$convert" --table 1 --name shape "tests/data/hulls/$name.txt" >"$work/$name.c" 2>/dev/null
  check "$name: constants" is '1 1 1 1 fault 0 table 0' "$(same_constants "$name" "${CC:-cc}" '')"
done
for linux in i686:i386 s390x:s390x; do
  if command -v "${linux%:*}-linux-gnu-gcc" >/dev/null && command -v "qemu-${linux#*:}" >/dev/null; then
    check "cell44_0: constants on ${linux%:*}" is '1 1 1 1 fault 0 table 0' \
      "$(same_constants cell44_0 "${linux%:*}-linux-gnu-gcc -static" "qemu-${linux#*:}")"
  else
    skip "constants on ${linux%:*}" "gcc-${linux%:*}-linux-gnu qemu-user"
  fi
done
if command -v arm-none-eabi-gcc >/dev/null; then
  arm-none-eabi-gcc -std=c99 -mcpu=cortex-m3 -mthumb -Wall -Wextra -Werror -Iinclude -c "$work/cell44_0.c" -o "$work/cell44_0.o"
  check 'constants are in flash on Cortex-M3' is 0 \
    "$(arm-none-eabi-size -A "$work/cell44_0.o" | awk '$1 ~ /^\.(data|bss)/ { n += $2 } END { print n + 0 }')"
else
  skip 'constants on Cortex-M3' gcc-arm-none-eabi
fi

# At most so many vertices, and what is said of them.
"$convert" --vertices 16 --name shape tests/data/hulls/cyl32.txt >"$work/simple.c" 2>"$work/said"
check 'at most 16 vertices' is 'static const gjk_vec3 shape_vertices[16] = {' "$(grep gjk_vec3 "$work/simple.c")"
check 'what is said of 16' is 1 "$(grep -c 'all points are enclosed, exactly; the vertices reach at most [0-9]* LSB beyond' "$work/said")"
check 'as many vertices as there are' is "$("$convert" --name a tests/data/hulls/cell44_0.txt 2>/dev/null | cksum)" \
  "$("$convert" --name a --vertices 44 tests/data/hulls/cell44_0.txt 2>/dev/null | cksum)"
for options in '--vertices 3' '--vertices 4.5' '--table 5' '--table x' '--mesh --table 1' '--decompose --vertices 8'; do
  # shellcheck disable=SC2086 # words are wanted
  found=$("$convert" $options "$work/t.obj" 2>&1)
  check "options $options: status" is 2 $?
  check "options $options: a message" is 1 "$(echo "$found" | grep -c -e '^gjk-convert: ')"
done
"$convert" --name 7-up "$work/line.txt" >"$work/line.c" 2>/dev/null
${CC:-cc} -std=c99 -Wall -Wextra -Werror -Iinclude -c "$work/line.c" -o "$work/line.o"
check 'a line compiles' is 0 $?
check 'its name' is 1 "$(grep -c 'const gjk_shape _7_up = ' "$work/line.c")"

# Broken files: the message names the line, nothing is written, the status is 2.
# Surfaces. An L in three dimensions has one edge that is concave, counted from both sides.
mesh_info() { # FILE EXPECTED
  check "surface of $1" is "$2" "$("$convert" --mesh --info "$1")"
}
mesh_info tests/data/hulls/l_bracket.obj 'triangles=20 vertices=12 convex=34 flat=24 concave=2 open=0 fault=0 watertight=yes'
mesh_info tests/data/hulls/u_channel.obj 'triangles=28 vertices=16 convex=44 flat=36 concave=4 open=0 fault=0 watertight=yes'
mesh_info "$work/t.obj" 'triangles=4 vertices=4 convex=12 flat=0 concave=0 open=0 fault=0 watertight=yes'
# Faces of many corners that are not convex, from each corner on: no triangle is turned over, or lies beyond its face.
# The outlines are of an L, a U, an S, a spiral, and an L with a corner within an edge.
number=0
for outline in '0 0 4 0 4 1 1 1 1 4 0 4' '0 0 5 0 5 4 4 4 4 1 1 1 1 4 0 4' '0 0 3 0 3 3 1 3 1 2 2 2 2 1 0 1' \
  '0 0 7 0 7 7 0 7 0 2 4 2 4 4 2 4 2 5 5 5 5 1 0 1' '0 0 2 0 4 0 4 1 1 1 1 4 0 4'; do
  number=$((number + 1))
  echo "$outline" | awk -v work="$work/outline$number" '{
    n = NF / 2
    for (first = 0; first < n; first++) {
      file = work "_" first ".obj"
      for (z = 0; z < 2; z++) for (i = 0; i < n; i++) print "v", $(2 * i + 1), $(2 * i + 2), z >file
      line = "f"; for (i = 0; i < n; i++) line = line " " n + 1 + (first + i) % n
      print line >file
      line = "f"; for (i = n; i > 0; i--) line = line " " 1 + (first + i) % n
      print line >file
      for (i = 0; i < n; i++) print "f", 1 + i, 1 + (i + 1) % n, 1 + n + (i + 1) % n, 1 + n + i >file
    }
  }'
  told=$(for file in "$work/outline${number}"_*.obj; do "$convert" --mesh --info "$file"; done | sort | uniq -c | awk '{ $1 = ""; print }')
  case $number in
    1) expected=' triangles=20 vertices=12 convex=34 flat=24 concave=2 open=0 fault=0 watertight=yes' ;;
    2 | 3) expected=' triangles=28 vertices=16 convex=44 flat=36 concave=4 open=0 fault=0 watertight=yes' ;;
    4) expected=' triangles=44 vertices=24 convex=64 flat=60 concave=8 open=0 fault=0 watertight=yes' ;;
    *) expected=' triangles=24 vertices=14 convex=38 flat=32 concave=2 open=0 fault=0 watertight=yes' ;;
  esac
  check "outline $number" is "$expected" "$told"
done
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n' >"$work/turned.obj"
mesh_info "$work/turned.obj" 'triangles=2 vertices=4 convex=0 flat=0 concave=0 open=6 fault=9 watertight=no'
# Its C is sound where it is compiled, and answers: half a unit above the L's long side.
"$convert" --mesh --two-sided --name ground tests/data/hulls/l_bracket.obj >"$work/ground.c" 2>"$work/ground.said"
check 'surface: what it says' is '20 triangles, watertight; faults: none; points rounded by at most 0.00 LSB' "$(cat "$work/ground.said")"
cat >>"$work/ground.c" <<END
#include <stdio.h>
int main(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
  gjk_parts body = GJK_PARTS_OF_MESH(&ground);
  gjk_collider b = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_mesh_report report;
  gjk_distance_result gap;
  pose.position.x = GJK_Q16(30.0);
  pose.position.y = GJK_Q16(11.0);
  pose.position.z = GJK_Q16(15.0);
  if (gjk_mesh_check(&ground, &report) != GJK_OK || gjk_collider_init(&b, &ball, NULL, 0) != GJK_OK ||
      gjk_collider_pose(&b, &pose) != GJK_OK || gjk_parts_distance(&body, &b, NULL, &gap) != GJK_OK) {
    return 1;
  }
  printf("fault %d, two-sided %d, gap %ld\n", report.fault, ground.two_sided, (long)gap.distance);
  return 0;
}
END
${CC:-cc} -std=c99 -Wall -Wextra -Werror -Iinclude "$work/ground.c" "$build/host/libgjk.a" \
  "$build/hosted/port/hosted/gjk_hosted.o" -o "$work/ground"
check 'surface: its C' is 'fault 0, two-sided 1, gap 32768' "$("$work/ground")"
found=$("$convert" --mesh "tests/data/hulls/det1_1.txt" 2>&1)
check 'surface of points: status' is 2 $?
check 'surface of points' is 'tests/data/hulls/det1_1.txt: no triangles' "$found"
printf 'v 0 0 0\nv 5000 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/long.obj"
found=$("$convert" --mesh "$work/long.obj" 2>&1)
check 'a long triangle: status' is 2 $?
check 'a long triangle' is "$work/long.obj: a triangle is longer than 4095 units along an axis" "$found"

broken() { # FILE MESSAGE
  found=$("$convert" --info "$work/$1" 2>&1)
  check "$1: status" is 2 $?
  check "$1" is "$work/$1$2" "$found"
}
printf 'v 0 0 0\nv 1 x 0\n' >"$work/word.obj"
broken word.obj ":2: 'x' is not a number"
printf 'v 0 0 1\0009\n' >"$work/byte.obj"
broken byte.obj ":1: '1?9' is not a number"
printf 'v 0 0 \000\n' >"$work/nothing.obj"
broken nothing.obj ":1: '?' is not a number"
printf 'v 0 0\n' >"$work/short.obj"
broken short.obj ':1: a vertex has three coordinates'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n' >"$work/corner.obj"
broken corner.obj ':5: a face with a corner that is no vertex'
printf 'v 0 0 0\nf 1 1\n' >"$work/two.obj"
broken two.obj ':2: a face of less than 3 corners'
printf 'v 0 0 0\nf 0 1 1\n' >"$work/zero.obj"
broken zero.obj ":2: '0' is no corner of a face"
printf 'v 40000 0 0\n' >"$work/far.obj"
broken far.obj ':1: a coordinate is beyond Q16.16'
{
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf' && awk 'BEGIN { for (i = 0; i < 4097; i++) printf " %d", i % 3 + 1; print "" }'
} >"$work/many.obj"
broken many.obj ':4: a face has 3 to 4096 corners'
printf 'OFF\n-1 1 0\n' >"$work/below.off"
broken below.off ':2: a number of vertices or faces below 0'
sed '$d' "$work/t.stl" >"$work/end.stl"
broken end.stl ':30: the file ends without endsolid'
printf 'solid\0%079d\1' 0 >"$work/solid.stl"
broken solid.stl ': neither STL as text, which begins with solid, nor as bytes of the length it says'
{
  head -c 96 "$work/bytes.stl" && printf '\000\000\300\177' && tail -c +101 "$work/bytes.stl"
} >"$work/nan.stl"
broken nan.stl ': a coordinate is beyond Q16.16, in triangle 0'
printf '# nothing\n' >"$work/none.obj"
broken none.obj ':2: no points'
printf '1 2 3\n4 5\n' >"$work/two.txt"
broken two.txt ':2: a line of points has three integers'
printf '1 2 3 4\n' >"$work/four.txt"
broken four.txt ':1: a line of points has three integers'
printf '1 2 3.5\n' >"$work/real.txt"
broken real.txt ":1: '3.5' is not an integer"
printf 'OFF\n2 0 0\n0 0 0\n' >"$work/early.off"
broken early.off ':4: the file ends early'
printf '2 0 0\n' >"$work/head.off"
broken head.off ':1: the file does not begin with OFF'
printf 'solid\nvertex 0 0 0\nendloop\n' >"$work/loop.stl"
broken loop.stl ':3: a loop of other than 3 corners'
head -c 100 "$work/bytes.stl" >"$work/cut.stl"
found=$("$convert" --info "$work/cut.stl" 2>&1)
check 'cut.stl: status' is 2 $?
check 'cut.stl' is 1 "$(echo "$found" | grep -c 'neither STL as text')"
axes='property float x\nproperty float y\nproperty float z\n'
printf 'ply\nformat ascii 1.0\nelement vertex 2\n%bend_header\n1 2 3\n' "$axes" >"$work/cut.ply"
broken cut.ply ':9: the file ends early'
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n' >"$work/flat.ply"
broken flat.ply ':6: element vertex without x, y and z'
printf 'ply\nformat ascii 1.0\nelement vertex 1\n%belement face 4000000000000000000\nend_header\n1 2 3\n' "$axes" >"$work/huge.ply"
broken huge.ply ':8: element face without properties'
printf 'ply\nformat ascii 1.0\nelement vertex 3\n%belement face 1\nproperty list uchar int vertex_index\nend_header\n' "$axes" >"$work/part.ply"
printf '1 2 3\n4 5 6\n7 8 8\n3 0 1 1.5\n' >>"$work/part.ply"
broken part.ply ':13: a face with a corner that is no vertex'
head -c 130 "$work/little.ply" >"$work/header.ply"
found=$("$convert" --info "$work/header.ply" 2>&1)
check 'header.ply: status' is 2 $?
{
  ply_header binary_little_endian
  printf '%b' "$point0$point1$point2$point3"
  printf '\003\000\000\001\000\002\000\003\000\000\003\000\011\000'
} >"$work/number.ply"
broken number.ply ':9: a face with a corner that is no vertex, in face 1'
ply_header binary_little_endian >"$work/empty.ply"
found=$("$convert" --info "$work/empty.ply" 2>&1)
check 'empty.ply: status' is 2 $?
printf '0 0 0\n536739842 0 0\n' >"$work/wide.txt"
found=$("$convert" --info "$work/wide.txt" 2>&1)
check 'wide.txt: status' is 2 $?
check 'wide.txt' is "$work/wide.txt: the points are more than 8190 units apart along an axis" "$found"
for axis in 1 2; do
  printf 'v 0 0 0\nv 8189 0 0\nv 0 %d 0\nv 0 0 8189\n' $((axis * 4000)) >"$work/shape.obj"
  for way in '' --case; do
    # shellcheck disable=SC2086 # a word or none
    found=$("$convert" $way "$work/shape.obj" 2>&1)
    check "shape.obj $way: status" is 2 $?
    check "shape.obj $way" is "gjk-convert: no shape: a vertex is more than 4095 units from the middle of its hull's box" "$found"
  done
done
for wrong in "$work/missing.obj" "$work" "$work/t.xyz"; do
  "$convert" --info "$wrong" >/dev/null 2>&1
  check "$wrong: status" is 2 $?
done
for options in '--what' '' "--mesh --case $work/t.obj" "--mesh --decompose $work/t.obj" "$work/t.obj $work/t.off" '--name'; do
  # shellcheck disable=SC2086 # words are wanted
  "$convert" $options >/dev/null 2>&1
  check "options $options: status" is 2 $?
done
check 'help' is 'usage: gjk-convert [OPTION]... FILE' "$("$convert" --help | head -1)"

finish convert
