# Checks source files against layers.txt: awk -f includes.awk tests/build/layers.txt src/ROOM/FILE...
FNR == NR && /^[a-z_]+:/ {
  room = substr($1, 1, length($1) - 1)
  known[room]
  allowed[room, room]
  for (i = 3; i <= NF; i++) allowed[room, $i]
  next
}

FNR == NR { next }

FNR == 1 {
  parts = split(FILENAME, part, "/")
  room = FILENAME ~ /(^|\/)include\/gjk\// ? "public" : FILENAME ~ /(^|\/)include\/gjk2\// ? "planar" : part[parts - 1]
  if (!(room in known)) { print FILENAME ": in no room of layers.txt"; bad = 1; exit }
}

/^[ \t]*#[ \t]*include/ {
  name = $0
  sub(/^[^<"A-Z]*/, "", name)
  if (name ~ /^<(stdint|stddef|stdbool|limits)\.h>/) next
  if (name ~ /^(GJK_PORT_HEADER|<gjk_port\.h>)/ && FILENAME ~ /src\/arith\/gjk_port_defaults\.h$/) next
  to = ""
  if (name ~ /^"gjk\/[a-z_]+\.h"/) to = "public"
  else if (name ~ /^"gjk2\/[a-z0-9]+\.h"/) to = "planar"
  else if (name ~ /^"gjk2?_[a-z_0-9]+\.h"/) to = room
  else if (name ~ /^"\.\.\/[a-z_]+\/gjk2?_[a-z_0-9]+\.h"/) { split(name, folder, "/"); to = folder[2] }
  else if (name ~ /^"\.\.\/scene(_update|_query)?\/gjk_scene_[a-z_]+\.c"/ && room == "plane_scene") to = "scene"
  if (to == "public" && room ~ /^plan/ && name !~ /^"gjk\/(body|format|number|status|version)\.h"/) to = "space"
  if (!((room, to) in allowed)) {
    print FILENAME ":" FNR ": room '" room "' may not include " name
    bad = 1
  }
}

END { exit bad }
