# Checks one source file against layers.txt: awk -f includes.awk tests/build/layers.txt src/FILE
FNR == NR && /^[a-z]+:/ {
  split($0, side, "->")
  count = split(side[1], word, /[: ]+/)
  for (i = 2; i <= count; i++) if (word[i] != "") layer_of[word[i]] = word[1]
  count = split(side[2], word, " ")
  for (i = 1; i <= count; i++) allowed[$1 word[i]]
  next
}

FNR == NR { next }

FNR == 1 {
  stem = FILENAME
  sub(/.*\//, "", stem)
  sub(/\.[ch]$/, "", stem)
  layer = FILENAME ~ /^include\/gjk\// ? "public" : layer_of[stem]
  if (layer == "") { print FILENAME ": in no layer of layers.txt"; bad = 1; exit }
}

/^[ \t]*#[ \t]*include/ {
  name = $0
  sub(/^[^<"A-Z]*/, "", name)
  if (name ~ /^<(stdint|stddef|stdbool|limits)\.h>/) next
  if (name ~ /^GJK_PORT_HEADER/ && FILENAME == "src/port.h") next
  target = name
  if (name ~ /^"gjk\/[a-z]+\.h"/) to = "public"
  else {
    gsub(/"|\.h.*/, "", target)
    to = layer_of[target]
  }
  if (name !~ /^"gjk\// && target == stem && FILENAME ~ /\.c$/) next
  if (layer == "public" && to == "public") next
  if (!((layer ":" to) in allowed)) {
    print FILENAME ":" FNR ": layer '" layer "' may not include " name
    bad = 1
  }
}

END { exit bad }
