#!/bin/sh
# Compiles the library to WebAssembly without libc and imports: build.sh OUT.wasm [FLAG|SOURCE...]
#
# Every function of include is exported and every gjk_wasm_ one, or those alone whose names WASM_EXPORTS matches, a regular
# expression for grep -x. More sources and flags of clang may follow. Run it in the project's folder. Needs clang and wasm-ld
# (Debian: clang lld); WASM_CC names another clang. build.sh --objects FOLDER [FLAG...] compiles the library alone, each folder
# of src as one file. WASM_OBJECTS, the name of such a folder, gives its objects to other modules.
out=$1
shift
# memcpy and memset of port/board must not become calls of themselves.
flags="--target=wasm32 -std=c99 -O2 -ffreestanding -fno-builtin-memcpy -fno-builtin-memset -ffunction-sections -fdata-sections
  -mbulk-memory -Wall -Wextra -Werror -DNDEBUG -DGJK_PORT_HEADER=\"wasm/gjk_port.h\" -Iinclude -Iport"

# objects FOLDER FLAG...
objects() {
  to=$1
  shift
  mkdir -p "$to"
  for part in src/*/ port/wasm/ port/board/memory; do
    # shellcheck disable=SC2086
    printf '#include "%s"\n' "$part"*.c |
      "${WASM_CC:-clang}" $flags "$@" -x c -c - -o "$to/$(basename "$part").o" || return 1
  done
}

if [ "$out" = --objects ]; then
  objects "$@"
  exit
fi
if [ -z "$WASM_OBJECTS" ]; then
  WASM_OBJECTS=$out.objects own=$out.objects
  compiled=
  for word; do
    case $word in
      -Wl,*) ;;
      -*) compiled="$compiled $word" ;;
    esac
  done
  # shellcheck disable=SC2086
  objects "$WASM_OBJECTS" $compiled || exit 1
fi
exports=$(grep -ohE '\bgjk2?_[a-z0-9_]+\(' include/gjk/*.h include/gjk2/*.h port/gjk_allocate.h port/wasm/gjk_wasm.h |
  sed 's/($//' | grep -xE "${WASM_EXPORTS:-.*}" | sed 's/^/-Wl,--export-if-defined=/' | sort -u)
# shellcheck disable=SC2086
"${WASM_CC:-clang}" $flags -nostdlib "$WASM_OBJECTS"/*.o "$@" -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=262144 \
  $exports -o "$out"
status=$?
[ -z "$own" ] || rm -r "$own"
exit $status
