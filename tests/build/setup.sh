#!/bin/sh
# Installs the cross compilers and emulators that the tests use. Debian and its relatives.
set -e
PACKAGES='gcc g++ clang gcc-arm-none-eabi qemu-system-arm gcc-riscv64-unknown-elf qemu-system-misc
  gcc-avr avr-libc simavr frama-c-base clang-tidy clang-format cppcheck shellcheck'
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
$sudo apt-get update
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y --no-install-recommends $missing
