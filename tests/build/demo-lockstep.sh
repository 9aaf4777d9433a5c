#!/bin/sh
# Two processes play a match: they exchange only inputs, and compare hashes each tick. demo-lockstep.sh BUILD TICKS
# [DIVERGE]. First both run on this machine, then one is firmware on an emulated Cortex-M3, then one runs on an
# emulated S390. With DIVERGE the side that judges goes wrong at that tick. Exit status 0: the hashes were the same, or
# with DIVERGE they were not.
. tests/build/count.sh
. tests/build/golden.sh
build=$1 ticks=$2 diverge=$3
link=$build/lockstep-link
rm -rf "$link"
mkdir -p "$link"
mkfifo "$link/forth" "$link/back"

# play COMMAND...: player 0 here against the command as player 1. Each opens the ends of a pipe in the same order.
play() {
  "$@" <"$link/forth" >"$link/back" &
  other=$!
  # shellcheck disable=SC2086
  "$build/lockstep" 0 "$ticks" $diverge >"$link/forth" <"$link/back"
  status=$?
  wait $other
  [ "$status" = "$([ -n "$diverge" ] && echo 1 || echo 0)" ]
}

echo 'Two processes on this machine:' >&2
play "$build/lockstep" 1 "$ticks" || exit 1
missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -n "${missing# }" ]; then
  echo "This machine against a Cortex-M3 needs $missing: \`make setup\` installs them." >&2
else
  echo 'Compiles the library for a Cortex-M3' >&2
  library cortex-m3 '' OPT=-O2 || exit 1
  make -s build/cortex-m3/lockstep.elf TARGET=cortex-m3 FIRMWARE_DEFINES="-DLOCKSTEP_TICKS=$ticks" >/dev/null || exit 1
  echo 'This machine against firmware on an emulated Cortex-M3:' >&2
  play timeout 300 qemu-system-arm -M mps2-an385 -display none -monitor none -serial stdio \
    -semihosting-config enable=on,target=native -kernel build/cortex-m3/lockstep.elf || exit 1
fi
if ! command -v s390x-linux-gnu-gcc >/dev/null || ! command -v qemu-s390x >/dev/null; then
  echo 'This machine against a big-endian one needs gcc-s390x-linux-gnu, qemu-user: `make setup` installs them.' >&2
  exit 0
fi
echo 'Compiles the library for a big-endian machine' >&2
golden_library s390x gcc -O1 || exit 1
s390x-linux-gnu-gcc -std=c99 -O2 -static -Iinclude -I. -Iport -Itests/support "$golden_objects"/gjk*.o tests/support/scene/match.c \
  tests/programs/lockstep/main.c tests/programs/lockstep/peer.c \
  -o "$build/lockstep-s390x" || exit 1
echo 'This machine against an emulated big-endian one:' >&2
play qemu-s390x "$build/lockstep-s390x" 1 "$ticks"
