#!/bin/sh
# The library with its assertions as checks, under the sanitizers for undefined behaviour and addresses: checked.sh FOLDER
# leaves the sources in FOLDER/src and the objects beside it. A check that fails stops the program. -Og compiles in half the
# time of -O1.
folder=$1
. tests/build/count.sh
key=$(cat tests/build/checked.sh src/*/*.[ch] include/*/*.h | cksum)
[ "$key" != "$(cat "$folder/key" 2>/dev/null)" ] || exit 0
root=$(pwd)
rm -rf "$folder"
mkdir -p "$folder"
cp -r src "$folder/src"
for file in src/*/*.[ch]; do
  sed 's|//@ assert \(.*\);$|if (!(\1)) __builtin_trap();|; s|//@ .*||' "$file" >"$folder/$file"
done
# shellcheck disable=SC2046
rooms "$folder/rooms" $(printf '%s\n' "$folder"/src/*/*.c)
(cd "$folder" && "${CC:-cc}" -std=c99 -Og -fsanitize=undefined,address -fno-sanitize-recover=all -ffreestanding \
  -ffunction-sections -fdata-sections '-DGJK_ASSERT(condition)=((condition) ? (void)0 : __builtin_trap())' \
  "-I$root/include" -c rooms/*.c) && echo "$key" >"$folder/key"
