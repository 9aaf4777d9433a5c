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
$program decisions "$pairs" | awk -F, '
  BEGIN {
    columns = split("gjk;double;Box2D;Chipmunk", method, ";")
    title["gjk"] = "gjk2"
    title["double"] = "GJK in `double`, tolerance 1e-32"
    title["Box2D"] = "Box2D"
    title["Chipmunk"] = "Chipmunk2D"
    what["game"] = "boxes and polygons of 0.1 to 2 units, anywhere near each other"
    what["touching"] = "the same within 3 LSB of touching"
    what["large"] = "of up to 1,000 units within 3 LSB of touching"
    what["edges"] = "boxes of all sizes edge to edge, within 2 LSB of touching"
    what["slivers"] = "10,000 times longer than thick, within 3 LSB of touching"
    what["smallest-14"] = "the deciding determinant is -1, 0 or 1, edges of 14 bits"
    what["smallest-20"] = "the same, edges of 20 bits"
    what["smallest-26"] = "the same, edges of 26 bits"
  }
  {
    name = $2
    sub(/^Box2D .*/, "Box2D", name)
    if (!(($1, "seen") in wrong)) { wrong[$1, "seen"]; family[++families] = $1 }
    share = 100 * $4 / $3
    if (!(($1, name) in wrong) || share < wrong[$1, name]) wrong[$1, name] = share
    known[name]
  }
  function shown(share) { return share == 0 ? "0" : share < 0.1 ? sprintf("%.3f %%", share) : sprintf("%.1f %%", share) }
  END {
    line = "| pairs in the plane |"
    rule = "|---|"
    for (m = 1; m <= columns; m++) if (method[m] in known) {
      line = line " " title[method[m]] " |"
      rule = rule "---|"
    }
    print line "\n" rule
    for (f = 1; f <= families; f++) {
      line = "| " what[family[f]] " |"
      for (m = 1; m <= columns; m++) if (method[m] in known) {
        cell = shown(wrong[family[f], method[m]])
        line = line " " (m == 1 && cell == "0" ? "**0**" : cell) " |"
      }
      print line
    }
  }'
