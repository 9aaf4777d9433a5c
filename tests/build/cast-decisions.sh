#!/bin/sh
# What casts miss, and hit wrongly, by family, this library beside floating point: cast-decisions.sh BUILD [CASTS]
#
# Prints a table. Its columns are the library, the reference in double, and Bullet and FCL if their Debian packages are
# installed. Of Bullet's three casters the one that decides best in a family is shown. Each cell: hits that are missed / misses
# that are hit, the error that 99 of 100 of the hits that are found stay below, time. An error is that of the fraction, as LSB
# of the gap. CASTS: casts of each family, 2000. BUILD/bench/casts.csv has all figures of the run.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
casts=${2:-2000}
mkdir -p "$build/bench"
if [ -z "$WITHOUT_PEERS" ]; then
  find_peer fcl FCL libfcl-dev >&2
  find_peer bullet Bullet libbullet-dev >&2
fi
make -s build/gjk-casts BENCH_PEERS="$peers" >"$build/bench/casts.log" 2>&1 ||
  { cat "$build/bench/casts.log" >&2; exit 1; }
build/gjk-casts "$casts" >"$build/bench/casts.csv" || exit 1
awk -F, '
  BEGIN {
    columns = split("gjk;double;Bullet;FCL", method, ";")
    title["double"] = "Newton in `double`"
    what["ordinary"] = "boxes and hulls of about a unit"
    what["graze"] = "past a face, an edge or a corner, within 3 LSB"
    what["level"] = "face against face, corner against corner"
    what["ends"] = "ways that end within an LSB of contact"
    what["fast"] = "small and fast against thin walls"
    what["sizes"] = "of a few LSB to 4,000 units, ways of up to 65,000"
    what["ball-1"] = "a ball against a box of 1 unit"
    what["ball-500"] = "a ball against a box of 500 units"
    what["ball-500-long"] = "the same, ways of 8,000 units"
  }
  {
    name = $2
    sub(/^Bullet .*/, "Bullet", name)
    if (!($1 in seen)) { seen[$1]; family[++families] = $1; hits[$1] = $4; all[$1] = $3 }
    if (!(($1, name) in wrong) || $5 + $6 < wrong[$1, name]) {
      wrong[$1, name] = $5 + $6
      missed[$1, name] = $5
      false[$1, name] = $6
      error[$1, name] = $8
      ns[$1, name] = $10
    }
    known[name]
  }
  function lsb(x) { return x < 0.01 ? "0.00" : x < 10 ? sprintf("%.2f", x) : sprintf("%d", x + 0.5) }
  END {
    line = "| casts, of them hits |"
    rule = "|---|"
    for (m = 1; m <= columns; m++) if (method[m] in known) {
      line = line " " (method[m] in title ? title[method[m]] : method[m]) " |"
      rule = rule "---|"
    }
    print line "\n" rule
    for (f = 1; f <= families; f++) {
      line = "| " what[family[f]] ": " all[family[f]] ", " hits[family[f]] " |"
      for (m = 1; m <= columns; m++) if (method[m] in known) {
        at = family[f] SUBSEP method[m]
        line = line sprintf(" %d / %d, %s LSB, %d ns |", missed[at], false[at], lsb(error[at]), ns[at])
      }
      print line
    }
  }' "$build/bench/casts.csv"
