#!/bin/sh
# The host's library with other values of macros: variant.sh FOLDER -DNAME=VALUE... leaves its objects in FOLDER. Those of
# sources that the macros do not change are those of build/host.
folder=$1
shift
compiler="${CC:-cc} -std=c99 -O2 -ffreestanding -Iinclude -Iport"
port='-DGJK_PORT_HEADER="hosted/gjk_port.h"'

key=$(cat build/host/library.flags tests/build/variant.sh src/*/*.[ch] include/*/*.h port/hosted/*.h | cksum)
[ "$key" != "$(cat "$folder/key" 2>/dev/null)" ] || exit 0
rm -rf "$folder"
mkdir -p "$folder"

# read_source SOURCE FLAGS...: a sum over what the compiler reads of it
read_source() {
  $compiler "$port" -E -P "$@" | cksum
}

# What it reads without the macros, once for all folders.
sums=build/host/sums
if [ "$(head -n 1 $sums 2>/dev/null)" != "$key" ]; then
  {
    echo "$key"
    for source in src/*/*.c; do
      echo "$source $(read_source "$source")"
    done
  } >"$sums.$$"
  mv "$sums.$$" $sums
fi

for source in src/*/*.c; do
  unit=$(basename "$source" .c)
  if grep -qxF "$source $(read_source "$source" "$@")" $sums; then
    cp "build/host/$unit.o" "$folder"
  else
    $compiler "$port" "$@" -c "$source" -o "$folder/$unit.o" || exit 1
  fi
done
echo "$key" >"$folder/key"
