#!/bin/sh
# Does the proof notice faults? prove-faults.sh BUILD. Each fault is put into a copy of the sources, and the runs
# concerned must fail. Without a fault they must hold.
. tests/build/count.sh
. tests/build/fault.sh
LC_ALL=C.UTF-8
export LC_ALL
top=$1/prove-faults
mkdir -p "$top"

# fault NAME FILE RUNS OLD NEW [OLD NEW]...: replaces literal text, which must occur once.
fault() {
  name=$1 file=$2 runs=$3
  copy=$top/$name
  shift 3
  copy_sources "$copy"
  while [ $# -gt 0 ]; do
    replace_once "$(echo "$copy/src"/*/"$file")" "$1" "$2" || {
      check "$name: $file still has '$1', once" false
      return
    }
    shift 2
  done
  for run in $runs; do
    (cd "$copy" && sh tests/build/prove.sh build "$run") >"$copy/$run.out" 2>&1
    # A fault that ends in no analysis is not noticed but in the way.
    check "$name: noticed by $run" sh -c \
      "grep -q '^failed: $run: \(refuted\|not in\|only in\)' '$copy/$run.out' && ! grep -q 'no analysis' '$copy/$run.out'"
    grep "^failed: $run: \(refuted\|not in\|only in\)" "$copy/$run.out" | head -n 3 | sed "s/^failed:/  $name:/"
  done
}

if ! have frama-c; then
  skip 'the faults' frama-c-base
  finish prove-faults
  exit
fi

for run in simplex-2-int32 simplex-3-int32 shape-TRIANGLE-int16; do
  sh tests/build/prove.sh "$top/none" "$run" >"$top/$run.out" 2>&1
  check "without a fault $run holds" grep "^$run: 0 unexpected" "$top/$run.out"
done

# Four products of digits and a carry do not fit 64 bits.
fault middle-in-one-chain gjk_wide.c simplex-3-int32 \
  'gjk_mac32(gjk_mac32(gjk_sar64(lowest, 31), ph, ql), pl, qh);' \
  'gjk_mac32(gjk_mac32(gjk_mac32(gjk_mac32(gjk_sar64(lowest, 31), ph, ql), pl, qh), rh, sl), rl, sh);' \
  'middle2 = gjk_mac32(gjk_mul32(rh, sl), rl, sh);' 'middle2 = 0;'

# A listed assertion that no value meets any more: because of it, or of what stands before it.
fault assertion-always-false gjk_simplex.c simplex-2-int32 \
  'assert square >= 0 && square <=' 'assert square < 0 && square <='
fault bound-always-broken gjk_vector.c simplex-2-int32 'k -= gjk_clz32(bits);' 'k -= gjk_clz32(bits) + 40;'

# Scans of the variant with narrow products that run past the last vertex.
fault scan-off-the-end gjk_scan.c shape-TRIANGLE-int16 \
  'for (const gjk_vec3 *v = best + 1; v != end; v++) {' 'for (const gjk_vec3 *v = best + 1; v <= end; v++) {'
fault second-scan-off-the-end gjk_scan.c shape-TRIANGLE-int16 'for (v++; v != end; v++) {' 'for (v++; v <= end; v++) {'
fault search-off-the-end gjk_scan.c shape-TRIANGLE-int16 \
  'while (v != best && gjk_coarse_dot(&c, v) < limit) {' 'for (;;) {'
fault reach-off-the-end gjk_scan.c shape-TRIANGLE-int16 \
  'while (reach->next != reach->end) {' 'while (reach->next <= reach->end) {'
finish prove-faults
