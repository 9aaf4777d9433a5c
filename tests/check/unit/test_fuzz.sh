#!/bin/sh
# A short run of the fuzzers with a fixed seed. test_fuzz.sh BUILD
. tests/build/count.sh
if have clang && echo 'int main(void) { return 0; }' | clang -fsanitize=address -x c - -o /dev/null 2>/dev/null; then
  check 'pairs, cases, arguments, scenes, claims, casts and the plane' sh tests/build/fuzz.sh "$1" 35 1
else
  skip 'fuzzing' 'clang libclang-rt-dev'
fi
finish fuzz
