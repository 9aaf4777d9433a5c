#!/bin/sh
# The ceiling on iterations. A build with a low one reports it, with bounds that hold. After each status the fields
# that the headers name are valid. test_limit.sh BUILD
. tests/build/count.sh
dir=$1/limit
mkdir -p "$dir"
rm -f "$dir"/*

# run PROGRAM MAX: leaves what tests/check/limit/PROGRAM.c prints with that ceiling
run() {
  # shellcheck disable=SC2086
  [ -e "$dir/$1" ] || ${CC:-cc} -std=c99 -O1 -include tests/support/given_ceilings.h -Iinclude -Iport -I. -Itests/support \
    "tests/check/limit/$1.c" port/hosted/gjk_hosted.c $ceilings_objects -o "$dir/$1" || return 1
  GJK_TEST_ITERATIONS=$2 "$dir/$1" >"$dir/$1-$2.txt"
}

# The queries that have reported a status, of so many.
reported() {
  grep -c "$1" "$dir/fields-$2.txt" | grep -qx "$3"
}

# fields MAX
fields() {
  run fields "$1" || { cat "$dir/fields-$1.txt"; return 1; }
}

# plane MAX
plane() {
  run plane "$1" || { cat "$dir/plane-$1.txt"; return 1; }
}

# motion MAX
motion() {
  run motion "$1" || { cat "$dir/motion-$1.txt"; return 1; }
}

# parts MAX
parts() {
  run parts "$1" || { grep failed "$dir/parts-$1.txt"; return 1; }
}

# parts_hold MAX: their answers against those of the usual ceiling; and no impact comes before what it proves free
parts_hold() {
  awk -f tests/check/limit/parts.awk "$dir/parts-128.txt" "$dir/parts-$1.txt" &&
    { "$dir/parts" "$dir/parts-$1.txt" >"$dir/claims.txt" || { grep failed "$dir/claims.txt"; return 1; }; }
}

# holds MAX: wherever MAX iterations do not settle it, the bounds hold the distance (2 LSB of curved shapes apart) and MAX
# iterations were used; elsewhere nothing changes. Other queries say so, too, or answer as usual.
holds() {
  paste -d ' ' "$dir/bounds-128.txt" "$dir/bounds-$1.txt" | awk -v max="$1" '
    # The status in the field and the n fields after it, to those of the usual ceiling.
    function same(field, n,   i, differ) {
      if ($(16 + field) == -10) return 0
      for (i = 0; i <= n; i++) differ = differ || $(field + i) != $(16 + field + i)
      if (differ) { print field ": " $0; bad = 1 }
      return 1
    }
    $18 == -10 { limited++; if ($19 > $3 + 2 || $20 < $3 - 2 || $21 != max) { print; bad = 1 } if ($19 > 0) useful++ }
    # The signed distance, of curved shapes within 3 LSB.
    $27 == -10 { if ($31 > $12 + 3 || $32 < $12 - 3) { print "signed: " $0; bad = 1 } if ($31 > 0) apart++; if ($31 < 0) deep++ }
    { same(2, 3); undecided += !same(6, 1); unpierced += !same(8, 2); unmeasured += !same(11, 1); unmet += !same(13, 1) }
    END {
      print limited + 0, useful + 0, undecided + 0, unpierced + 0, unmeasured + 0, unmet + 0, apart + 0, deep + 0
      exit bad || apart < 100 || deep < 100 || limited < 400 || useful < limited / 4 || undecided < 20 || unpierced < 20 || unmeasured < 100 || unmet < 100
    }'
}

ceilings_library || exit 1
check 'bounds' run bounds 128
check 'no pair reaches it' awk '$2 != 0 || $6 != 0 || $5 >= 64 { print; bad = 1 } END { exit bad }' "$dir/bounds-128.txt"
check 'valid fields' fields 128
check 'all queries answer' reported GJK_OK 128 8
check 'three run out of memory' reported GJK_ERROR_CAPACITY 128 3
check 'the usual ceiling in the plane' plane 128
check 'the usual ceiling of casts and impacts' motion 128
check 'the usual ceiling of bodies of many parts' parts 128
for max in 1 2 3 4; do
  check "a ceiling of $max: valid fields" fields $max
  check "a ceiling of $max: all queries report it" reported GJK_ERROR_ITERATION_LIMIT $max 8
  check "a ceiling of $max in the plane" plane $max
  check "a ceiling of $max of casts and impacts" motion $max
  check "a ceiling of $max: impacts report it" grep -q '^gjk_time_of_impact .* GJK_ERROR_ITERATION_LIMIT ' "$dir/motion-$max.txt"
  check "a ceiling of $max of bodies of many parts" parts $max
  check "a ceiling of $max of bodies of many parts holds its bounds" parts_hold $max
  [ $max = 1 ] && continue
  check "a ceiling of $max: bounds" run bounds $max
  check "a ceiling of $max holds its bounds" holds $max
done
finish limit
