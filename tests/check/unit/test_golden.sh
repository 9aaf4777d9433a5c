#!/bin/sh
# The same bits from every build: compilers, optimisation, with and without 128-bit integers and long multiplications,
# big-endian, and on the emulated cores of 8 and 32 bits. `make matrix` has every pair of those, and what is left out here:
# architectures with a build of their kind among these, such as AArch64, whose vectors test_scan_builds.sh knows. test_golden.sh BUILD
. tests/build/count.sh
. tests/build/golden.sh
build=$1/golden
golden_shared=1

# same ARCHITECTURE COMPILER FLAGS...
same() {
  missing=$(golden_missing "$@")
  if [ -z "$missing" ]; then
    check "$*${golden_many:+, larger sets}" golden "$build" "$@"
  else
    skip "golden hash: $*" "$missing"
  fi
}

same host gcc -O0 -DGJK_VECTORS=0
same host gcc -O2 '-DGJK_PORT_HEADER="hosted/gjk_port.h"'  # 128-bit integers
same host clang -O2 -DGJK_NARROW_MULTIPLY=1 $golden_avx2
golden_many=1
same host gcc -O2 '-DGJK_PORT_HEADER="hosted/gjk_port.h"'
same host clang -O2 -DGJK_NARROW_MULTIPLY=1 $golden_avx2
golden_many=
same host gcc -O1 -fsanitize=undefined,address -fno-sanitize-recover=all
same s390x gcc -O1
same cortex-m0 gcc -O2
same cortex-m3 gcc -O2
same rv32imc gcc -Os
same avr gcc -Os

wrong_bits() {
  ! GJK_TEST_ITERATIONS=3 golden "$build" host "${CC:-cc}" -O2 -include "$(pwd)/tests/support/given_ceilings.h" && [ -x "$build/golden.elf" ]
}
check 'another answer is another hash' wrong_bits

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -z "${missing# }" ]; then
  demo_said() {
    sh tests/build/demo-target.sh "$1" tests/data/arm.txt >"$1/demo-target.txt" || { cat "$1/demo-target.txt"; return 1; }
  }
  check 'the scene of the demo on cortex-m3' demo_said "$1"
  check 'the arm as a chain takes less than a third' awk '
    /^the arm/ { print; chain = $7; composed = $NF }
    END { exit !(chain > 0 && 3 * chain < composed) }' "$1/demo-target.txt"
else
  skip 'the scene of the demo on cortex-m3' "$missing"
fi
finish golden
