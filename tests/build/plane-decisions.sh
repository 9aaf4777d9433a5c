#!/bin/sh
# Wrong decisions in the plane by family of pairs, this library beside floating point: plane-decisions.sh BUILD [PAIRS]
#
# Prints a table. Its columns are the library, the reference in double, and Box2D and Chipmunk2D if their Debian packages
# are installed. Of Box2D's three ways to decide the best one of each family is shown. PAIRS: pairs of each family, 20000.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
pairs=${2:-20000}
mkdir -p "$build/bench"
find_plane_peers >&2
program=build/gjk-plane
[ -z "$WITHOUT_PEERS" ] || program=build/gjk-plane-alone
make -s $program PLANE_PEERS="$plane_peers" >"$build/bench/plane.log" 2>&1 ||
  { cat "$build/bench/plane.log" >&2; exit 1; }
$program decisions "$pairs" | awk -F, -v head='pairs in the plane' \
  -v methods='gjk=gjk2;double=GJK in `double`, tolerance 1e-32;Box2D=Box2D;Chipmunk=Chipmunk2D' \
  -v families='game=boxes and polygons of 0.1 to 2 units, anywhere near each other;touching=the same within 3 LSB of touching;large=of up to 1,000 units within 3 LSB of touching;edges=boxes of all sizes edge to edge, within 2 LSB of touching;slivers=10,000 times longer than thick, within 3 LSB of touching;smallest-14=the deciding determinant is -1, 0 or 1, edges of 14 bits;smallest-20=the same, edges of 20 bits;smallest-26=the same, edges of 26 bits' \
  -f tests/build/decisions.awk
