#!/bin/sh
# A short run of the fuzzers: a fixed seed and a fixed number of inputs, whatever the machine's speed. test_fuzz.sh BUILD
. tests/build/count.sh
if have clang && echo 'int main(void) { return 0; }' | clang -fsanitize=address -x c - -o /dev/null 2>/dev/null; then
  check 'pairs, cases, arguments, parts, solids, scenes, claims, casts, the plane, ground, arms, gjk-convert and robots' sh tests/build/fuzz.sh "$1" 1000x 1
else
  skip 'fuzzing' 'clang libclang-rt-dev'
fi
finish fuzz
