#!/bin/sh
# What a whole program links for Cortex-M3 at -Os, by its kinds of shapes and its query: sizes-kinds.sh BUILD [LEVELS] writes two
# tables in Markdown, BUILD/linked/kinds and BUILD/linked/planekinds, or their rows of such levels of GJK_SHAPES. A program is tests/measure/target/size_user.c with a board's start-up
# code, posing and libgcc, and the library built for no more kinds than it has.
. tests/build/count.sh
build=$1 levels=${2:-POINTS ROUND BOXES POLYTOPES ALL}
out=$build/linked
variant=$(variant_of "$build")
mkdir -p "$out"
tools=$(make -s print-TOOLS_cortex-m3 | sed 's/-fcallgraph-info=su//')
compile="$tools -std=c99 -Os -ffreestanding -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -Iinclude -Iport
  -I. -Itests/support"
# The board is compiled once.
board=
for word in $(make -s print-BOARD_cortex-m3); do
  case $word in
    *.c)
      object=$out/board-$(basename "$word" .c).o
      # shellcheck disable=SC2086
      $compile -c "$word" -o "$object" || exit 1
      word=$object
      ;;
  esac
  board="$board $word"
done
queries='TOUCH DISTANCE DEPTH CONTACTS CAST IMPACT SCENE'

# cell LEVEL KIND QUERY MACROS...: bytes of code and constants
cell() {
  level=$1
  name=$out/user-$(echo "$*" | tr ' ' -)
  kind=$2 query=$3
  shift 3
  # shellcheck disable=SC2086
  $compile "-DUSER_$kind" "-DUSER_$query" "$@" tests/measure/target/size_user.c $board \
    "build/cortex-m3$variant-Os$(level_suffix "$level")/libgjk.a" -lgcc -Wl,--gc-sections -Wl,--no-warn-rwx-segments \
    "-Wl,-Map=$name.map" -o "$name.elf" || return 1
  arm-none-eabi-size "$name.elf" | awk 'NR == 2 { print $1 + $2 }'
}

level_suffix() {
  [ "$1" = ALL ] || echo "-$1"
}

# row LABEL LEVEL KIND MACROS...
row() {
  label=$1 of_level=$2 of_kind=$3
  shift 3
  case " $levels " in *" $of_level "*) ;; *) return ;; esac
  printf '| %s | `GJK_SHAPES_%s`' "$label" "$of_level"
  for of_query in $queries; do
    case $of_level-$of_query$* in
      POINTS-CAST) printf ' | none' ;;
      *) printf ' | %s' "$(cell "$of_level" "$of_kind" "$of_query" "$@" | sed 's/\([0-9]\{3\}\)$/,\1/')" ;;
    esac
  done
  echo ' |'
}

heading() {
  echo "| $1 | level | touch | distance | depth | contacts | cast | impact | scene |"
  echo '|---|---|---|---|---|---|---|---|---|'
}

for level in $levels; do
  if [ "$level" = ALL ]; then
    library cortex-m3 "$variant-Os" OPT=-Os || exit 1
  else
    level_library "$variant" "$level" || exit 1
  fi
done
{
  heading 'space'
  row spheres POINTS SPHERES
  row 'spheres, capsules' ROUND CAPSULES
  row boxes BOXES BOXES
  row 'boxes, hulls' POLYTOPES HULLS
  row 'boxes, the library as it is' ALL BOXES
  row 'hulls, cylinders' ALL ALL
} >"$out/kinds" || exit 1
{
  heading 'in the plane'
  row circles POINTS SPHERES -DUSER_PLANE
  row 'circles, capsules' ROUND CAPSULES -DUSER_PLANE
  row boxes BOXES BOXES -DUSER_PLANE
  row 'boxes, polygons' POLYTOPES HULLS -DUSER_PLANE
  row 'boxes, the library as it is' ALL BOXES -DUSER_PLANE
  row 'polygons, ellipses' ALL ALL -DUSER_PLANE
} >"$out/planekinds"
! grep -h '|  |' "$out/kinds" "$out/planekinds"
