#!/bin/sh
# Bytes of code and constants that a program for TARGET links, built for size: linked-size.sh BUILD TARGET MACRO...
# The macros choose the program, see tests/measure/target/size.c; its own bytes are not counted. 'float' or 'double' instead of
# the macros is the reference in that type, see tests/measure/target/bench_reference.h, with the floating point that it needs.
# What comes from which object is in the linker's map beside the program, BUILD/linked/TARGETMACROS.map.
# LIBRARY: other objects than the library's; SECTIONS=--no-gc-sections keeps all of them; LINKED_TOOLS: the compiler, if it is known.
. tests/build/count.sh
out=$1/linked
variant=$(variant_of "$1")
target=$2
shift 2
mkdir -p "$out"
name=$out/$target$(echo "$*" | tr -d ' ')
tools=${LINKED_TOOLS:-$(make -s "print-TOOLS_$target")}

# compile FLAGS... FILE OBJECT
compile() {
  $tools -std=c99 -Os -ffreestanding -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -Iinclude -I. -Itests/support -Itests/measure/target \
    -c "$@"
}

# link SYMBOL OBJECT...
link() {
  entry=$1
  shift
  $tools -nostdlib -Wl,--no-warn-rwx-segments,${SECTIONS---gc-sections} "-Wl,-e$entry" "$@" "$out/$target-memory.o" -lgcc \
    "-Wl,-Map=$name.map" -o "$name.elf"
}

compile port/board/memory.c -o "$out/$target-memory.o" || exit 1
case $1 in
  float | double)
    compile "tests/measure/target/bench_$1.c" -o "$name.o" && link "bench_$1" "$name.o" || exit 1
    "$(tool_prefix "$target")size" "$name.elf" | awk 'NR == 2 { print $1 }'
    ;;
  *)
    compile "$@" tests/measure/target/size.c -o "$name.o" &&
      link size_main "$name.o" ${LIBRARY:-build/$target$variant-Os/libgjk.a} || exit 1
    "$(tool_prefix "$target")size" "$name.o" "$name.elf" | awk 'NR == 2 { own = $1 } NR == 3 { print $1 - own }'
    ;;
esac
