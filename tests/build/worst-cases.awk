# Cases in the format of tests/support/case/parse.h, raw integers, as the C table of tests/measure/target/worst.h.
function flush_side() {
  if (side != "") {
    sub(/@/, round, shape)
    body[side] = "{" shape ",\n     {{" at "}, {" turn "}},\n     {" vertices "}}"
  }
}

function flush_case() {
  flush_side()
  if (id != "") print "    {\"" id "\", {{" body["A"] ",\n     " body["B"] "}}},"
  side = ""
}

# Fields from 3 on, with commas.
function numbers(    i, out) {
  for (i = 3; i <= NF; i++) out = out (i > 3 ? ", " : "") $i
  return out
}

BEGIN {
  print "// Written by worst-cases.awk.\n#include \"tests/measure/target/worst.h\"\n\nconst worst_case worst_cases[] = {"
}

/^[ \t]*(#|$)/ { next }
$1 == "case" { flush_case(); id = $2; next }

$1 == "A" || $1 == "B" {
  if ($2 == "at") { at = numbers(); next }
  if ($2 == "turn") { turn = numbers(); next }
  if ($2 == "round") { round = $3; next }
  flush_side()
  side = $1
  round = 0
  at = "0, 0, 0"
  turn = "0, 0, 0, GJK_Q30_ONE"
  vertices = "{0, 0, 0}"
  fresh = 1
  shape = "GJK_ROUNDED_" toupper($2) "("
  if ($2 == "triangle") shape = shape "0, @)"
  else if ($2 == "hull") shape = shape "0, " $3 ", @)"
  else shape = shape numbers() ", @)"
  next
}

{ vertices = (fresh ? "" : vertices ",\n      ") "{" $1 ", " $2 ", " $3 "}"; fresh = 0 }

END {
  flush_case()
  print "};\n\nconst unsigned worst_case_count = sizeof worst_cases / sizeof worst_cases[0];"
}
