# What a run of Eva leaves open, a line each: STATUS, tab, PLACES, tab, what. Input: the properties' table, Eva's report.
# -v driver: names the harness in what is open there; -v contracts: functions without their body; -v full=1: a line per
# property instead, KIND first.
#
#   unknown            properties of a kind that are not proven, in so many places of a function
#   stopped            the same; of the states that Eva keeps apart there, it is false for some, which end there
#   refuted            false for all states that reach it
#   unreached          a function that is called, and how many of its statements no path reaches: calls of others among them
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

# The kinds that assumed.txt tells apart.
function kind_of(kind) {
  if (kind ~ /^(signed|unsigned)_(overflow|downcast)$/) return "range"
  if (kind ~ /^(initialization|bool_value)$/) return "init"
  if (kind ~ /^(mem_access|index_bound|dangling_pointer|function_pointer|pointer_value|separation|overlap)$/) return "memory"
  if (kind ~ /^precondition of/) return "contract"
  return kind == "user assertion" ? "assert" : kind
}

FILENAME == ARGV[1] {
  if (FNR == 1 || $6 ~ /^(Valid|Considered valid|Dead)$/ || $1 ~ /FRAMAC/ || ($2 == "contracts.h" && $5 ~ /condition$/)) next
  property = $7
  gsub(/[a-z]_[0-9]+/, "&#", property)
  gsub(/_[0-9]+#/, "", property)
  gsub(/#/, "", property)
  gsub(/  +/, " ", property)
  kind = plain($5)
  status = $6 ~ /^Invalid/ ? "refuted" : "unknown"
  what = ($1 ~ /prove$/ ? driver "/" : "") $2 " " plain($4) " " kind_of(kind)
  if (full) {
    print status, what, (kind ~ /precondition/ ? kind ": " : "") property
    next
  }
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

# 'name: 5 stmts out of 9 (55.6%)'
/^  [a-zA-Z_0-9]+: [0-9]+ stmts out of [0-9]+/ {
  split($0, field, " ")
  name = plain(substr(field[1], 1, length(field[1]) - 1))
  if (name in contract) next
  if (field[2] < field[6]) unreached[name, field[6] - field[2]] = name
}

END {
  if (full) exit
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
}
