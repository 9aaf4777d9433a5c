#!/bin/sh
# Linked code of the smallest Cortex-M3 programs at -Os, against the figures to keep. test_size.sh BUILD
. tests/build/count.sh

# at_most LIMIT MACROS...
at_most() {
  limit=$1
  shift
  size=$(sh tests/build/linked-size.sh "$build" cortex-m3 "$@") && echo "$size bytes, at most $limit" && [ "$size" -le "$limit" ]
}

not_at_most() {
  ! at_most "$@"
}

build=$1
if [ -z "$(missing_package cortex-m3)" ]; then
  check 'the library for Cortex-M3 at -Os' make -s lib TARGET=cortex-m3 OPT=-Os VARIANT=-linked
  check 'gjk_intersect on boxes alone' at_most 8576 -DSIZE_BOXES
  check 'gjk_distance on hulls, boxes and rounded forms' at_most 13440
  check 'gjk_penetration as well, with posing' at_most 22912 -DSIZE_POSED -DSIZE_DEPTH
  # What the README says of programs.
  check 'gjk_intersect on boxes, with posing' at_most 10496 -DSIZE_BOXES -DSIZE_POSED
  check 'a scene with contacts' at_most 43520 -DSIZE_SCENE
  check 'in the plane: gjk2_intersect on boxes and polygons' at_most 6016 -DSIZE_PLANE_INTERSECT
  check 'in the plane: gjk2_distance, rounded forms as well' at_most 8448 -DSIZE_PLANE_DISTANCE
  check 'in the plane: every query' at_most 16000 -DSIZE_PLANE_ALL
  # What the README says of a build that keeps unused sections.
  objects=$(echo build/cortex-m3-linked/gjk_*.o)
  export LIBRARY="$objects"
  check 'all objects, unused sections dropped' at_most 8576 -DSIZE_BOXES
  export SECTIONS=--no-gc-sections
  check 'all objects, all sections: about 60 KB' at_most 64000 -DSIZE_BOXES
  check 'and not much less' not_at_most 56000 -DSIZE_BOXES
else
  skip 'linked sizes' "$(missing_package cortex-m3)"
fi
finish size
