#!/bin/sh
# Links the archive of a build as a shared library that shows only what the public headers name:
# shared.sh ARCHIVE OUT [SONAME [FILE...]]. FILEs are more sources, whose own gjk_ functions it shows, too. It needs no libc.
archive=$1
out=$2
soname=${3:-libgjk.so}
shift 2
[ $# = 0 ] || shift
{
  echo '{ global:'
  {
    ${NM:-nm} -g --defined-only "$archive" | awk 'NF == 3 { print $3 }' | sort -u >"$out.defined"
    cat include/gjk/*.h include/gjk2/*.h | grep -ohE '\bgjk2?_[a-z0-9_]+\b' | sort -u | comm -12 "$out.defined" -
    for file; do
      sed -n 's/^[a-z_0-9]* \(gjk_[a-z0-9_]*\)(.*/\1/p' "$file"
    done
  } | sed 's/$/;/'
  echo 'local: *; };'
} >"$out.exports"
${CC:-cc} -shared -std=c99 -O2 -fPIC -Iinclude "-Wl,-soname,$soname" "-Wl,--version-script=$out.exports" -Wl,--whole-archive \
  "$archive" -Wl,--no-whole-archive "$@" -o "$out" && rm -f "$out.defined" "$out.exports"
