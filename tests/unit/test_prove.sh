#!/bin/sh
# The quick part of `make prove`, and the assertions that it takes, checked as they run. test_prove.sh BUILD
. tests/build/count.sh
check 'assertions of the sources hold, without undefined behaviour' sh tests/build/bounds.sh "$1" 20000
check 'at least thirty assertions are checked' sh -c "[ \$(cat '$1'/bounds/*.[ch] | grep -c __builtin_trap) -ge 30 ]"
if have frama-c; then
  check 'products, a simplex of one' sh tests/build/prove.sh "$1/quick" primitives-x-int32 simplex-1-int32
else
  skip 'the proof' frama-c-base
fi
finish prove
