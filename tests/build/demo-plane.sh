#!/bin/sh
# Two processes play a match on the level of tests/programs/demo_plane from a file of inputs. They exchange only inputs,
# and compare hashes each tick. demo-plane.sh BUILD TICKS [INPUTS OTHERS]: player 0 reads INPUTS, player 1 OTHERS.
# First both run on this machine, then player 1 is firmware on an emulated Cortex-M3, then it runs on an emulated S390.
# The picture of the first match is BUILD/plane.svg. Exit status 0: the hashes were the same.
. tests/build/count.sh
. tests/build/golden.sh
build=$1 ticks=$2 inputs=${3:-tests/data/platformer.txt}
others=${4:-$inputs}
link=$build/plane-link
rm -rf "$link"
mkdir -p "$link"
mkfifo "$link/forth" "$link/back"

# play COMMAND...: player 0 here against the command as player 1. Each opens the ends of a pipe in the same order.
play() {
  "$@" <"$link/forth" >"$link/back" &
  other=$!
  # shellcheck disable=SC2086
  "$build/gjk-demo-plane" 0 "$inputs" "$ticks" $picture >"$link/forth" <"$link/back"
  status=$?
  wait $other && [ $status = 0 ]
}

echo 'Two processes on this machine:' >&2
picture=$build/plane.svg
play "$build/gjk-demo-plane" 1 "$others" "$ticks" || exit 1
picture=
missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -n "${missing# }" ]; then
  echo "This machine against a Cortex-M3 needs $missing: \`make setup\` installs them." >&2
else
  # The firmware holds its own inputs as a constant.
  awk '/^1 / {
      keys = (index($3, "L") > 0) + 2 * (index($3, "R") > 0) + 4 * (index($3, "J") > 0)
      runs = runs (runs == "" ? "" : ", ") "{" $2 ", " keys "}"
    }
    END { print "#define DEMO_PLANE_RUNS " runs }' "$others" >"$link/runs.h"
  echo 'Compiles the library for a Cortex-M3' >&2
  library cortex-m3 '' OPT=-O2 || exit 1
  make -s build/cortex-m3/demo_plane.elf TARGET=cortex-m3 \
    FIRMWARE_DEFINES="-DDEMO_PLANE_TICKS=$ticks -include $link/runs.h" >/dev/null || exit 1
  echo 'This machine against firmware on an emulated Cortex-M3:' >&2
  play timeout 300 qemu-system-arm -M mps2-an385 -display none -monitor none -serial stdio \
    -semihosting-config enable=on,target=native -kernel build/cortex-m3/demo_plane.elf || exit 1
fi
if ! command -v s390x-linux-gnu-gcc >/dev/null || ! command -v qemu-s390x >/dev/null; then
  echo 'This machine against a big-endian one needs gcc-s390x-linux-gnu, qemu-user: `make setup` installs them.' >&2
  exit 0
fi
echo 'Compiles the library for a big-endian machine' >&2
golden_library s390x gcc -O1 || exit 1
s390x-linux-gnu-gcc -std=c99 -O2 -static -Iinclude -Iport -Itests/support "$golden_objects"/gjk*.o \
  tests/programs/demo_plane/[!f]*.c tests/programs/demo_plane/flat_solver.c -lm -o "$build/demo-plane-s390x" || exit 1
echo 'This machine against an emulated big-endian one:' >&2
play qemu-s390x "$build/demo-plane-s390x" 1 "$others" "$ticks"
