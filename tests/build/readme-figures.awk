# The README's tables of costs from build/bench/target.csv: a column for each target that it has figures of.
BEGIN {
  FS = ","
  columns = split("cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc", plain, " ")
  others = split("cortex-m0 cortex-m3 cortex-m4-fpu cortex-m7-fpu rv32imc", beside, " ")
  title["cortex-m0"] = "Cortex-M0"
  title["cortex-m3"] = "Cortex-M3"
  title["cortex-m4"] = "Cortex-M4"
  title["cortex-m4-fpu"] = "Cortex-M4, its FPU: float"
  title["cortex-m7"] = "Cortex-M7"
  title["cortex-m7-fpu"] = "Cortex-M7, its FPU: double"
  title["cortex-m33"] = "Cortex-M33"
  title["rv32imc"] = "RV32IMC"
}

{
  measured[$1]
  figure[$1, $2, $3, $4] = $5
  iterations[$2, $3, $4] = $5  # the same on every target
}

function header(first, list, count,    t, line, rule) {
  line = first
  rule = first
  gsub(/[^|]+/, "---", rule)
  for (t = 1; t <= count; t++) if (list[t] in measured) {
    line = line " " title[list[t]] " |"
    rule = rule "---|"
  }
  print line
  print rule
}

function shown(measure, number) {
  return measure ~ /instructions/ ? about(number) : grouped(number)
}

# A cell per target: the first measure, and the second, if any, in brackets.
function row(first, list, count, solver, subject, measure, second,    t, line, cell) {
  line = first
  for (t = 1; t <= count; t++) if (list[t] in measured) {
    cell = figure[list[t], solver, subject, measure]
    if (cell != "") cell = shown(measure, cell)
    if (second != "") cell = cell " (" shown(second, figure[list[t], solver, subject, second]) ")"
    line = line " " cell (cell == "" ? "|" : " |")
  }
  print line
}

function query(subject) {
  row("| " subject " | " iterations["gjk", subject, "mean iterations"] " |", plain, columns, "gjk", subject, \
    "mean instructions", "worst instructions")
}

function code(subject) {
  row("| code, bytes: " subject " | |", plain, columns, "gjk", subject, "code", "")
}

function compare(subject,    s, of) {
  of = split("gjk float double", solver, " ")
  for (s = 1; s <= of; s++) {
    row("| " (s == 1 ? subject : "") " | " solver[s] " |", beside, others, solver[s], subject, "mean instructions", "")
  }
}

END {
  header("| query | iterations |", plain, columns)
  query("boxes apart: distance")
  query("8-point hulls apart: distance")
  query("64-point hulls apart: distance")
  query("8-point hulls apart: intersect")
  query("8-point hulls close: intersect")
  query("8-point hulls overlapping: intersect")
  query("boxes overlapping: depth")
  query("8-point hulls overlapping: depth")
  query("32-point hulls overlapping: depth")
  query("boxes face to face: contacts")
  query("boxes face to face within the margin: contacts")
  query("8-point hulls face to face: contacts")
  row("| stack of intersect, within, distance, bytes, by the call graph | |", plain, columns, "gjk", "any query", \
    "stack bound", "")
  row("| the most that these used | |", plain, columns, "gjk", "any query", "painted stack", "")
  row("| stack of gjk_penetration, by the call graph (used) | |", plain, columns, "gjk", "gjk_penetration", \
    "stack bound", "painted stack")
  row("| stack of gjk_contacts, by the call graph (used) | |", plain, columns, "gjk", "gjk_contacts", "stack bound", \
    "painted stack")
  row("| workspace that depths of 8-point hulls needed, bytes | |", plain, columns, "gjk", \
    "8-point hulls overlapping: depth", "workspace", "")
  row("| workspace that depths of 32-point hulls needed, bytes | |", plain, columns, "gjk", \
    "32-point hulls overlapping: depth", "workspace", "")
  code("gjk_intersect: boxes")
  code("gjk_distance: boxes and hulls; rounded")
  code("gjk_distance: boxes and hulls; rounded; with posing")
  code("gjk_distance: every shape; with posing")
  code("gjk_penetration: boxes and hulls; rounded; with posing")
  code("gjk_contacts: boxes and hulls; rounded; with posing")
  print ""
  print "Pairs face to face are spun about the normal, tilted by up to a degree, up to 0.05 units deep or within a"
  print "margin of 0.02. The hulls there are frusta with faces. A manifold has at most four contacts."
  print ""
  print "The next table has the same algorithm in floating point: mean instructions on the same pairs. Floating point"
  print "is software unless the head names an FPU. That code is plain C (`tests/support/reference`), gets its vertices"
  print "in its own type, and stops as early. Its depths are EPA\47s, which does not fit in Cortex-M0\47s 16 KB."
  print ""
  header("| query | in |", beside, others)
  compare("boxes apart: distance")
  compare("8-point hulls close: intersect")
  compare("64-point hulls apart: distance")
  compare("boxes overlapping: depth")
  compare("8-point hulls overlapping: depth")
  row("| stack used, bytes | gjk |", beside, others, "gjk", "any query", "painted stack", "")
  row("| | float |", beside, others, "float", "any query", "painted stack", "")
  row("| | double |", beside, others, "double", "any query", "painted stack", "")
}
