#!/bin/sh
# The golden hash from every compiler and level on every architecture, two builds at a time; what the objects of every core
# need of their surroundings, and whole matches on the cores: matrix.sh BUILD
#
# One bit that differs fails. So does undefined behaviour, which traps in the column 'sanitized' (-fsanitize=undefined,
# without -fwrapv). 'scalar' is -O2 without GJK_VECTORS, where that is the default. '-' stands for what Debian's tools, or
# this processor, do not have.
. tests/build/count.sh
. tests/build/golden.sh
dir=$1/matrix
levels='-O0 -O1 -O2 -O3 -Os lto sanitized avx2 scalar'

flags() {
  case $2 in
    lto) echo '-O2 -flto' ;;
    sanitized)
      [ "$1" = gcc ] && echo '-O1 -fsanitize=undefined -fsanitize-undefined-trap-on-error' ||
        echo '-O1 -fsanitize=undefined -fsanitize-trap=undefined'
      ;;
    avx2) echo '-O2 -mavx2' ;;
    scalar) echo '-O2 -DGJK_VECTORS=0' ;;
    *) echo "$2" ;;
  esac
}

# carried ARCHITECTURE COMPILER LEVEL: clang 14 has no stable AVR, whose flash of 256 KB is too small for all but -Os; lld 14
# has no s390x, and loses the ABI of RV64.
carried() {
  case $2-$1-$3 in
    clang-avr-* | gcc-avr--O[0123] | gcc-avr-lto | gcc-avr-sanitized | clang-s390x-lto | clang-rv64-lto) return 1 ;;
    *-host-avx2) grep -qw avx2 /proc/cpuinfo 2>/dev/null || return 1 ;;
    *-host-scalar | *-aarch64-scalar) ;;
    *-avx2 | *-scalar) return 1 ;;
  esac
}

# shellcheck disable=SC2046
one() {
  name=$1-$2$3
  missing=$(golden_missing "$1" "$2" "$(flags "$2" "$3")")
  if ! carried "$1" "$2" "$3"; then
    echo - >"$dir/$name"
  elif [ -n "$missing" ]; then
    echo "skipped: $1, $2 $3: needs $missing"
    echo skipped >"$dir/$name"
  elif golden "$dir/$name.build" "$1" "$2" $(flags "$2" "$3") >"$dir/$name.log" 2>&1; then
    echo same >"$dir/$name"
  else
    echo "failed: $1, $2 $3: see $dir/$name.log"
    echo FAILED >"$dir/$name"
  fi
  rm -rf "$dir/$name.build"
}

if [ "$2" = --one ]; then
  one "$3" "$4" "$5"
  exit 0
fi

rm -rf "$dir"
mkdir -p "$dir"
for architecture in host $golden_linux $golden_cores; do
  for compiler in gcc clang; do
    for level in $levels; do
      echo "$architecture $compiler $level"
    done
  done
done | xargs -P 2 -L 1 sh "$0" "$1" --one

same=0 failed=0 skipped=0
# shellcheck disable=SC2086
printf '%-18s%10s%10s%10s%10s%10s%10s%11s%10s%10s\n' 'golden hash' $levels
for architecture in host $golden_linux $golden_cores; do
  for compiler in gcc clang; do
    printf '%-12s%-6s' "$architecture" $compiler
    for level in $levels; do
      result=$(cat "$dir/$architecture-$compiler$level")
      printf '%10s' "$result"
      case $result in
        same) same=$((same + 1)) ;;
        FAILED) failed=$((failed + 1)) ;;
        skipped) skipped=$((skipped + 1)) ;;
      esac
    done
    printf '\n'
  done
done
for script in symbols size scene_golden; do
  sh "tests/check/unit/test_$script.sh" "$1" all || failed=$((failed + 1))
done
echo "matrix: $same passed, $failed failed, $skipped skipped"
[ $failed = 0 ] && [ $same -gt 0 ]
