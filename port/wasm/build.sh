#!/bin/sh
# Compiles the library to WebAssembly without libc and imports: build.sh OUT.wasm [FLAG|SOURCE...]
#
# Every function of include is exported and every gjk_wasm_ one, or those alone whose names WASM_EXPORTS matches, a regular
# expression for grep -x. More sources and flags of clang may follow. Run it in the project's folder. Needs clang and wasm-ld
# (Debian: clang lld); WASM_CC names another clang.
out=$1
shift
exports=$(grep -ohE '\bgjk2?_[a-z0-9_]+\(' include/gjk/*.h include/gjk2/*.h port/gjk_allocate.h port/wasm/gjk_wasm.h |
  sed 's/($//' | grep -xE "${WASM_EXPORTS:-.*}" | sed 's/^/-Wl,--export-if-defined=/' | sort -u)
# memcpy and memset of port/board must not become calls of themselves.
# shellcheck disable=SC2086
"${WASM_CC:-clang}" --target=wasm32 -std=c99 -O2 -ffreestanding -fno-builtin-memcpy -fno-builtin-memset -nostdlib \
  -ffunction-sections -fdata-sections -mbulk-memory -Wall -Wextra -Werror -DNDEBUG \
  '-DGJK_PORT_HEADER="wasm/gjk_port.h"' -Iinclude -Iport \
  src/*/*.c port/wasm/gjk_wasm*.c port/board/memory.c "$@" \
  -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=262144 $exports -o "$out"
