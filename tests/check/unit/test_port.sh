#!/bin/sh
# Every port: primitives against plain C, allocation, and what a violated contract does. test_port.sh BUILD
. tests/build/count.sh
build=$1/port
mkdir -p "$build"
sources='tests/check/target/port.c tests/check/target/port_allocation.c tests/check/target/port_host.c'
# What they link.
library_sources=$(needed $sources)
# shellcheck disable=SC2086
printf "#include \"$(pwd)/%s\"\n" $library_sources >"$build/library.c"
compiler=${CC:-cc}

# add LINE: counts the program's own checks, from its line 'N passed, M failed'
add() {
  passed=$((passed + $(echo "$1" | sed 's/ passed.*//')))
  failed=$((failed + $(echo "$1" | sed 's/.*, \([0-9]*\) failed/\1/')))
}

# host NAME FLAGS...: builds and runs the checks
host() {
  name=$1
  shift
  # shellcheck disable=SC2086
  "$compiler" -std=c99 -O1 -Iinclude -I. -Iport -Itests/support "$@" "$build/library.c" $sources -o "$build/$name" || return 1
  "$build/$name" >"$build/$name.txt"
  status=$?
  cat "$build/$name.txt"
  return $status
}

run_host() {
  check "$1 port" host "$@"
  add "$(tail -n 1 "$build/$1.txt" 2>/dev/null || echo '0 passed, 1 failed')"
}

# A contract that is violated says so and stops the program.
aborts() {
  ! "$1" violate >"$build/message" 2>&1 || return 1
  grep -q 'contract violated: within' "$build/message"
}

run_host generic '-DGJK_PORT_HEADER="generic/gjk_port.h"' -DPORT_ARENA_BYTES=4096 port/generic/gjk_arena.c
run_host generic-small '-DGJK_PORT_HEADER="generic/gjk_port.h"' -DGJK_ARENA_BYTES=512 -DPORT_ARENA_BYTES=512 \
  port/generic/gjk_arena.c
run_host narrow -DGJK_NARROW_MULTIPLY=1 -DPORT_ARENA_BYTES=4096 port/generic/gjk_arena.c
run_host clz '-DGJK_CLZ32(x)=__builtin_clz(x)' -DPORT_ARENA_BYTES=4096 port/generic/gjk_arena.c
run_host hosted '-DGJK_PORT_HEADER="hosted/gjk_port.h"' port/hosted/gjk_hosted.c
check 'hosted port: a violated contract stops the program' aborts "$build/hosted"
check 'generic port: asserts are compiled out' "$build/generic" violate

# firmware TARGET PORT: the same on a board, which ends with a violated contract
firmware() {
  make -s "build/$1-port/port.elf" TARGET="$1" PORT="$2" VARIANT=-port SOURCES="$library_sources" ROOMS=1 >"$build/$1.log" 2>&1 ||
    { cat "$build/$1.log"; return 1; }
  sh tests/build/emulate.sh "$1" "build/$1-port/port.elf" >"$build/$1.txt" && return 1
  tail -n 1 "$build/$1.txt" | grep -q '^contract violated: within' && return 0
  cat "$build/$1.txt"
  return 1
}

for pair in cortex-m0:mps2 cortex-m3:mps2 cortex-m33:mps2 rv32imc:riscv-virt avr:avr; do
  target=${pair%:*}
  missing="$(missing_package "$target") $(missing_emulator "$target")"
  if [ -n "${missing# }" ]; then
    skip "port on $target" "$missing"
    continue
  fi
  check "$target, port ${pair#*:}" firmware "$target" "${pair#*:}"
  add "$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$build/$target.txt" || echo '0 passed, 1 failed')"
done
finish port
