#!/bin/sh
# Linked code of the smallest Cortex-M3 programs at -Os, against the figures to keep. test_size.sh BUILD [all]: without all, whole
# programs have the kinds of shapes for which other tests need the library.
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

# objects_at_most LIMIT NAMES...: the code of objects
objects_at_most() {
  limit=$1
  shift
  size=$(for name in "$@"; do arm-none-eabi-size "build/cortex-m3-Os/gjk_$name.o"; done | awk '$1 + 0 > 0 { sum += $1 } END { print sum }')
  echo "$size bytes, at most $limit" && [ "$size" -gt 0 ] && [ "$size" -le "$limit" ]
}

# The maps that the two checks before have left: a scene has code of bodies of many parts only with a mesh.
links_parts_if_named() {
  ! grep -q 'gjk_\(parts\|surface\|mesh\)_' "$build/linked/cortex-m3-DSIZE_SCENE.map" &&
    grep -q gjk_parts_within "$build/linked/cortex-m3-DSIZE_SCENE-DSIZE_GROUND.map"
}

# What make sizes tells of a program: the parts, all told in words, add up to the program, but for its alignment.
parts() {
  size=$(sh tests/build/linked-size.sh "$build" cortex-m3 -DSIZE_BOXES) &&
    echo "boxes:$build/linked/cortex-m3-DSIZE_BOXES.map" >"$build/linked/boxes" &&
    awk -f tests/build/sizes-parts.awk src/README.md src/*/*.c "$build/linked/boxes" >"$build/linked/parts" &&
    awk -v size="$size" '
      NR > 1 && $1 != "all" && NF < 4 { print "without words: " $0; bad = 1 }
      /^  / { sum += $2 }
      $1 == "gjk_intersect" || $1 == "gjk_simplex" { found++ }
      $1 == "all" { all = $2 }
      END {
        print sum " of files, " all " in all, " size " linked"
        exit bad || found != 2 || sum != all || all > size || all < size - 32
      }' "$build/linked/parts"
}

# The frames of a stack add up to it, and each but those of inlined names has its file.
frames() {
  awk -v roots=gjk_distance -f tests/build/stack.awk tests/build/indirect-calls.txt "build/cortex-m3-Os"/gjk*.ci \
    >"$build/linked/stack" &&
    awk -f tests/build/sizes-stack.awk "$build/linked/stack" src/*/*.[ch] include/gjk/*.h | awk '
      NR == 1 { sub(/.*bytes: /, ""); all = $1 + 0; next }
      { sum += $1; if ($3 !~ /^src\// || NF < 4) { print "without words: " $0; bad = 1 } }
      END { print sum " in frames, " all " in all"; exit bad || sum != all || NR < 4 }'
}

# Whole programs by kinds of shapes: each is within 2 % of what port/README.md says.
kinds() {
  sh tests/build/sizes-kinds.sh "$build" "$levels" &&
    for table in kinds planekinds; do
      sed -n "/^<!-- figures: $table -->\$/,/^<!-- end -->\$/{/^|/p;}" port/README.md | tr -d ',' >"$build/linked/shown-$table"
      tr -d ',' <"$build/linked/$table" | awk -F'|' -v least="$((${all:+14} + 27))" '
        FNR == NR { row[$2 $3] = $0; next }
        {
          split(row[$2 $3], shown)
          for (i = 2; i < NF; i++) {
            number = $i ~ /^ [0-9]+ $/
            cells += number
            differ = number ? $i > shown[i] * 1.02 || $i < shown[i] * 0.98 : $i != shown[i]
            if (differ) { print $2 $3 $i "instead of" shown[i]; bad = 1 }
          }
        }
        END { exit bad || cells < least }' "$build/linked/shown-$table" - || return 1
    done
}

build=$1 all=$2
levels=${all:+POINTS ROUND BOXES POLYTOPES ALL}
levels=${levels:-POINTS BOXES ALL}
if [ -z "$(missing_package cortex-m3)" ]; then
  LINKED_TOOLS=$(make -s print-TOOLS_cortex-m3)
  export LINKED_TOOLS
  check 'the library for Cortex-M3 at -Os' library cortex-m3 -Os OPT=-Os
  check 'gjk_intersect on boxes alone' at_most 8736 -DSIZE_BOXES
  check 'gjk_distance on hulls, boxes and rounded forms' at_most 15136
  check 'gjk_penetration as well, with posing' at_most 24512 -DSIZE_POSED -DSIZE_DEPTH
  check 'gjk_cast as well, with posing' at_most 32448 -DSIZE_POSED -DSIZE_CAST
  check 'gjk_time_of_impact as well, with posing' at_most 25136 -DSIZE_POSED -DSIZE_IMPACT
  check 'gjk_cast_ray alone' at_most 28576 -DSIZE_RAY
  # What the README says of programs.
  check 'gjk_intersect on boxes, with posing' at_most 10208 -DSIZE_BOXES -DSIZE_POSED
  check 'a scene with contacts' at_most 48832 -DSIZE_SCENE
  check 'and with a mesh' at_most 95296 -DSIZE_SCENE -DSIZE_GROUND
  check 'bodies of many parts are linked only where they are' links_parts_if_named
  check 'hulls of points' objects_at_most 4256 hull_build hull_grow hull_facets hull_write
  check 'and the check of faces' objects_at_most 6240 hull_build hull_grow hull_facets hull_write hull_check
  check 'simpler hulls' objects_at_most 5714 hull_simplify hull_move hull_excess
  check 'mass properties' objects_at_most 11520 big big_angle mass_shape mass_round mass_rounded mass_rounded_faces mass_rounded_cone mass_hull mass_add mass_principal moments tensor
  check 'whole programs by kinds of shapes' kinds
  check 'the parts of a program' parts
  check 'the frames of a stack' frames
  check 'in the plane: gjk2_intersect on boxes and polygons' at_most 5520 -DSIZE_PLANE_INTERSECT
  check 'in the plane: gjk2_distance, rounded forms as well' at_most 8960 -DSIZE_PLANE_DISTANCE
  check 'in the plane: every query' at_most 15744 -DSIZE_PLANE_ALL
  check 'in the plane: gjk2_cast' at_most 18816 -DSIZE_PLANE_CAST
  check 'in the plane: gjk2_time_of_impact' at_most 14304 -DSIZE_PLANE_IMPACT
  check 'in the plane: a scene with contacts' at_most 28160 -DSIZE_PLANE_SCENE
  # What the README says of a build that keeps unused sections.
  objects=$(echo build/cortex-m3-Os/gjk*.o)
  export LIBRARY="$objects"
  check 'all objects, unused sections dropped' at_most 8736 -DSIZE_BOXES
  export SECTIONS=--no-gc-sections
  check 'all objects, all sections: about 300 KB' at_most 304192 -DSIZE_BOXES
  check 'and not much less' not_at_most 266240 -DSIZE_BOXES
else
  skip 'linked sizes' "$(missing_package cortex-m3)"
fi
finish size
