#!/bin/sh
# A match of 10,000 ticks in a scene, of space and of the plane, has the same hash from every build, through saves and
# rollbacks, on the emulated cores and on a big-endian machine; so have ground and a game on it.
# test_scene_golden.sh BUILD [all]: without all, cores but Cortex-M3 run the first 500 ticks, with rollbacks.
. tests/build/count.sh
. tests/build/golden.sh
folder=$1 all=$2

# host NAME RUNNER ARCHITECTURE COMPILER FLAGS...
host() {
  program=$build/$1
  runner=$2
  shift 2
  golden_library "$@" || return 1
  case $1 in
    host) linker=$2 ;;
    *) linker="$(golden_triple "$1")-$2 -static" ;;
  esac
  shift 2
  # shellcheck disable=SC2086
  $linker "$@" -std=c99 -Iinclude -I. -Iport -Itests/support $sources "$golden_objects"/gjk*.o port/hosted/gjk_hosted.c -o "$program" &&
    $runner "$program"
}

# target NAME
target() {
  level=-O2 variant=-rooms few=-DGOLDEN_FEW rooms='ROOMS=1 WARNINGS='
  case $1 in
    cortex-m3) few='' variant='' rooms='' ;;
    rv32imc) level=-Os variant=-rooms-Os ;;
  esac
  [ "$all" != all ] || few=
  elf=build/$1$variant/$game.elf
  # shellcheck disable=SC2086
  golden_library "$1" gcc $level &&
    make -s "$elf" TARGET="$1" VARIANT=$variant OPT=$level FIRMWARE_DEFINES=$few $rooms &&
    sh tests/build/emulate.sh "$1" "$elf"
}

# match GAME [SOURCE]: the match of that name has its hash from every build
match() {
  game=$1
  build=$folder/$game
  sources="$2 tests/check/target/$game.c tests/check/target/${game}_host.c"
  mkdir -p "$build"
  # The builds are those of test_golden.sh, so that each is made once.
  if have gcc; then
    check "$game: gcc -O2" host gcc '' host gcc -O2 '-DGJK_PORT_HEADER="hosted/gjk_port.h"'
    check "$game: undefined behaviour and addresses" host sanitized '' host gcc -O1 -fsanitize=undefined,address \
      -fno-sanitize-recover=all
  fi
  if have clang; then
    check "$game: clang -O2, narrow multiplication" host clang-narrow '' host clang -O2 -DGJK_NARROW_MULTIPLY=1 $golden_avx2
  else
    skip "$game with clang" clang
  fi
  if ! have s390x-linux-gnu-gcc; then
    skip "$game on a big-endian machine" 'gcc-s390x-linux-gnu libc6-dev-s390x-cross'
  elif ! have qemu-s390x; then
    skip "$game on a big-endian machine" qemu-user
  else
    check "$game: big-endian" host s390x qemu-s390x s390x gcc -O1
  fi
  for core in cortex-m3 cortex-m4 rv32imc; do
    missing="$(missing_package $core) $(missing_emulator $core)"
    if [ -z "${missing# }" ]; then
      check "$game: $core" target $core
    else
      skip "$game on $core" "$missing"
    fi
  done
}

match scene_golden tests/support/scene/match.c
match plane_scene_golden tests/support/scene/plane_match.c
match ground_golden ''
finish scene_golden
