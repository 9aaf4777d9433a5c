#!/bin/sh
# The API reference: every public name is documented, every name in a comment exists, every header is listed, and what is
# missing would be noticed. test_docs.sh BUILD
. tests/build/count.sh
scratch=$1/docs_test

if ! have doxygen; then
  skip 'the API reference' doxygen
  finish docs
  exit
fi
rm -rf "$scratch"
mkdir -p "$scratch"

# nothing_missing: no warnings, which are shown
nothing_missing() {
  sh tests/build/docs.sh "$scratch" || return 1
  [ ! -s "$scratch/docs/warnings" ] || { cat "$scratch/docs/warnings"; return 1; }
}
check 'every public name is documented, every name in a comment exists' nothing_missing

# Each header has one row of the landing page's tables.
listed_once() {
  (cd include && find gjk gjk2 -name '*.h') | sort >"$scratch/headers"
  sed -n 's|^<td><a class="el" [^>]*>\(gjk2\{0,1\}/[a-z0-9_]*\.h\)</a></td>.*|\1|p' "$scratch/docs/html/index.html" | sort |
    diff "$scratch/headers" -
}
check 'the landing page lists every header once' listed_once

# Functions as the compiler sees them; each must be in a page, and have a man page.
functions() {
  for header in include/gjk/*.h include/gjk2/*.h; do
    sed 's|//.*||' "$header"
  done | grep -v '^typedef' | sed -n 's/^[a-z].*[ *]\(gjk2\{0,1\}_[a-z0-9_]*\)(.*/\1/p' | sort -u
}
every_function_has_a_page() {
  functions >"$scratch/functions"
  [ "$(wc -l <"$scratch/functions")" -gt 150 ] || { echo 'few functions'; return 1; }
  while read -r name; do
    ls "$scratch/docs/man/man3/$name".3* >/dev/null || return 1
    grep -q "class=\"memname\">[^<]*.* $name <\|class=\"memname\">.*$name *</td>" "$scratch"/docs/html/*_8h.html || { echo "$name"; return 1; }
  done <"$scratch/functions"
}
check 'every function has its place in HTML and a man page' every_function_has_a_page

# A name of each kind without a comment, and a comment that mentions what does not exist.
cp -r include "$scratch/include"
awk '{ print }
  /^uint32_t gjk_vec3_length/ {
    print "\nint gjk_fault_function(int a);"
    print "\ntypedef int gjk_fault_type;"
    print "\nextern const int gjk_fault_variable;"
    print "\n#define GJK_FAULT_MACRO 1"
    print "\n#define GJK_FAULT_CALL(x) (x)"
    print "\ntypedef struct gjk_fault_struct {\n  int bare;  // said\n} gjk_fault_struct;"
    print "\n// Said.\ntypedef struct gjk_said {\n  int said_member;  // said\n  int fault_member;\n  int other_fault, last_fault;\n} gjk_said;"
    print "\n// Said.\ntypedef enum gjk_said_enum {\n  GJK_SAID_FIRST,  // said\n  GJK_FAULT_VALUE\n} gjk_said_enum;"
    print "\n// As gjk_fault_nowhere.\nint gjk_said_function(int a);"
  }' include/gjk/math.h >"$scratch/include/gjk/math.h"
sh tests/build/docs.sh "$scratch/faults" "$scratch/include"
for name in gjk_fault_function gjk_fault_type gjk_fault_variable GJK_FAULT_MACRO GJK_FAULT_CALL gjk_fault_struct \
  fault_member other_fault last_fault GJK_FAULT_VALUE gjk_fault_nowhere; do
  check "$name is noticed" grep -q "$name" "$scratch/faults/docs/warnings"
done
not_noticed() {
  ! grep "$1" "$scratch/faults/docs/warnings"
}
for name in gjk_said_function said_member GJK_SAID_FIRST; do
  check "$name is documented" not_noticed "$name"
done
finish docs
