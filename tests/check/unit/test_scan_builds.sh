#!/bin/sh
# Scans in vectors, one by one and by narrow products: each build of test_scan.c, of the reach of limits too.
# test_scan_builds.sh BUILD
. tests/build/count.sh
. tests/build/golden.sh
build=$1/scan_builds
mkdir -p "$build"
# One file of all, in which their headers are read once.
# shellcheck disable=SC2046
printf "#include \"$(pwd)/%s\"\n" tests/check/unit/test_scan.c $(needed tests/check/unit/test_scan.c) >"$build/scan.c"

# run ARCHITECTURE COMPILER FLAGS...: the checks, counted from the last line 'NAME: N passed, N failed'
run() {
  architecture=$1 compiler=$2
  shift 2
  case $architecture-$compiler in
    host-*) emulator= ;;
    *-gcc) compiler=$(golden_triple "$architecture")-gcc emulator=$(golden_emulator "$architecture") ;;
    *)
      compiler="clang --target=$(golden_triple "$architecture")" emulator=$(golden_emulator "$architecture")
      ;;
  esac
  case $architecture in
    host) link= ;;
    *) link=-static ;;
  esac
  # shellcheck disable=SC2086
  $compiler -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror $link "$@" -DSCAN_REACH=1 \
    -Iinclude -Iport -I. -Itests/support "$build/scan.c" -o "$build/scan" &&
    $emulator "$build/scan" >"$build/scan.txt"
  status=$?
  tail -n 20 "$build/scan.txt"
  return $status
}

# same ARCHITECTURE COMPILER FLAGS...
same() {
  missing=$(golden_missing "$@")
  if [ -n "$missing" ]; then
    skip "scans: $*" "$missing"
    return
  fi
  : >"$build/scan.txt"
  check "$*" run "$@"
}

# cpu FLAG...: whether this processor has these instructions
cpu() {
  for flag; do
    grep -qw "$flag" /proc/cpuinfo 2>/dev/null || return 1
  done
}

for compiler in gcc clang; do
  same host $compiler -O2
  same host $compiler -O0
  same host $compiler -Os
  same host $compiler -Os -DGJK_VECTORS=1
  same host $compiler -O2 -DGJK_VECTORS=0
  same host $compiler -O2 -DGJK_NARROW_MULTIPLY=1
  same host $compiler -O1 -fsanitize=undefined,address -fno-sanitize-recover=all
  same host $compiler -O1 -fsanitize=undefined,address -fno-sanitize-recover=all -DGJK_VECTORS=0
  if cpu sse4_1; then same host $compiler -O2 -msse4.1; else skip 'scans: -msse4.1' 'a processor with SSE4.1'; fi
  if cpu avx2; then same host $compiler -O2 -mavx2; else skip 'scans: -mavx2' 'a processor with AVX2'; fi
  same aarch64 $compiler -O2
done
same i386 gcc -O2
same i386 gcc -O2 -msse2
same s390x gcc -O2
finish scan_builds
