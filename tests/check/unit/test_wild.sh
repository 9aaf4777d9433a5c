#!/bin/sh
# A custom shape whose support function breaks all its promises, under the sanitizers. test_wild.sh BUILD
. tests/build/count.sh
dir=$1/wild
mkdir -p "$dir"
# shellcheck disable=SC2046
rooms "$dir/rooms" $(needed tests/check/unit/wild.c)

# wild NAME FLAGS...: builds and runs the checks without asserts; undefined behaviour ends them
wild() {
  name=$1
  shift
  "${CC:-cc}" -std=c99 -Og "$@" -fsanitize=undefined,address -fno-sanitize-recover=all -Iinclude -I. -Iport -Itests/support \
    '-DGJK_PORT_HEADER="generic/gjk_port.h"' tests/check/unit/wild.c "$dir"/rooms/*.c -o "$dir/$name" || return 1
  "$dir/$name"
}

if echo 'int main(void) { return 0; }' | "${CC:-cc}" -fsanitize=undefined,address -x c - -o "$dir/empty" 2>/dev/null; then
  check 'wild points' wild wide
else
  skip 'wild points' 'a compiler with sanitizers'
fi
finish wild
