#!/bin/sh
# What a source file may mention: headers of lower layers, four headers of the standard, no compiler, no floating point.
. tests/build/count.sh

# The table must be right before it can judge: every file exists, and each layer includes only layers further down.
table_is_ordered() {
  awk '/^[a-z]+:/ { at[$1] = NR; line[NR] = $0 }
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

table_has_no_ghosts() {
  for stem in $(sed -n 's/^[a-z]*: *\(.*\)->.*/\1/p' tests/build/layers.txt); do
    [ -e "src/$stem.c" ] || [ -e "src/$stem.h" ] || { echo "no file src/$stem"; return 1; }
  done
}

layered() {
  awk -f tests/build/includes.awk tests/build/layers.txt "$1"
}

# code FILE: the file without its comments and strings
code() {
  sed 's|//.*||; s/"[^"]*"//g' "$1"
}

no_floating_point() {
  ! code "$1" | grep -nwE 'float|double|long double|math\.h'
}

# Names that start with two underscores are the compiler's.
no_compiler() {
  ! code "$1" | sed 's/__cplusplus//g' | grep -nE '(^|[^A-Za-z0-9_])_[_A-Z][A-Za-z]'
}

check 'layers.txt: layers point down' table_is_ordered
check 'layers.txt: every file exists' table_has_no_ghosts
for file in src/*.[ch] include/gjk/*.h; do
  check "$file includes what its layer may" layered "$file"
  check "$file has no floating point" no_floating_point "$file"
  [ "$file" = src/wide.h ] || check "$file does not look at the compiler" no_compiler "$file"
done

# The rules must be able to refuse.
refused() {
  ! "$@"
}
scratch=$1/includes/src
mkdir -p "$scratch"
printf '#include "iteration.h"\n' >"$scratch/scan.c"
printf '#include <string.h>\n' >"$scratch/unit.c"
printf '#include "scan.h"\n' >"$scratch/unit.h"
printf 'int x = sizeof(double);\n#ifdef __GNUC__\n#endif\n' >"$scratch/root.c"
check 'an include upward is refused' refused layered "$scratch/scan.c"
check 'a fifth header is refused' refused layered "$scratch/unit.c"
check 'an include sideways is refused' refused layered "$scratch/unit.h"
check 'floating point is refused' refused no_floating_point "$scratch/root.c"
check 'a compiler test is refused' refused no_compiler "$scratch/root.c"
finish includes
