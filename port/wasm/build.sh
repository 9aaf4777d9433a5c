#!/bin/sh
# Compiles the library to WebAssembly without libc and imports: build.sh OUT.wasm [FLAG|SOURCE...]
#
# Every function of include is exported and every gjk_wasm_ one, or those alone whose names WASM_EXPORTS matches, a regular
# expression for grep -x. More sources and flags of clang may follow. Run it in the project's folder. Needs clang and wasm-ld
# (Debian: clang lld); WASM_CC names another clang. build.sh --objects FOLDER compiles the sources there, as WASM_OBJECTS, the
# name of such a folder, gives them to other modules.
out=$1
shift
library='src/*/*.c port/wasm/gjk_wasm*.c port/board/memory.c'
# memcpy and memset of port/board must not become calls of themselves.
flags="--target=wasm32 -std=c99 -O2 -ffreestanding -fno-builtin-memcpy -fno-builtin-memset -ffunction-sections -fdata-sections
  -mbulk-memory -Wall -Wextra -Werror -DNDEBUG -DGJK_PORT_HEADER=\"wasm/gjk_port.h\" -Iinclude -Iport"
if [ "$out" = --objects ]; then
  mkdir -p "$1"
  for source in $library; do
    # shellcheck disable=SC2086
    "${WASM_CC:-clang}" $flags -c "$source" -o "$1/$(basename "$source" .c).o" || exit 1
  done
  exit
fi
[ -z "$WASM_OBJECTS" ] || library="$WASM_OBJECTS/*.o"
exports=$(grep -ohE '\bgjk2?_[a-z0-9_]+\(' include/gjk/*.h include/gjk2/*.h port/gjk_allocate.h port/wasm/gjk_wasm.h |
  sed 's/($//' | grep -xE "${WASM_EXPORTS:-.*}" | sed 's/^/-Wl,--export-if-defined=/' | sort -u)
# shellcheck disable=SC2086
"${WASM_CC:-clang}" $flags -nostdlib $library "$@" -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=262144 $exports \
  -o "$out"
