# Compares what casts.c prints under the usual ceilings and under low ones: awk -v least=N -f casts.awk USUAL LOW.
#
# An answer must be the usual one. An open cast must have no contact before its fraction, by the usual answer, and a hit that
# is open must not be proven a miss. At least N kinds of casts must be open at times.
/^#/ || NF != 8 { next }
FNR == NR { usual[$1] = $0; next }
{
  lines++
  split(usual[$1], was, " ")
  if ($3 == "GJK_OK") {
    answered++
    if ($0 != usual[$1]) { print "another answer: " usual[$1] " / " $0; bad = 1 }
    next
  }
  if ($3 == was[3]) next
  if ($3 != "GJK_ERROR_ITERATION_LIMIT") { print "status: " usual[$1] " / " $0; bad = 1; next }
  if (was[5] == 1 && ($4 == 1 || $7 + 0 > was[7] + 0)) { print "wrong: " usual[$1] " / " $0; bad = 1 }
  opened++
  kinds += !($2 in seen)
  seen[$2]
}
END {
  print lines " casts, " answered " answered, " opened " open, of " kinds " kinds"
  exit bad || answered < lines / 10 || kinds < least
}
