#!/bin/sh
# The README's own example: the first block of C with a main compiles, runs, and prints what its comments
# '// prints: TEXT' say, in their order. test_readme.sh BUILD
. tests/build/count.sh
scratch=$1/readme
mkdir -p "$scratch"

awk '
  /^```c$/ { block = ""; inside = 1; next }
  /^```$/ { if (inside && block ~ /int main/) { printf "%s", block; exit } inside = 0; next }
  inside { block = block $0 "\n" }' README.md >"$scratch/example.c"
sed -n 's|.*// prints: ||p' "$scratch/example.c" >"$scratch/expected"

compiles() {
  "${CC:-cc}" -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude "$scratch/example.c" "$1/host/libgjk.a" \
    "$1/hosted/port/hosted/gjk_hosted.o" -o "$scratch/example"
}

prints() {
  "$scratch/example" >"$scratch/printed" && diff "$scratch/expected" "$scratch/printed"
}

check 'there is an example' test -s "$scratch/example.c"
check 'it says what it prints' test -s "$scratch/expected"
check 'it compiles' compiles "$1"
check 'it prints that' prints
finish readme
