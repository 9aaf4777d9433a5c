# What programs are made of, in words: awk -f sizes-parts.awk src/README.md src/*/*.c PROGRAMS
#
# PROGRAMS has lines 'TITLE:MAP', the linker's map of each. A row is a file of the library, with the bytes that each
# program links of it and the first sentence of the file. Rooms are told by the table of rooms in src/README.md.

# | `room` | what is in it | uses |
FILENAME ~ /README\.md$/ {
  if (split($0, cell, /`|\|/) >= 6 && cell[3] ~ /^[a-z]+$/ && /^\| `/) {
    room_says[cell[3]] = cell[5]
    gsub(/^ +| +$/, "", room_says[cell[3]])
  }
  next
}

FILENAME ~ /\.c$/ {
  if (FNR == 1) {
    count = split(FILENAME, part, "/")
    file = part[count]
    sub(/\.c$/, "", file)
    room[file] = part[count - 1]
    told = 0
  }
  if (!told && /^\/\/ /) {
    line = substr($0, 4)
    at = match(line, /\.( |$)/)
    says[file] = says[file] (says[file] == "" ? "" : " ") (at ? substr(line, 1, at - 1) : line)
    told = at > 0
  } else {
    told = 1
  }
  next
}

{
  split($0, field, ":")
  at = length($0)
  while (substr($0, at, 1) != ":") at--
  title[++programs] = substr($0, 1, at - 1)
  read_map(substr($0, at + 1), programs)
}

# The bytes of code and constants by file. A section's name stands on a line of its own where it is long.
function read_map(map, program,    line, count, word, size, object, inside) {
  inside = 0
  while ((getline line < map) > 0) {
    if (line ~ /^Linker script and memory map/) inside = 1
    if (!inside) continue
    count = split(line, word, " ")
    if (line !~ /0x[0-9a-f]+ +0x[0-9a-f]+ .*gjk_[a-z_0-9]+\.o\)?$/) {
      named = word[1]
      continue
    }
    if (word[1] !~ /^0x/) named = word[1]
    if (named !~ /^\.(text|rodata|data|ARM\.ex)/) continue
    size = value_of(word[count - 1])
    object = word[count]
    sub(/\)?$/, "", object)
    sub(/\.o$/, "", object)
    sub(/.*[(\/]/, "", object)
    bytes[object, program] += size
    all[program] += size
    if (object in room) of_room[room[object], program] += size
    linked[object] = 1
  }
  close(map)
}

function value_of(hex,    i, out) {
  out = 0
  for (i = 3; i <= length(hex); i++) out = 16 * out + index("0123456789abcdef", substr(hex, i, 1)) - 1
  return out
}

function row(name, words,    p) {
  printf "%-24s", name
  for (p = 1; p <= programs; p++) printf "%11s", (numbers[p] > 0 ? numbers[p] : "-")
  printf "  %s\n", words
}

END {
  printf "%-24s", ""
  for (p = 1; p <= programs; p++) printf "%11s", title[p]
  printf "\n"
  rooms = split("scene motion query contact depth gjk place shape arith", order, " ")
  for (r = 1; r <= rooms; r++) {
    used = 0
    for (p = 1; p <= programs; p++) used += numbers[p] = of_room[order[r], p]
    if (!used) continue
    row(order[r], room_says[order[r]])
    count = 0
    for (file in room) if (room[file] == order[r] && file in linked) names[++count] = file
    sort(count)
    for (i = 1; i <= count; i++) {
      for (p = 1; p <= programs; p++) numbers[p] = bytes[names[i], p]
      row("  " names[i], says[names[i]])
    }
  }
  for (p = 1; p <= programs; p++) numbers[p] = all[p]
  row("all", "")
}

# Sorts names by the bytes of the first program that links them, most first.
function sort(count,    i, k, held) {
  for (i = 2; i <= count; i++) {
    held = names[i]
    for (k = i - 1; k >= 1 && less(names[k], held); k--) names[k + 1] = names[k]
    names[k + 1] = held
  }
}

function less(a, b,    p) {
  for (p = 1; p <= programs; p++) {
    if (bytes[a, p] + 0 != bytes[b, p] + 0) return bytes[a, p] + 0 < bytes[b, p] + 0
  }
  return a > b
}
