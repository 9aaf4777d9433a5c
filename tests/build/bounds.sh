#!/bin/sh
# The assertions that the proof takes, checked as they run, and all undefined behaviour with them: bounds.sh BUILD PAIRS
dir=$1/bounds
mkdir -p "$dir"
for file in src/*; do
  sed 's|//@ assert \(.*\);$|if (!(\1)) __builtin_trap();|; s|//@ .*||' "$file" >"$dir/$(basename "$file")"
done
sed "s/^#define PAIRS .*/#define PAIRS $2/" tests/limit/bounds.c >"$dir/main_bounds.c"
${CC:-cc} -std=c99 -O2 -fsanitize=undefined -fno-sanitize-recover=all -Iinclude "-I$dir" -Itests "$dir"/*.c \
  -o "$dir/bounds" && [ "$("$dir/bounds" | wc -l)" = "$2" ]
