# Counts checks of test scripts. Source it, call check and skip, and end with finish NAME.
passed=0 failed=0 skipped=0

# check 'what must hold' command...: runs the command, and shows its output if it fails.
check() {
  what=$1
  shift
  if output=$("$@" 2>&1); then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "failed: $what"
    printf '%s\n' "$output" | head -n 40
  fi
}

# Commands for check.
# status N command...: the exit status is N; its output is in $dir/out and $dir/err, where $dir is the script's folder.
status() {
  wanted=$1
  shift
  "$@" >"$dir/out" 2>"$dir/err"
  found=$?
  [ $found -eq "$wanted" ] || { echo "exit status $found instead of $wanted"; cat "$dir/err"; return 1; }
}

# is WANTED FOUND
is() {
  [ "$1" = "$2" ] || { echo "'$2' instead of '$1'"; return 1; }
}

# numbers_only SVG: no coordinate is one that is none
numbers_only() {
  ! grep -qE 'nan|inf[^o]' "$1"
}

# well_formed SVG LEAST: each element is closed, and there are more than so many
well_formed() {
  opened=$(grep -oE '<[a-zA-Z]' "$1" | wc -l)
  closed=$(grep -oE '</|/>' "$1" | wc -l)
  [ "$opened" -gt "$2" ] && [ "$opened" = "$closed" ]
}

# skip 'what' package
skip() {
  skipped=$((skipped + 1))
  echo "skipped: $1: needs $2"
}

have() {
  command -v "$1" >/dev/null
}

finish() {
  if [ $skipped -gt 0 ]; then
    echo "$1: $passed passed, $failed failed, $skipped skipped"
  else
    echo "$1: $passed passed, $failed failed"
  fi
  [ $failed -eq 0 ]
}

# The tools of a target, or the package that they come in.
missing_package() {
  case $1 in
    cortex-*) have arm-none-eabi-gcc || echo gcc-arm-none-eabi ;;
    rv32imc) have riscv64-unknown-elf-gcc || echo gcc-riscv64-unknown-elf ;;
    avr) have avr-gcc && [ -e /usr/lib/avr/include/avr/io.h ] || echo "gcc-avr avr-libc" ;;
  esac
}

missing_emulator() {
  case $1 in
    cortex-*) have qemu-system-arm || echo qemu-system-arm ;;
    rv32imc) have qemu-system-riscv32 || echo qemu-system-misc ;;
    avr) have simavr || echo simavr ;;
  esac
}

# What the names of a target's tools begin with.
tool_prefix() {
  case $1 in
    rv32imc) echo riscv64-unknown-elf- ;;
    *) echo arm-none-eabi- ;;
  esac
}

# alone NAME COMMAND...: runs a command that builds something. Scripts that run at the same time and want the same NAME wait
# for each other.
alone() {
  mkdir -p build
  alone_lock=build/.$1.lock
  shift
  if have flock; then
    flock "$alone_lock" "$@"
  else
    "$@"
  fi
}

# needed SOURCES...: those of src that a program of these sources links
needed() {
  awk -f tests/build/needed.awk needed= "$@" -- src/*/*.c tests/support/*/*.c include/*/*.h | tr ' ' '\n' | grep '^src/' |
    tr '\n' ' '
}

# rooms FOLDER SOURCES...: for each folder of src a file of FOLDER that includes its sources, so that their headers are read
# once. No name is in two sources.
rooms() {
  rooms_at=$1 rooms_top=$(pwd)
  shift
  rm -rf "$rooms_at"
  mkdir -p "$rooms_at"
  for source; do
    room=${source%/*}
    echo "#include \"$rooms_top/$source\"" >>"$rooms_at/gjk-${room##*/}.c"
  done
}

# library TARGET VARIANT NAME=VALUE...: makes the library with these variables of the Makefile in build/TARGETVARIANT,
# alone.
library() {
  library_at="TARGET=$1 VARIANT=$2"
  library_name=$1$2
  shift 2
  # shellcheck disable=SC2086
  (
    unset MAKEFLAGS MFLAGS MAKELEVEL  # it has jobs of its own
    alone "$library_name" make -s -j2 lib $library_at "$@" >/dev/null
  )
}

# The same with each folder of src compiled as one file, for what is tested alone; warnings are those of the usual builds.
library_by_rooms() {
  library "$@" ROOMS=1 WARNINGS=
}

# The library as it is installed and packed, in build/host-install: without a port, and so without libc. Integers of 128 bits,
# where the compiler has them, make large coordinates a third faster. GJK_BY_ROOMS=1, as tests run, compiles a folder of src at once.
installed_library() {
  wide=
  if "${CC:-cc}" -dM -E - </dev/null | grep -q __SIZEOF_INT128__; then
    wide='-DGJK_INT128=1 -DGJK_INT128_TYPE=__int128'
  fi
  library host -install "OPT=-O2 -fPIC $wide" PORT= WARNINGS= "ROOMS=$GJK_BY_ROOMS"
}

# The host's library with the ceilings of tests/support/given_ceilings.h, and sets ceilings_objects to its objects: all but the
# table of names, whose values are constants.
ceilings_library() {
  ceilings_objects='build/host-ceilings/gjk*.o build/hosted/tests/support/given_ceilings.o'
  library_by_rooms host -ceilings 'OPT=-O1 -include tests/support/given_ceilings.h' \
    "SOURCES=$(echo src/*/*.c | sed 's|[^ ]*/gjk_bind_names.c||')" &&
    alone hosted make -s build/hosted/tests/support/given_ceilings.o
}

# level_library VARIANT LEVEL: the library for Cortex-M3 at -Os with the kinds of a level of GJK_SHAPES alone, of what measures
# and tests levels, in build/cortex-m3VARIANT-Os-LEVEL
level_library() {
  library cortex-m3 "$1-Os-$2" "OPT=-Os -DGJK_SHAPES=GJK_SHAPES_$2" "SOURCES=$(level_sources)"
}

level_sources() {
  needed tests/measure/target/size_user.c tests/check/target/levels.c tests/check/target/plane_levels.c
}

# The library's objects for WebAssembly, alone, in WASM_OBJECTS.
wasm_objects() {
  export WASM_OBJECTS=build/wasm/objects
  # shellcheck disable=SC2016
  alone wasm sh -c 'key=$(cat port/wasm/* port/board/memory.c src/*/*.[ch] include/*/*.h | cksum)
    [ "$key" = "$(cat build/wasm/key 2>/dev/null)" ] || { sh port/wasm/build.sh --objects build/wasm/objects && echo "$key" >build/wasm/key; }'
}

# The library as WebAssembly: wasm_library OUT.wasm
wasm_library() {
  wasm_objects && sh port/wasm/build.sh "$1"
}

# The library with its assertions as checks, in build/checked: see checked.sh.
checked_library() {
  alone checked sh tests/build/checked.sh build/checked
}

# The VARIANT of the Makefile for a script that works in BUILD: none for build, -x for build/x, so that scripts that run
# at the same time build apart.
variant_of() {
  echo "${1#build}" | tr / -
}

# Runs a program of tests/measure/target on an emulated core: count_on_core TARGET PROGRAM VARIANT NAME=VALUE..., with these
# variables of the Makefile
count_on_core() {
  core_target=$1 core_program=$2 core_variant=$3
  shift 3
  make -s "build/$core_target$core_variant/$core_program.elf" "TARGET=$core_target" "VARIANT=$core_variant" "$@" >/dev/null &&
    sh tests/build/emulate.sh "$core_target" "build/$core_target$core_variant/$core_program.elf"
}
