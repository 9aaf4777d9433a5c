#!/bin/sh
# Writes the library as two files: amalgamate.sh FOLDER leaves FOLDER/gjk.h and gjk.c. Scripts that run at the same time
# each name a folder of their own.
#
# gjk.h holds every public header, gjk.c every file of src, each header where it is first included. Includes of the standard
# and of the port stay. The source of scenes, which src/plane_scene compiles once more for the plane, is written out a second
# time under the names of the plane: those of gjk2_scene_names.h, and names of the file's own with plane_scene_ before them.
dir=$1
. tests/build/version.sh
mkdir -p "$dir"

# heading WHAT: the comment that either file begins with
heading() {
  cat <<END
// gjk $version: exact collision queries in Q16.16, $1.
// Made by \`make amalgamation\`; its sources tell more.
//
// To build: compile gjk.c as C99 or C++17, with gjk.h beside it. Nothing must be configured. A build may define any of these
// macros, with one value in all of its files. None but GJK_ITERATIONS_MAX changes an answer.
//
//   GJK_ITERATIONS_MAX   1 to 250: the ceiling on the iterations of a query with a curved shape; 128 by default
//   GJK_PORT_HEADER      a header to include, in quotes, that defines any of those below; by default a gjk_port.h, if there is one
//   GJK_ASSERT(x)        what happens where x is false, which it must not return from; by default nothing
//   GJK_SHAPES           GJK_SHAPES_POINTS, _ROUND, _BOXES, _POLYTOPES or _ALL: the kinds of shapes to have code for; by default
//                        all, others are refused
//   GJK_CLZ32(x)         the leading zeros of a uint32_t that is not 0; by default the compiler's, or portable C
//   GJK_NARROW_MULTIPLY  1: no product of 32 x 32 to 64 bits is used; by default 1 on cores without one that are known
//   GJK_VECTORS          1: scans take eight vertices at a time; by default 1 with SSE2 and AArch64 unless built for size
//   GJK_INT128           1: GJK_INT128_TYPE names a signed integer of 128 bits; 0 by default
END
}

# expand PUBLIC FILE...: the files with what they include in its place; a header with an include guard once. PUBLIC: 0 leaves the
# public headers out.
expand() {
  public=$1
  shift
  awk -v with_public="$public" -v shared_files="$(echo src/scene/* src/scene_update/* src/scene_query/*)" '
    # The file that a line of from includes.
    function target(name, from) {
      if (name ~ /^gjk2?\//) return "include/" name
      sub(/[^\/]*$/, "", from)
      name = from name
      while (sub(/[^\/]+\/\.\.\//, "", name)) { }
      return name
    }
    # Is the file one that the plane has under other names?
    function is_shared(file) {
      return file ~ /^src\/scene(_update|_query)?\// && file !~ /gjk_scene_(common|sort)\.h$/
    }
    # The names of the plane: reads those of gjk2_scene_names.h, and those at the left margin of the shared files.
    function read_names(   file, line, word, n, files) {
      while ((getline line < "src/plane_scene/gjk2_scene_names.h") > 0) {
        n = split(line, word, " ")
        if (word[1] == "#define" && n == 3) planar[word[2]] = word[3]
      }
      n = split(shared_files, files, " ")
      for (; n > 0; n--) if (is_shared(files[n])) {
        while ((getline line < files[n]) > 0) {
          if (line ~ /^typedef (struct|enum) /) sub(/ \{$/, "", line)
          else if (line ~ /^} [a-z_0-9]+;$/) gsub(/[};]/, "", line)
          else if (line ~ /^([A-Z_]+ )?static /) sub(/(\[| =|\().*$/, "", line)
          else continue
          sub(/ *$/, "", line)
          sub(/^.*[^A-Za-z0-9_]/, "", line)
          if (!(line in planar) && line !~ /^gjk2?_/) planar[line] = "plane_scene_" line
        }
        close(files[n])
      }
    }
    # A line with the names of the plane. What follows a dot or an arrow is a field. In a comment only names of more than a
    # word are meant.
    function in_plane(line,   out, word, before, comment) {
      out = ""
      comment = match(line, /\/\/[^@]/) ? RSTART : length(line) + 1
      comment = length(line) - comment  # what is left of the line there
      while (match(line, /[A-Za-z_][A-Za-z0-9_]*/)) {
        word = substr(line, RSTART, RLENGTH)
        before = substr(out substr(line, 1, RSTART - 1), length(out) + RSTART - 2, 2)
        out = out substr(line, 1, RSTART - 1) (is_renamed(word, before, length(line) - RSTART < comment) ? planar[word] : word)
        line = substr(line, RSTART + RLENGTH)
      }
      return out line
    }
    function is_renamed(word, before, in_comment) {
      return word in planar && before !~ /(\.|->)$/ && (!in_comment || word ~ /_/)
    }
    function expand(file, depth,   line, name, text, guarded, count, lines, i, second, key) {
      second = of_plane && is_shared(file)
      key = second ? "plane " file : file
      if (key in done) return
      count = 0
      while ((getline line < file) > 0) { lines[++count] = line; text = text line "\n" }
      close(file)
      if (count == 0) { print file ": empty or missing" >"/dev/stderr"; exit 1 }
      guarded = file ~ /\.h$/ && text ~ /\n#define GJK2?_[A-Z0-9_]+_H\n/
      if (guarded) done[key]
      print "\n// ---- " file (second ? ", of the plane" : "")
      for (i = 1; i <= count; i++) {
        if (lines[i] == "#ifndef GJK_SCENE_OF_PLANE") {  # up to its #endif: what only space includes
          if (!second) expand(target(included(lines[i + 1]), file), depth + 1)
          i += 2
        } else if (lines[i] ~ /^ *#include "/) {
          name = target(included(lines[i]), file)
          if (name ~ /^include\// && !with_public) continue
          if (name ~ /gjk2_scene_names\.h$/) {
            expand("src/plane_scene/gjk2_scene_measure.h", depth + 1)
            continue
          }
          of_plane += name ~ /^src\/scene(_update|_query)?\/.*\.c$/
          expand(name, depth + 1)
          of_plane -= name ~ /^src\/scene(_update|_query)?\/.*\.c$/
        } else if (lines[i] !~ /^#(ifndef|define) GJK2?_[A-Z0-9_]+_H$/ || !guarded) {
          if (guarded && i == last_endif(lines, count)) continue
          print second ? in_plane(lines[i]) : lines[i]
        }
      }
      delete lines
    }
    function included(line) {
      gsub(/^[^"]*"|".*$/, "", line)
      return line
    }
    function last_endif(lines, count,   i) {
      for (i = count; i > 0; i--) if (lines[i] ~ /^#endif/) return i
    }
    BEGIN {
      read_names()
      for (n = 1; n < ARGC; n++) expand(ARGV[n], 0)
    }' "$@"
}

{
  heading 'all public headers in one'
  echo '#ifndef GJK_AMALGAMATION_H'
  echo '#define GJK_AMALGAMATION_H'
  expand 1 include/gjk/gjk.h include/gjk2/gjk2.h
  echo
  echo '#endif'
} >"$dir/gjk.h.part" || exit 1
{
  heading 'the whole library in one file'
  echo '#include "gjk.h"'
  # shellcheck disable=SC2046
  expand 0 $(find src -name '*.c' | sort)
} >"$dir/gjk.c.part" || exit 1
mv "$dir/gjk.h.part" "$dir/gjk.h"
mv "$dir/gjk.c.part" "$dir/gjk.c"
