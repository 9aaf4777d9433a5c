#!/bin/sh
# Writes a page of traced pairs, with all that it needs in one file: demo-trace.sh BUILD CASES
# A case has its heading after its ID, and its text in the comment above it. What is written is BUILD/trace.html.
build=$1
dir=$build/trace
rm -rf "$dir"
mkdir -p "$dir"

# A file for each case, with its heading and its text; their names in their order.
awk -v dir="$dir" '
  /^#/ { text = text substr($0, 2) "\n"; next }
  /^$/ { if (id == "") text = ""; next }
  /^case2? / {
    id = sprintf("%02d-%s", ++count, $2)
    print id
    heading = $0
    sub(/^case2? +[^ ]+ */, "", heading)
    print heading >(dir "/" id ".heading")
    printf "%s", text >(dir "/" id ".text")
    text = ""
  }
  { print >(dir "/" id ".txt") }' "$2" >"$dir/names"

escape() {
  sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g'
}

# answer WHO OPTION...: a line of the answers
answer() {
  who=$1
  shift
  printf '<dt>%s</dt><dd><code>' "$who"
  "$build/gjk-query" "$@" "$dir/$id.txt" | sed 's/^[^ ]* //' | escape
  printf '</code></dd>\n'
}

{
  cat <<'END_HEAD'
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>gjk: what each iteration does</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
:root{color-scheme:light dark}
body{margin:0 auto;max-width:1240px;padding:16px 20px;background:#eef1f5;color:#1d2733;font:16px/1.5 system-ui,'DejaVu Sans',sans-serif}
h1{font-size:26px;margin:8px 0}h2{font-size:21px;margin:40px 0 4px}p{max-width:90ch;margin:6px 0}
svg{max-width:100%;height:auto;display:block}figure{margin:8px 0}
dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 14px;margin:8px 0}dt{font-weight:600}dd{margin:0;overflow-wrap:anywhere}
pre{overflow-x:auto;font-size:13px}summary{cursor:pointer}
@media(prefers-color-scheme:dark){body{background:#11161b;color:#e8edf2}}
</style></head>
<body>
<h1>gjk: what each iteration does</h1>
<p>On the left the shapes, and their support points a and b along the direction d and against it (green). On the right
their Minkowski difference A &#8722; B, all points of A less all points of B: the shapes share a point where it holds the
origin O, and are as far apart as O is from it. The new vertex is w = a &#8722; b (red ring), the simplex is violet, dashed
what it was before. All of it is the library's own search, iteration by iteration, in exact integers.</p>
END_HEAD
  while read -r id; do
    printf '<h2>%s</h2>\n<p>%s</p>\n<dl>\n' "$(escape <"$dir/$id.heading")" "$(escape <"$dir/$id.text")"
    "$build/gjk-query" --trace --trace-svg "$dir/$id.svg" "$dir/$id.txt" >"$dir/$id.trace" || exit 1
    answer gjk --certify 2>/dev/null
    answer 'GJK in <code>double</code>' --reference --certify 2>/dev/null
    printf '</dl>\n<figure>\n'
    cat "$dir/$id.svg"
    printf '</figure>\n<details><summary>The same as text</summary><pre>'
    escape <"$dir/$id.trace"
    printf '</pre></details>\n'
  done <"$dir/names"
  printf '</body></html>\n'
} >"$build/trace.html"
