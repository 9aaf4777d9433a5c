#!/bin/sh
# The quick part of `make prove`, and a run of the assertions that the proof takes as given. test_prove.sh BUILD
. tests/build/count.sh
. tests/build/fault.sh
check 'assertions of the sources hold, without undefined behaviour' sh tests/build/bounds.sh "$1" 4000 4001
check 'at least eighty assertions are checked' sh -c "[ \$(cat build/checked/src/*/*.[ch] | grep -c __builtin_trap) -ge 80 ]"
check 'each run that tests/prove/digests.txt names has held on this code' sh tests/build/prove.sh "$1/stale" --stale

# altered SCRIPT: a copy of the sources, in which a script of sed has changed what poses are made of
altered() {
  copy_sources "$1/altered"
  sed -i "$2" "$1/altered/src/place/gjk_pose.c"
  (cd "$1/altered" && sh tests/build/prove.sh build --stale) >"$1/altered/said"
}
noticed() {
  ! altered "$1" 's/^gjk_status gjk_quat_normalize(.*{/&;/' && grep -q '^of other code: integrate-x-int32' "$1/altered/said"
}
check 'comments are not looked at' altered "$1" '1i // Another comment.'
check 'a change of the code is noticed' noticed "$1"

if have frama-c; then
  check 'products, poses, a simplex of one, decisions, headers of scenes' sh tests/build/prove.sh "$1/quick" primitives-x-int32 pose-x-int32 \
    simplex-1-int32 query-INTERSECT-int32 scene_block-HEADER-int32
else
  skip 'the proof' frama-c-base
fi
finish prove
