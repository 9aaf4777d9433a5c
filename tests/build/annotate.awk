# Writes a source file with annotations between its lines: awk -f annotate.awk path=PATH ANNOTATIONS PATH
#
# ANNOTATIONS has blocks. `in PATH` names the file that follows, `before LINE` or `after LINE` a line of it, without its
# indentation, that must occur once. The lines up to the next of these stand before or after LINE in the output. Each is a
# comment by itself, so that what is proven is the source as it is shipped.
function fail(why) {
  print FILENAME ":" FNR ": " why >"/dev/stderr"
  failed = 1
  exit 1
}
FNR == NR {
  if ($0 ~ /^#/ || $0 ~ /^[ \t]*$/) next
  if ($1 == "in") { here = $2 == path; place = ""; next }
  if ($1 == "before" || $1 == "after") {
    if (!here) next
    place = substr($0, length($1) + 2)
    after[place] = $1 == "after"
    if (place in text) fail("a second time: " place)
    text[place] = ""
    next
  }
  if ($0 !~ /^ *\/\*@.*\*\/$/ || $0 ~ /\*\/./) fail("not a comment: " $0)
  if (here) text[place] = text[place] $0 "\n"
  next
}
{
  line = $0
  sub(/^ */, "", line)
  if (line in text) {
    if (line in seen) fail("a second time: " line)
    seen[line] = 1
    printf "%s%s", after[line] ? $0 "\n" : "", text[line]
    if (after[line]) next
  }
  print
}
END {
  if (!failed)
    for (line in text)
      if (!(line in seen)) {
        print path " has no line: " line >"/dev/stderr"
        failed = 1
      }
  exit failed
}
