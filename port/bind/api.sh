#!/bin/sh
# Prints what the public headers declare, as api.awk does, and after each constant and enumerator its value, which stands for
# the lengths of arrays, too: api.sh FOLDER, in the project's folder. FOLDER is for what it compiles on the way.
mkdir -p "$1"
# Each header after those that it includes, so that a structure is known before it is a field.
headers=$(for header in include/gjk/*.h include/gjk2/*.h; do
  echo "$header $header"
  sed -n "s|^#include \"\(gjk.*\)\"|include/\1 $header|p" "$header"
done | tsort) || exit 1
# shellcheck disable=SC2086
awk -f port/bind/api.awk $headers >"$1/api.txt" || exit 1
{
  echo '#include <stdio.h>'
  for header in $headers; do
    echo "#include \"${header#include/}\""
  done
  echo 'int main(void) {'
  awk '/^(constant|enumerator) / { print "  printf(\"%s %lld\\n\", \"" $2 "\", (long long)(" $2 "));" }' "$1/api.txt"
  echo '  return 0;'
  echo '}'
} >"$1/values.c"
"${CC:-cc}" -std=c99 -Iinclude "$1/values.c" -o "$1/values" && "$1/values" >"$1/values.txt" || exit 1
awk 'NR == FNR { value[$1] = $2; next }
  $2 in value { print $1, $2, value[$2]; next }
  $1 == "field" && $4 in value { $4 = value[$4] }
  { print }' "$1/values.txt" "$1/api.txt"
