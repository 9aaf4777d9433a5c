#!/bin/sh
# What a scene's tick may cost: instructions on an emulated Cortex-M4, and against all box pairs here.
# test_scene_cost.sh BUILD
. tests/build/count.sh
build=$1

# at_most LIMIT CASE
at_most() {
  awk -F'|' -v limit="$1" -v name="$2" '
    $1 == name { found = 1; print; if ($2 > limit) bad = 1 }
    END { exit bad || !found }' "$build/scene_cost.txt"
}

# at_most_times FACTOR CASE OTHER: CASE costs at most so many times what OTHER does.
at_most_times() {
  awk -F'|' -v factor="$1" -v name="$2" -v other="$3" '
    $1 == name || $1 == other { print; cost[$1] = $2 }
    END { exit !(cost[name] > 0 && cost[name] <= factor * cost[other]) }' "$build/scene_cost.txt"
}

missing="$(missing_package cortex-m4) $(missing_emulator cortex-m4)"
if [ -z "${missing# }" ]; then
  cases_run() {
    library_by_rooms cortex-m4 -rooms OPT=-O2 &&
      count_on_core cortex-m4 scene_bench -rooms ROOMS=1 WARNINGS= >"$build/scene_cost.txt"
  }
  check 'the cases run' cases_run
  check '64 bodies sparse' at_most 35000 '64 bodies sparse, 25 % moving'
  check '64 bodies in piles' at_most 70000 '64 bodies in piles, 25 % moving'
  check '64 bodies crowded, two pairs a body' at_most 80000 '64 bodies crowded, 25 % moving'
  check '64 bodies at rest' at_most 1000 '64 bodies crowded, at rest'
  check 'all moving against a quarter' at_most_times 4 '64 bodies crowded, all moving' '64 bodies crowded, 25 % moving'
  check 'a ray through 256 bodies, sparse' at_most 11450 'ray through 256 bodies sparse'
  check 'a ray through 256 bodies, crowded' at_most 17150 'ray through 256 bodies crowded'
  for kind in sparse crowded 'in piles'; do
    check "four times the bodies, $kind" at_most_times 5 "256 bodies $kind, 25 % moving" "64 bodies $kind, 25 % moving"
  done
else
  skip 'instructions per tick' "$missing"
fi
check '10,000 bodies, 5 % moving: 20 times faster than all box pairs' "$build/scene-bench" quick
finish scene_cost
