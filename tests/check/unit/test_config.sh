#!/bin/sh
# A wrong setting stops the build with an #error that names the remedy. test_config.sh BUILD
. tests/build/count.sh
scratch=$1/config
mkdir -p "$scratch"
compiler=${CC:-cc}

# stops REMEDY FLAGS... FILE: the compiler refuses, and its message holds REMEDY
stops() {
  remedy=$1
  shift
  if "$compiler" -std=c99 -Iinclude -Iport -fsyntax-only "$@" >"$scratch/message" 2>&1; then
    echo "compiled"
    return 1
  fi
  grep '#error' "$scratch/message" | grep -qF -- "$remedy" || { cat "$scratch/message"; return 1; }
}

compiles() {
  "$compiler" -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude -Iport -fsyntax-only "$@"
}

check 'GJK_NARROW_MULTIPLY is 0 or 1' stops 'set it to 1 in the port header' -DGJK_NARROW_MULTIPLY=2 src/arith/gjk_wide.c
check 'GJK_INT128 is 0 or 1' stops 'set it to 1 in the port header' -DGJK_INT128=2 src/arith/gjk_wide.c
check 'GJK_INT128 comes with a type' stops 'define GJK_INT128_TYPE' -DGJK_INT128=1 src/arith/gjk_wide.c
check 'the arena has a size' stops 'say -DGJK_ARENA_BYTES=' -DGJK_ARENA_BYTES=32 port/generic/gjk_arena.c
check 'the arena is a multiple of its alignment' stops 'say -DGJK_ARENA_BYTES=' -DGJK_ARENA_BYTES=100 \
  port/generic/gjk_arena.c
check 'the arena of another size' compiles -DGJK_ARENA_BYTES=64 port/generic/gjk_arena.c
for port in generic hosted template; do
  for source in src/*/*.c; do
    check "$source with the $port port" compiles "-DGJK_PORT_HEADER=\"$port/gjk_port.h\"" "$source"
  done
done
check 'the template of allocation' compiles port/template/gjk_template.c
finish config
