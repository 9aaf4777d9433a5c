#!/bin/sh
# Wrong decisions by family of pairs, this library beside floating point: decisions.sh BUILD [PAIRS]
#
# Prints a table. Its columns are the library, the reference in double, and libccd, FCL and Bullet if their Debian
# packages are installed. Of the two detectors of Bullet the better one is shown. PAIRS: pairs of each family, 20000.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
pairs=${2:-20000}
mkdir -p "$build/bench"
if [ -z "$WITHOUT_PEERS" ]; then
  find_peer ccd libccd libccd-dev >&2
  find_peer fcl FCL libfcl-dev >&2
  find_peer bullet Bullet libbullet-dev >&2
fi
make -s build/gjk-decisions BENCH_PEERS="$peers" >"$build/bench/decisions.log" 2>&1 ||
  { cat "$build/bench/decisions.log" >&2; exit 1; }
build/gjk-decisions "$pairs" | awk -F, '
  BEGIN {
    columns = split("gjk cold;reference double;libccd GJK;FCL indep;Bullet", method, ";")
    title["gjk cold"] = "gjk"
    title["reference double"] = "GJK in `double`, tolerance 1e-30"
    title["libccd GJK"] = "libccd"
    title["FCL indep"] = "FCL"
    title["Bullet"] = "Bullet"
    what["near"] = "boxes and hulls of about a unit, 1,000 LSB deep to 1,000 LSB apart"
    what["touching"] = "boxes and hulls of all sizes within 3 LSB of touching"
    what["stacked"] = "boxes and hulls face to face, within 2 LSB of touching"
    what["slivers"] = "10,000 times longer than thick, within 3 LSB of touching"
    what["smallest"] = "hulls of up to 4,000 units whose deciding determinant is -1, 0 or 1"
  }
  {
    name = $2 ~ /^Bullet/ ? "Bullet" : $2
    if (!(($1, "seen") in wrong)) { wrong[$1, "seen"]; family[++families] = $1 }
    share = 100 * $4 / $3
    if (!(($1, name) in wrong) || share < wrong[$1, name]) wrong[$1, name] = share
    known[name]
  }
  function shown(share) { return share == 0 ? "0" : share < 0.1 ? sprintf("%.3f %%", share) : sprintf("%.1f %%", share) }
  END {
    line = "| pairs |"
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
