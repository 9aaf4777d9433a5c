# What a low ceiling on iterations leaves of the answers that parts.c prints: awk -f parts.awk FULL LOW
#
# Where a query reports the limit, its bounds hold what the usual ceiling finds, 2 LSB of curved shapes apart, and its contacts
# are among those found then. Where it does not, its answer is the same; of times of impact the fraction need not be, as parts.c says.
function fail(what) {
  print what ": " $0
  bad = 1
}

function is_contact(name) {
  return name == "of_part" || name == "of_triangle"
}

FNR == NR {
  if (is_contact($2)) known[$1, $2, $4, $5, $6, $7] = 1
  else {
    hit[$1, $2] = $4
    value[$1, $2] = $5
    if ($3 == -10) fail("the usual ceiling")
  }
  next
}

is_contact($2) {
  if (!(($1, $2, $4, $5, $6, $7) in known)) fail("a contact that there is not")
  contacts++
  next
}

$3 != -10 {
  if ($4 != hit[$1, $2]) fail("another answer")
  if ($2 !~ /contacts|surface|impact/ && $5 != value[$1, $2]) fail("another value")
  answered[$2]++
}

$3 == -10 {
  limited[$2]++
  if ($2 ~ /distance/ && ($6 > value[$1, $2] + 2 || $7 < value[$1, $2] - 2)) fail("bounds of a distance")
  if ($2 ~ /cast/ && $5 > value[$1, $2]) fail("a fraction beyond the hit")
  if (($2 == "contacts" || $2 == "surface") && $4 > hit[$1, $2]) fail("more contacts than there are")
  useful += $2 ~ /distance|cast|impact/ && $6 > 0
}

END {
  for (name in hit) {
    split(name, part, SUBSEP)
    names[part[2]]
  }
  for (name in names) {
    printf "%s %d of %d limited, ", name, limited[name], limited[name] + answered[name]
    if (limited[name] < 5 && name !~ /^both_|within/) fail(name " is hardly ever limited")
  }
  print useful " useful bounds, " contacts " contacts"
  exit bad || useful < 20 || contacts < 50
}
