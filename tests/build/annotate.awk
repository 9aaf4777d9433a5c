# Writes a source file with annotations between its lines: awk -f annotate.awk path=PATH ANNOTATIONS PATH
#
# ANNOTATIONS has blocks. `in PATH` names the file that follows, `in PATH FUNCTION` a function of it. `before LINE` or
# `after LINE` is a line there, without its indentation, that must occur once. The lines up to the next of these stand
# before or after LINE in the output. Each is a comment by itself, so that what is proven is the source as it is
# shipped.
function fail(why) {
  print FILENAME ":" FNR ": " why >"/dev/stderr"
  failed = 1
  exit 1
}
FNR == NR {
  if ($0 ~ /^#/ || $0 ~ /^[ \t]*$/) next
  if ($1 == "in") { here = $2 == path; scope = $3; place = ""; next }
  if ($1 == "before" || $1 == "after") {
    if (!here) next
    place = scope "\n" substr($0, length($1) + 2)
    after[place] = $1 == "after"
    if (place in text) fail("a second time: " place)
    text[place] = ""
    next
  }
  if ($0 !~ /^ *\/\*@.*\*\/$/ || $0 ~ /\*\/./) fail("not a comment: " $0)
  if (here) text[place] = text[place] $0 "\n"
  next
}
/^[a-zA-Z].*\(/ {
  current = $0
  sub(/\(.*/, "", current)
  sub(/.*[ *]/, "", current)
}
{
  line = $0
  sub(/^ */, "", line)
  key = (current "\n" line) in text ? current "\n" line : "\n" line
  if (key in text) {
    if (key in seen) fail("a second time: " line)
    seen[key] = 1
    printf "%s%s", after[key] ? $0 "\n" : "", text[key]
    if (after[key]) next
  }
  print
}
END {
  if (!failed)
    for (key in text)
      if (!(key in seen)) {
        print path " has no line: " key >"/dev/stderr"
        failed = 1
      }
  exit failed
}
