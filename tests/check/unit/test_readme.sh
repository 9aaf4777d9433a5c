#!/bin/sh
# The README's own examples. Each block of C with a main compiles, runs, and prints what its comments '// prints: TEXT'
# say, in their order. A block without a main compiles. test_readme.sh BUILD
. tests/build/count.sh
scratch=$1/readme
rm -rf "$scratch"
mkdir -p "$scratch"

awk -v scratch="$scratch" '
  /^```c$/ { block = ""; inside = 1; next }
  /^```$/ {
    if (inside && block ~ /int main/) printf "%s", block >(scratch "/example" ++count ".c")
    else if (inside) printf "#include \"gjk/gjk.h\"\n%s", block >(scratch "/part" ++parts ".c")
    inside = 0
    next
  }
  inside { block = block $0 "\n" }' README.md

compiles() {
  "${CC:-cc}" -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude "$1.c" "$2/host/libgjk.a" \
    "$2/hosted/port/hosted/gjk_hosted.o" -o "$1"
}

prints() {
  sed -n 's|.*// prints: ||p' "$1.c" >"$1.expected"
  "$1" >"$1.printed" && test -s "$1.expected" && diff "$1.expected" "$1.printed"
}

for number in 1 2 3; do
  example=$scratch/example$number
  check "example $number compiles" compiles "$example" "$1"
  check "example $number prints what it says" prints "$example"
done
part() {
  "${CC:-cc}" -std=c99 -Wall -Wextra -Wpedantic -Wno-unused-function -Werror -Iinclude -fsyntax-only "$scratch/part$1.c"
}
check 'the part compiles' part 1
check 'there are no more' test ! -e "$scratch/example4.c"
finish readme
