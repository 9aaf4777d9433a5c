#!/bin/sh
# The lockstep demo: the same hashes, and what differs is named when one side goes wrong. test_scene_lockstep.sh BUILD
. tests/build/count.sh
build=$1

names_what_differs() {
  said=$(sh tests/build/demo-lockstep.sh "$build" 600 100 2>&1) || { echo "$said"; return 1; }
  echo "$said"
  echo "$said" | grep -q 'The two differ after tick' && echo "$said" | grep -q 'body [0-9]* position.x: ' &&
    echo "$said" | grep -q 'pair of body .*: distance '
}

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -n "${missing# }" ]; then
  skip 'lockstep with firmware' "$missing"
fi
if ! have s390x-linux-gnu-gcc || ! have qemu-s390x; then
  skip 'lockstep with a big-endian machine' 'gcc-s390x-linux-gnu qemu-user'
fi
check 'two sides stay the same' sh tests/build/demo-lockstep.sh "$build" 600
check 'a side that goes wrong is found' names_what_differs
finish scene_lockstep
