#!/bin/sh
# The quick part of `make prove`, and a run of the assertions that the proof takes as given. test_prove.sh BUILD
. tests/build/count.sh
check 'assertions of the sources hold, without undefined behaviour' sh tests/build/bounds.sh "$1" 4000 4001
check 'at least eighty assertions are checked' sh -c "[ \$(cat build/checked/src/*/*.[ch] | grep -c __builtin_trap) -ge 80 ]"
if have frama-c; then
  check 'products, poses, a simplex of one, decisions, headers of scenes' sh tests/build/prove.sh "$1/quick" primitives-x-int32 pose-x-int32 \
    simplex-1-int32 query-INTERSECT-int32 scene_block-HEADER-int32
else
  skip 'the proof' frama-c-base
fi
finish prove
