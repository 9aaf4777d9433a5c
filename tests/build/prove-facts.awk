# What a run of Eva leaves open, a line each: STATUS, tab, PLACES, tab, what. Input: the properties' table, Eva's report. -v driver: names the harness in what is open there; -v contracts: functions without their body.
#
#   unknown            a property that is not proven, in so many places of a function
#   stopped            the same; of the states that Eva keeps apart there, it is false for some, which end there
#   refuted            false for all states that reach it
#   unreached          a function and how many of its statements no path reaches; all: one of src that is never called
#
# Numbers that Frama-C gives to copies are dropped; of copies of a function the one with the most places counts.
BEGIN {
  FS = "\t"
  OFS = "\t"
  count = split(contracts, names, ",")
  for (i = 1; i <= count; i++) contract[names[i]]
}

function plain(name) {
  sub(/_[0-9]+$/, "", name)
  return name
}

FILENAME == ARGV[1] {
  if (FNR == 1 || $6 ~ /^(Valid|Considered valid|Dead)$/ || $1 ~ /FRAMAC/ || ($2 == "contracts.h" && $5 ~ /condition$/)) next
  property = $7
  gsub(/[a-z]_[0-9]+/, "&#", property)
  gsub(/_[0-9]+#/, "", property)
  gsub(/#/, "", property)
  gsub(/  +/, " ", property)
  kind = plain($5)
  status = $6 ~ /^Invalid/ ? "refuted" : tolower($6)
  what = ($1 ~ /prove$/ ? driver "/" : "") $2 " " plain($4) ": " (kind ~ /precondition/ ? kind ": " : "") property
  rows++
  row_status[rows] = status
  row_what[rows] = what
  row_copy[rows] = $4
  row_place[rows] = $1 "/" $2 ":" $3
  next
}

# '[eva:alarm] src/shape/gjk_scan.c:30: Warning: ', and the line after it
/^\[eva:alarm\]/ { split($0, field, " "); place = substr(field[2], 1, length(field[2]) - 1) }
/got status invalid/ { stopped[place] }

# Of the library's functions that some path of the text leads to, those never called: '<file>: name; name;', and on.
/^\[metrics\]/ { listing = 0 }
/^ *Unreached functions/ { listing = 1; next }
listing && /</ { listed = /<src\// }
listing && listed {
  sub(/.*>:/, "")
  count = split($0, names, ";")
  for (i = 1; i <= count; i++) {
    gsub(/ /, "", names[i])
    if (names[i] != "") never[plain(names[i])]
  }
}

# 'name: 5 stmts out of 9 (55.6%)'
/^  [a-zA-Z_0-9]+: [0-9]+ stmts out of [0-9]+/ {
  split($0, field, " ")
  name = plain(substr(field[1], 1, length(field[1]) - 1))
  if (name in contract) next
  called[name]
  if (field[2] < field[6]) unreached[name, field[6] - field[2]] = name
}

END {
  for (row = 1; row <= rows; row++) {
    status = row_status[row]
    fact = (status == "unknown" && row_place[row] in stopped ? "stopped" : status) OFS row_what[row]
    if (++places[fact, row_copy[row]] > most[fact]) most[fact] = places[fact, row_copy[row]]
  }
  for (fact in most) {
    split(fact, field, OFS)
    print field[1], most[fact], field[2]
  }
  for (key in unreached) {
    split(key, field, SUBSEP)
    print "unreached", field[2], field[1]
  }
  for (name in never) if (!(name in called) && !(name in contract)) print "unreached", "all", name
}
