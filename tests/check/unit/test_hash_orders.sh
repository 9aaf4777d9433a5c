#!/bin/sh
# Hashes of a program's own state are the same on a big-endian machine. test_hash_orders.sh BUILD
. tests/build/count.sh
. tests/build/golden.sh
build=$1/hash-orders
mkdir -p "$build"

big_endian() {
  s390x-linux-gnu-gcc -std=c99 -O2 -static -Iinclude -Itests/support tests/check/unit/test_hash.c src/arith/gjk_hash.c \
    -o "$build/hash" && qemu-s390x "$build/hash"
}

missing=$(golden_missing s390x gcc)
if [ -z "$missing" ]; then
  check 's390x' big_endian
else
  skip 's390x' "$missing"
fi
finish hash_orders
