# The README's table of the most expensive pairs, from 'ID|iterations|instructions' as worst-case.sh replays them.
BEGIN {
  FS = "|"
  title["boxes"] = "boxes"
  title["hulls8"] = "8-point hulls"
  title["hulls64"] = "64-point hulls"
  title["rounded"] = "rounded boxes, segments, triangles, 8-point hulls"
  title["curved"] = "cylinders, cones, ellipsoids"
}

{
  split($1, part, "-")
  family = part[1]
  if (!(family in known)) { known[family]; name[++names] = family }
  at = family SUBSEP part[2]
  if ($2 + 0 > iterations[at] + 0) iterations[at] = $2
  if ($3 + 0 > most[at] + 0) most[at] = $3
}

END {
  print "| the most found for | distance: iterations | instructions | intersect: iterations | instructions |"
  print "|---|---|---|---|---|"
  for (n = 1; n <= names; n++) {
    d = name[n] SUBSEP "distance"
    i = name[n] SUBSEP "intersect"
    print "| " title[name[n]] " | " iterations[d] " | " about(most[d]) " | " iterations[i] " | " about(most[i]) " |"
  }
}
