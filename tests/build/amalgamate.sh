#!/bin/sh
# Writes the library as two files: amalgamate.sh BUILD leaves BUILD/amalgamation/gjk.h and gjk.c.
#
# gjk.h holds every public header, gjk.c every file of src, each header where it is first included. Includes of the standard
# and of the port stay.
build=$1
dir=$build/amalgamation
mkdir -p "$dir"

# expand PUBLIC FILE...: the files with what they include in its place; a header with an include guard once. PUBLIC: 0 leaves the
# public headers out.
expand() {
  public=$1
  shift
  awk -v with_public="$public" '
    # The file that a line of from includes.
    function target(name, from) {
      if (name ~ /^gjk2?\//) return "include/" name
      sub(/[^\/]*$/, "", from)
      name = from name
      while (sub(/[^\/]+\/\.\.\//, "", name)) { }
      return name
    }
    function expand(file, depth,   line, name, text, guarded, count, lines, i) {
      if (file in done) return
      count = 0
      while ((getline line < file) > 0) { lines[++count] = line; text = text line "\n" }
      close(file)
      if (count == 0) { print file ": empty or missing" >"/dev/stderr"; exit 1 }
      guarded = file ~ /\.h$/ && text ~ /\n#define GJK2?_[A-Z0-9_]+_H\n/
      if (guarded) done[file]
      print "\n// ---- " file
      for (i = 1; i <= count; i++) {
        if (lines[i] ~ /^ *#include "/) {
          name = lines[i]
          gsub(/^[^"]*"|".*$/, "", name)
          name = target(name, file)
          if (name ~ /^include\// && !with_public) continue
          expand(name, depth + 1)
        } else if (lines[i] !~ /^#(ifndef|define) GJK2?_[A-Z0-9_]+_H$/ || !guarded) {
          if (guarded && i == last_endif(lines, count)) continue
          print lines[i]
        }
      }
      delete lines
    }
    function last_endif(lines, count,   i) {
      for (i = count; i > 0; i--) if (lines[i] ~ /^#endif/) return i
    }
    BEGIN {
      for (n = 1; n < ARGC; n++) expand(ARGV[n], 0)
    }' "$@"
}

{
  echo '// gjk: exact collision queries in Q16.16, all public headers in one. Made by `make amalgamation`; its sources tell more.'
  echo '#ifndef GJK_AMALGAMATION_H'
  echo '#define GJK_AMALGAMATION_H'
  expand 1 include/gjk/gjk.h include/gjk/scene.h include/gjk2/gjk2.h
  echo
  echo '#endif'
} >"$dir/gjk.h.part" || exit 1
{
  echo '// gjk: exact collision queries in Q16.16, the whole library in one file. Compile it as C99 or C++17, with gjk.h beside it.'
  echo '#include "gjk.h"'
  # shellcheck disable=SC2046
  expand 0 $(find src -name '*.c' | sort)
} >"$dir/gjk.c.part" || exit 1
mv "$dir/gjk.h.part" "$dir/gjk.h"
mv "$dir/gjk.c.part" "$dir/gjk.c"
