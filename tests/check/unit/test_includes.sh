#!/bin/sh
# What a source file may mention: headers of lower rooms, four headers of the standard, no compiler, no floating point. Which
# files call each other.
. tests/build/count.sh

# The table must be right before it can judge: every room exists, and each includes only rooms further down.
table_is_ordered() {
  awk '/^[a-z_]+:/ { at[$1] = NR; line[NR] = $0 }
    END {
      for (n in line) {
        split(line[n], side, "->")
        from = substr(line[n], 1, index(line[n], ":"))
        count = split(side[2], to, " ")
        for (i = 1; i <= count; i++) {
          if (at[to[i] ":"] <= at[from]) { print from " -> " to[i] " does not point down"; bad = 1 }
        }
      }
      exit bad
    }' tests/build/layers.txt
}

table_has_all_rooms() {
  sed -n 's/^\([a-z_]*\):.*/\1/p' tests/build/layers.txt | grep -v -e '^public$' -e '^planar$' | sort >"$1/rooms"
  find src -mindepth 1 -maxdepth 1 -type d | sed 's|src/||' | sort | diff "$1/rooms" -
}

# A flat build, and a user's include path, may hold other files of every name that has no prefix.
files_have_own_names() {
  ! find src -name '*.[ch]' | sed 's|.*/||' | grep -v -e '^gjk_' -e '^gjk2_' || return 1
  [ -z "$(find src -name '*.c' | sed 's|.*/||' | sort | uniq -d)" ] && [ -z "$(find src -name '*.h' | sed 's|.*/||' | sort | uniq -d)" ]
}

# circles DIR: the headers below it that include each other in a circle
no_circle() {
  find "$1" -name '*.h' -exec grep -H '^ *# *include "' {} + |
    sed -n 's|^[^:]*/\([a-z_0-9]*\)\.h: *# *include "\(.*/\)*\(gjk2\{0,1\}_[a-z_0-9]*\)\.h".*|\1 \3|p' | tsort >/dev/null
}

# no_circle_of_calls OBJECTS...: objects that call each other, or name each other's tables, in a circle
no_circle_of_calls() {
  nm -A "$@" | sed 's|^.*/\([^/]*\)\.o:[^ ]* *|\1 |' | awk '
    $2 == "U" { user[NR] = $1; used[NR] = $3; next }
    $2 ~ /[A-Z]/ { owner[$3] = $1; seen++ }
    END { for (i in user) if (used[i] in owner) print user[i], owner[used[i]]; if (!seen) print "no-object" }' |
    tsort >/dev/null
}

layered() {
  awk -f tests/build/includes.awk tests/build/layers.txt "$@"
}

# in_code PATTERN FILES...: the lines that have it beside comments and strings
in_code() {
  pattern=$1
  shift
  grep -HnE "$pattern" "$@" | sed 's|//.*||; s/"[^"]*"//g; s/__cplusplus//g' | grep -E "^[^:]*:[0-9]+:(.*[^A-Za-z0-9_])?$pattern"
}

no_floating_point() {
  ! in_code '(float|double|math\.h)([^A-Za-z0-9_]|$)' "$@"
}

# Names that start with two underscores are the compiler's.
no_compiler() {
  ! in_code '_[_A-Z][A-Za-z]' "$@"
}

# shared FILES: the files that the plane shares include nothing with a dimension but through gjk_scene_space.h and
# gjk_scene_measure.h.
shared() {
  ! grep -n '#include' "$@" | grep -v -e '"\.\./arith/gjk_[a-z]*\.h"' -e '"\(\.\./scene[a-z_]*/\)*gjk_scene_[a-z]*\.h"'
}

scratch=$1/includes/src
rm -rf "$scratch"
mkdir -p "$scratch/shape" "$scratch/plane" "$scratch/arith" "$scratch/attic" "$scratch/circle"
# shellcheck disable=SC2046
check 'sources of scenes that the plane shares name no dimension' \
  shared $(sed -n 's|#include "\.\./\(scene[a-z_]*/.*\.c\)"|src/\1|p' src/plane_scene/*.c)
check 'layers.txt: rooms point down' table_is_ordered
check 'layers.txt: the rooms there are' table_has_all_rooms "$scratch"
check 'every file of src has a name of its own, with the prefix' files_have_own_names
check 'no headers include each other in a circle' no_circle src
check 'the library builds' library host ''
check 'no objects call each other in a circle' no_circle_of_calls build/host/gjk*.o
check 'each file includes what its room may' layered src/*/*.[ch] include/gjk/*.h include/gjk2/*.h
check 'no floating point' no_floating_point src/*/*.[ch] include/gjk/*.h include/gjk2/*.h
# shellcheck disable=SC2046
check 'no look at the compiler but in two files' \
  no_compiler $(printf '%s\n' src/*/*.[ch] include/gjk/*.h include/gjk2/*.h | grep -v '^src/arith/gjk_\(wide\|port_defaults\)\.h$')

# The rules must be able to refuse.
refused() {
  ! "$@"
}
printf '#include "../gjk/gjk_iteration.h"\n' >"$scratch/shape/gjk_upward.c"
printf '#include "gjk/shape.h"\n' >"$scratch/plane/gjk2_space.c"
printf '#include "gjk2/shape.h"\n' >"$scratch/shape/gjk_plane.c"
printf '#include "../scene/gjk_scene_tree.c"\n' >"$scratch/plane/gjk2_source.c"
printf '#include "gjk_scene_tree.h"\n#include "gjk/pose.h"\n' >"$scratch/plane/gjk_shared.c"
printf '#include <string.h>\n' >"$scratch/arith/gjk_library.c"
printf '#include "../arith/../shape/gjk_scan.h"\n' >"$scratch/arith/gjk_around.h"
printf '#include "gjk_scan.h"\n' >"$scratch/attic/gjk_attic.c"
printf 'int x = sizeof(double);\n#ifdef __GNUC__\n#endif\n' >"$scratch/arith/gjk_double.c"
printf '#include "gjk_two.h"\n' >"$scratch/circle/gjk_one.h"
printf '#include "../circle/gjk_one.h"\n' >"$scratch/circle/gjk_two.h"
check 'an include upward is refused' refused layered "$scratch/shape/gjk_upward.c"
check 'a fifth header is refused' refused layered "$scratch/arith/gjk_library.c"
check 'a path around the rooms is refused' refused layered "$scratch/arith/gjk_around.h"
check 'space is refused in the plane' refused layered "$scratch/plane/gjk2_space.c"
check 'a source of scenes is refused in the plane without scenes' refused layered "$scratch/plane/gjk2_source.c"
check 'a dimension is refused in a shared source' refused shared "$scratch/plane/gjk_shared.c"
check 'the plane is refused in space' refused layered "$scratch/shape/gjk_plane.c"
check 'a file in no room is refused' refused layered "$scratch/attic/gjk_attic.c"
check 'a circle is refused' refused no_circle "$scratch/circle"
printf 'void gjk_two(void);\nvoid gjk_one(void) { gjk_two(); }\n' >"$scratch/circle/gjk_one.c"
printf 'void gjk_one(void);\nvoid gjk_two(void) { gjk_one(); }\n' >"$scratch/circle/gjk_two.c"
for name in gjk_one gjk_two; do
  "${CC:-cc}" -c "$scratch/circle/$name.c" -o "$scratch/circle/$name.o"
done
check 'a call is allowed' no_circle_of_calls "$scratch/circle/gjk_one.o"
check 'a circle of calls is refused' refused no_circle_of_calls "$scratch/circle/gjk_one.o" "$scratch/circle/gjk_two.o"
check 'floating point is refused' refused no_floating_point "$scratch/arith/gjk_double.c"
check 'a compiler test is refused' refused no_compiler "$scratch/arith/gjk_double.c"
finish includes
