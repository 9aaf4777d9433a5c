# What a query's deepest stack consists of, in words: awk -f sizes-stack.awk STACK src/*/*.[ch] include/gjk/*.h
#
# STACK is what stack.awk prints for one root. A row is a function on the way down: its frame's bytes, its file, and the
# first sentence of the comment above it, or above its declaration.
NR == 1 {
  root = $1
  total = $2
  count = 0
  for (i = 3; i <= NF; i++) if ($i != ">") {
    name[++count] = $i
    bytes[count] = $(++i)
    sub(/.*:/, "", name[count])
    sub(/\.(part|isra|constprop).*/, "", name[count])
    wanted[name[count]] = 1
  }
  next
}

FNR == 1 { comment = "" }
/^\/\// {
  comment = comment (comment == "" ? "" : " ") substr($0, 4)
  next
}
/^[A-Za-z].*\(/ {
  called = $0
  sub(/\(.*/, "", called)
  sub(/.*[ *]/, "", called)
  if (called in wanted) {
    if (says[called] == "" && comment != "") says[called] = first(comment)
    if (/\{$/ || (/,$/ && (FILENAME ~ /\.c$/ || /inline/))) file[called] = FILENAME
  }
}
{ comment = "" }

function first(text,    at) {
  at = match(text, /\.( |$)/)
  return at ? substr(text, 1, at - 1) : text
}

END {
  printf "stack of %s on Cortex-M3 at -O2, bytes: %d, by frame from the caller down\n", root, total
  for (i = 1; i <= count; i++) {
    printf "%10d  %-32s%-28s%s\n", bytes[i], name[i], file[name[i]], says[name[i]]
  }
}
