#!/bin/sh
# The API reference of the headers in HTML and man pages, by doxygen: docs.sh BUILD [INCLUDE]. It is in BUILD/docs; what is
# not documented, and names in comments that do not exist, are in BUILD/docs/warnings.
out=$1/docs
include=${2:-include}
if ! command -v doxygen >/dev/null; then
  echo 'docs: no doxygen here: apt-get install doxygen' >&2
  exit 1
fi
rm -rf "$out"
mkdir -p "$out" || exit 1

# version PART: a number of gjk/version.h
version() {
  sed -n "s/^#define GJK_VERSION_$1 //p" "$include/gjk/version.h"
}

# purpose HEADER: the first sentence of its first comment
purpose() {
  awk -f tests/build/docs-filter.awk "$1" 2>/dev/null | sed -n '/@brief/{s/.*@brief //p;q}'
}

# headers FOLDER NAMES...: a table of them
headers() {
  folder=$1
  shift
  echo '<table class="headers">'
  for name in "$@"; do
    [ ! -e "$include/$folder/$name.h" ] || echo "<tr><td>$folder/$name.h</td><td>$(purpose "$include/$folder/$name.h")</td></tr>"
  done
  echo '</table>'
}

# The landing page: a program, and every header.
{
  echo '/** @mainpage Every header'
  echo 'Each comment is the contract of what it stands above: formats and units, ranges, accuracy, ownership, statuses, cost.'
  echo 'Lengths are Q16.16, unit vectors and rotations Q2.30. A program includes the headers that it uses, or gjk/gjk.h or'
  echo 'gjk2/gjk2.h for all of them.'
  echo '<h2>A first program</h2>'
  echo '@code{.c}'
  cat tests/programs/examples/distance.c
  echo '@endcode'
  grep -v '^#' tests/build/docs-groups.txt | while IFS=: read -r title names; do
    echo "<h2>$title</h2>"
    # shellcheck disable=SC2086
    headers gjk $names
  done
  others=$(find "$include/gjk" -name '*.h' | sed 's|.*/||; s/\.h$//' | sort | while read -r name; do
    grep -v '^#' tests/build/docs-groups.txt | grep -q -w "$name" || echo "$name"
  done)
  if [ -n "$others" ]; then
    echo '<h2>And</h2>'
    # shellcheck disable=SC2086
    headers gjk $others
  fi
  echo '<h2>In the plane</h2>'
  # shellcheck disable=SC2046
  headers gjk2 $(find "$include/gjk2" -name '*.h' | sed 's|.*/||; s/\.h$//' | sort)
  echo '*/'
} >"$out/main.dox"

# doxygen's own layout, with what a header says of itself above the list of what it holds.
(cd "$out" && doxygen -l layout.xml >/dev/null)
awk '
  /<tab type="(pages|topics|modules|namespaces|interfaces|concepts|structs|exceptions|examples)"/ { skipping = /[^\/]>$/; next }
  skipping { if (/<\/tab>/) skipping = 0; next }
  /<tab type="files" / { sub(/title=""/, "title=\"Headers\"") }
  /<file>/ { inside = 1 }
  inside && /<detaileddescription/ { next }
  inside && /<briefdescription/ { print "    <detaileddescription title=\"What it is\"/>"; inside = 0; moved = 1; next }
  moved && /<detaileddescription/ { moved = 0; next }
  { print }' "$out/layout.xml" >"$out/own-layout.xml"

cat >"$out/doxyfile" <<END
PROJECT_NAME = gjk
PROJECT_NUMBER = $(version MAJOR).$(version MINOR).$(version PATCH)
PROJECT_BRIEF = "Exact collision queries in Q16.16"
INPUT = $include $out/main.dox
FILE_PATTERNS = *.h *.dox
RECURSIVE = YES
STRIP_FROM_PATH = $include
OUTPUT_DIRECTORY = $out
INPUT_FILTER = "awk -f tests/build/docs-filter.awk"
FILTER_PATTERNS = *.dox=cat
LAYOUT_FILE = $out/own-layout.xml
HTML_EXTRA_STYLESHEET = tests/build/docs.css
MARKDOWN_SUPPORT = NO
OPTIMIZE_OUTPUT_FOR_C = YES
SORT_MEMBER_DOCS = NO
INLINE_SIMPLE_STRUCTS = YES
TYPEDEF_HIDES_STRUCT = YES
ALWAYS_DETAILED_SEC = YES
EXTRACT_ALL = NO
HIDE_UNDOC_MEMBERS = NO
SHOW_INCLUDE_FILES = NO
VERBATIM_HEADERS = NO
HAVE_DOT = NO
CLASS_GRAPH = NO
GENERATE_LATEX = NO
GENERATE_TREEVIEW = YES
TREEVIEW_WIDTH = 230
DISABLE_INDEX = NO
HTML_TIMESTAMP = NO
QUIET = YES
WARN_IF_UNDOCUMENTED = YES
PREDEFINED = NULL=0
END
doxygen "$out/doxyfile" 2>"$out/warnings"

# A header's title names its folder, too.
for page in "$out"/html/*_8h.html; do
  path=$(sed -n 's,.*<title>gjk: \(.*\) File Reference.*,\1,p' "$page")
  sed -i "s,<title>gjk: .*File Reference,<title>$path,; s,\"title\">[^<]* File Reference,\"title\">$path," "$page"
done

# Man pages: a section for each folder, since both have headers of the same name. They have no links.
for folder in gjk gjk2; do
  {
    cat "$out/doxyfile"
    echo "INPUT = $include/$folder"
    echo 'INPUT_FILTER = "awk -v links=0 -f tests/build/docs-filter.awk"'
    echo 'GENERATE_HTML = NO'
    echo 'GENERATE_MAN = YES'
    echo "MAN_EXTENSION = .3$folder"
    echo 'MAN_SUBDIR = man3'
    echo 'MAN_LINKS = YES'
    echo 'WARNINGS = NO'
  } >"$out/man-doxyfile"
  doxygen "$out/man-doxyfile" 2>/dev/null
done
rm -f "$out"/*doxyfile "$out"/*layout.xml "$out/main.dox"
