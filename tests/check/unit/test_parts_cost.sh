#!/bin/sh
# What tests/measure/README.md says of hulls and bodies of many parts: instructions on emulated cores, bytes of data. test_parts_cost.sh BUILD
. tests/build/count.sh
build=$1
figures=$build/parts_cost.txt

# count TARGET BENCH: what the benchmark prints, into a file
count() {
  case $1 in
    cortex-m3) variant='' rooms='' ;;
    *) variant=-rooms rooms='ROOMS=1 WARNINGS=' ;;
  esac
  # shellcheck disable=SC2086
  library "$1" "$variant" OPT=-O2 $rooms && count_on_core "$1" "$2" "$variant" OPT=-O2 $rooms >"$figures"
}

# near COLUMN ROW LINE FIELD: in its row the column is within 3 % of that field of the first line counted that begins so
near() {
  awk -v column="$1" -v row="$2" -v line="$3" -v field="$4" '
    FNR == NR { if (!told && index($0, line) == 1) { told = 1; gsub(/[^0-9 ]/, ""); split($0, number, " "); counted = number[field] } next }
    { split($0, cell, / *\| */) }
    cell[2] == row { found++; gsub(",", "", cell[column + 2]); said = cell[column + 2] }
    END {
      print row ": " counted ", the table says " said
      exit found != 1 || counted + 0 <= 0 || counted > 1.03 * said || counted < 0.97 * said
    }' "$figures" tests/measure/README.md
}

# at_most POINTS INSTRUCTIONS: what src/README.md says of hulls, and 5 % more
at_most() {
  awk -v points="$1" -v most="$2" '
    $3 == points { found = 1; print; if ($7 + 0 <= 0 || $7 > most) bad = 1 }
    END { exit bad || !found }' "$figures"
}

# ground KIND: of a mesh or a height field
ground() {
  check "$1: contacts" near 1 "turned box on a $1: contacts" "turned box on a $1" 1
  check "$1: distance" near 1 "box 1 unit above a $1: distance" "turned box on a $1" 5
  check "$1: ray" near 1 "ray of 16 units to a $1" "turned box on a $1" 6
}

column=0
for target in cortex-m3 cortex-m0; do
  column=$((column + 1))
  lacking="$(missing_package $target) $(missing_emulator $target)"
  if [ -n "${lacking# }" ]; then
    skip "instructions on $target" "$lacking"
    continue
  fi
  check "$target: hulls" count $target hull_bench
  check "$target: hull of 64 points" near $column 'hull of 64 points on a sphere' 'hull of 64 points' 3
  if [ $target = cortex-m3 ]; then
    check 'hull of 16 points' at_most 16 46000
    check 'hull of 64 points' at_most 64 265000
    check 'hull of 256 points' at_most 256 1310000
  fi
  check "$target: compounds" count $target parts_bench
  for query in contacts distance cast; do
    check "$target: compound, $query" near $column "box and compound: $query" "32 parts, tree, $query:" 2
  done
  if [ $target = cortex-m3 ]; then
    check 'surfaces' count $target mesh_bench
    ground mesh
    ground 'height field'
    cat >"$build/parts_cost.c" <<'END'
#include "gjk/gjk.h"
typedef char nodes[GJK_COMPOUND_NODES(33) - GJK_COMPOUND_NODES(32) == 2 ? 1 : -1];
typedef char part[sizeof(gjk_compound_part) + 2 * sizeof(gjk_compound_node) == 88 ? 1 : -1];
typedef char mesh[8 * sizeof(gjk_mesh_triangle) + (GJK_MESH_NODES(8000) - GJK_MESH_NODES(7992)) * sizeof(gjk_mesh_node) == 8 * 15 ? 1 : -1];
typedef char vertex[sizeof(gjk_vec3) == 12 && sizeof *((gjk_height_field *)0)->heights == 2 ? 1 : -1];
typedef char hull[GJK_HULL_WORKSPACE(2) - GJK_HULL_WORKSPACE(1) == 40 ? 1 : -1];
END
    check 'bytes of data' arm-none-eabi-gcc -std=c99 -mcpu=cortex-m3 -mthumb -Iinclude -c "$build/parts_cost.c" -o "$build/parts_cost.o"
  fi
done
finish 'parts cost'
