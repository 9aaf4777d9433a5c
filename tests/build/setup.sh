#!/bin/sh
# Installs the cross compilers and emulators that the tests use, or with 'matrix' those of `make matrix`, too: Debian
# and its relatives. Debian's gcc-multilib cannot stay beside its cross compilers: apt-get takes it away.
set -e
PACKAGES='gcc g++ clang libclang-rt-dev gcc-arm-none-eabi qemu-system-arm gcc-riscv64-unknown-elf qemu-system-misc
  gcc-avr avr-libc simavr frama-c-base why3 z3 cvc4 clang-tidy clang-format cppcheck shellcheck doxygen
  gcc-i686-linux-gnu libc6-dev-i386-cross gcc-aarch64-linux-gnu libc6-dev-arm64-cross
  cmake pkg-config arduino-core-avr gcc-s390x-linux-gnu libc6-dev-s390x-cross qemu-user
  lld chromium python3 nodejs cargo rustc rust-src mono-mcs mono-runtime node-typescript python3-numpy python3-pip'
# Other packages of nodejs bring npm along, and refuse Debian's.
command -v npm >/dev/null || PACKAGES="$PACKAGES npm"
# Only `make matrix` uses these, and says so where one is missing.
MATRIX_PACKAGES='gcc-riscv64-linux-gnu libc6-dev-riscv64-cross
  gcc-powerpc-linux-gnu libc6-dev-powerpc-cross'
[ "$1" != matrix ] || PACKAGES="$PACKAGES $MATRIX_PACKAGES"
if ! command -v apt-get >/dev/null; then
  echo "setup: no apt-get here; install the equivalents of: $PACKAGES" >&2
  exit 1
fi
missing=
for package in $PACKAGES; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "setup: everything is installed"
  exit 0
fi
sudo=
[ "$(id -u)" = 0 ] || sudo=sudo

# apt_get WORDS...: waits for the locks that another apt holds, ten minutes at most. apt-get waits by itself for dpkg's lock
# alone, not for those on its lists and archives.
apt_get() {
  said=$(mktemp)
  tries=120
  until $sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 "$@" 2>"$said"; do
    cat "$said" >&2
    if ! grep -q -i -E 'could not get lock|unable to (lock|acquire)' "$said" || [ $tries = 0 ]; then
      rm -f "$said"
      return 1
    fi
    echo "setup: another apt is at work; waiting for it" >&2
    tries=$((tries - 1))
    sleep 5
  done
  cat "$said" >&2
  rm -f "$said"
}

apt_get update
# shellcheck disable=SC2086
apt_get install -y --no-install-recommends $missing
