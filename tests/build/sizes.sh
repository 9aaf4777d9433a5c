#!/bin/sh
# Code by function group and stack by query, per target; then, for Cortex-M3, what the code and the stack consist of:
# sizes.sh BUILD
. tests/build/count.sh
build=$1
targets=
for target in cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc; do
  if [ -z "$(missing_package $target)" ]; then
    targets="$targets $target"
  else
    echo "no figures for $target: needs $(missing_package $target)"
  fi
done
[ -n "$targets" ] || exit 1

# Reads 'TARGET NAME NUMBER' lines; prints a row per name, a column per target.
table() {
  awk -v title="$1" -v targets="$targets" -v total="$2" '
    { if (!($2 in known)) { known[$2]; name[++names] = $2 } value[$1, $2] = $3; sum[$1] += $3 }
    END {
      columns = split(targets, target, " ")
      printf "\n%-26s", title
      for (c = 1; c <= columns; c++) printf "%12s", target[c]
      printf "\n"
      for (n = 1; n <= names; n++) {
        printf "%-26s", name[n]
        for (c = 1; c <= columns; c++) printf "%12d", value[target[c], name[n]]
        printf "\n"
      }
      if (total) {
        printf "%-26s", "all"
        for (c = 1; c <= columns; c++) printf "%12d", sum[target[c]]
        printf "\n"
      }
    }'
}

for level in -O2 -Os; do
  for target in $targets; do
    library "$target" "${level#-O2}" OPT=$level || exit 1
  done
  for target in $targets; do
    "$(tool_prefix "$target")size" "$build/$target${level#-O2}"/gjk*.o | sed 's|\.o$||; s|[^ \t]*/||' |
      awk -v target="$target" 'NR > 1 { print target, $6, $1 }'
  done | table "text, bytes, $level" 1
  for target in $targets; do
    awk -v roots='gjk_intersect gjk_within gjk_within_until gjk_distance gjk_distance_until gjk_penetration gjk_signed_distance
      gjk_contacts gjk_check_decision gjk_check_distance gjk_check_penetration gjk_collider_init gjk_collider_pose
      gjk_collider_move gjk_collider_aabb gjk_cast gjk_cast_ray gjk_check_cast gjk_motion_pose gjk_time_of_impact
      gjk2_intersect gjk2_distance gjk2_distance_until gjk2_penetration gjk2_signed_distance gjk2_contacts gjk2_check_decision
      gjk2_check_distance gjk2_check_penetration gjk2_collider_pose gjk2_chain_contacts gjk2_cast gjk2_cast_ray gjk2_check_cast
      gjk2_time_of_impact gjk2_motion_pose' -f tests/build/stack.awk tests/build/indirect-calls.txt \
      "$build/$target${level#-O2}"/gjk*.ci | awk -v target="$target" '{ print target, $1, $2 }'
  done | table "stack, bytes, $level" 0
done

[ -z "$(missing_package cortex-m3)" ] || exit 0
library cortex-m3 -Os OPT=-Os || exit 1

# linked TITLE MACROS...: links a program and prints 'TITLE: the map of what it is made of'.
linked() {
  title=$1
  shift
  sh tests/build/linked-size.sh "$build" cortex-m3 "$@" >/dev/null || exit 1
  echo "$title:$build/linked/cortex-m3$(echo "$*" | tr -d ' ').map"
}
echo
echo 'what a program links for Cortex-M3 at -Os, bytes by room and file; what is in a file, as its first line says:'
{
  linked 'intersect' -DSIZE_BOXES
  linked '+ posing' -DSIZE_BOXES -DSIZE_POSED
  linked 'distance' -DSIZE_POSED
  linked '+ depth' -DSIZE_POSED -DSIZE_DEPTH
  linked '+ cast' -DSIZE_POSED -DSIZE_CAST
  linked '+ impact' -DSIZE_POSED -DSIZE_IMPACT
  linked 'scene' -DSIZE_SCENE
} >"$build/linked/programs"
awk -f tests/build/sizes-parts.awk src/README.md src/*/*.c "$build/linked/programs"
echo
echo '  intersect  gjk_intersect on boxes and rounded boxes; + posing: gjk_collider_init and gjk_collider_pose as well'
echo '  distance   gjk_distance on boxes, hulls and their rounded forms, with posing; + depth: gjk_penetration as well,'
echo '             + cast, + impact: gjk_cast and gjk_time_of_impact instead'
echo '  scene      a scene of boxes and spheres with contacts'

for query in gjk_intersect gjk_distance gjk_penetration; do
  echo
  awk -v roots=$query -f tests/build/stack.awk tests/build/indirect-calls.txt build/cortex-m3/gjk*.ci >"$build/linked/stack" || exit 1
  awk -f tests/build/sizes-stack.awk "$build/linked/stack" src/*/*.[ch] include/gjk/*.h
done

echo
echo 'whole programs for Cortex-M3 at -Os, bytes, by kinds of shapes:'
sh tests/build/sizes-kinds.sh "$build" && cat "$build/linked/kinds" "$build/linked/planekinds" || exit 1

echo
echo 'in the plane, linked for Cortex-M3 at -Os, bytes:'
printf '%-28s%9s%14s\n' '' query 'with posing'
for query in INTERSECT DISTANCE ALL CAST IMPACT; do
  printf '%-28s%9d%14d\n' $query "$(sh tests/build/linked-size.sh "$build" cortex-m3 -DSIZE_PLANE_$query)" \
    "$(sh tests/build/linked-size.sh "$build" cortex-m3 -DSIZE_PLANE_$query -DSIZE_POSED)"
done
printf '%-28s%23d\n' SCENE "$(sh tests/build/linked-size.sh "$build" cortex-m3 -DSIZE_PLANE_SCENE)"
