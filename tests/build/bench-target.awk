# Prints build/bench/target.csv as tables on the terminal, a column per target.
BEGIN { FS = "," }

{
  if (!($1 in known_target)) { known_target[$1]; target[++targets] = $1 }
  line = $4 SUBSEP $3
  if (!(line in known_line)) { known_line[line]; subject[++lines] = $3; measure[lines] = $4 }
  figure[$1, $2, $3, $4] = $5
}

function title(text) {
  printf "\n%-66s", text
  for (t = 1; t <= targets; t++) printf "%18s", target[t]
  printf "\n"
}

# The figure of a measure, and behind it in brackets that of another.
function row(name, solver, subject, first, second,    t, any, out, cell) {
  out = sprintf("%-58s%-8s", name, solver)
  for (t = 1; t <= targets; t++) {
    cell = figure[target[t], solver, subject, first]
    if (cell != "") any = 1
    if (cell != "" && second != "") cell = cell " (" figure[target[t], solver, subject, second] ")"
    out = out sprintf("%18s", cell)
  }
  if (any) print out
}

END {
  count = split("gjk float double", solver, " ")
  title("instructions per query: mean (worst)")
  for (n = 1; n <= lines; n++) if (measure[n] == "mean instructions") {
    for (s = 1; s <= count; s++) {
      row(s == 1 ? subject[n] : "", solver[s], subject[n], "mean instructions", "worst instructions")
    }
  }
  title("iterations per query: mean (most)")
  for (n = 1; n <= lines; n++) if (measure[n] == "mean iterations") {
    row(subject[n], "gjk", subject[n], "mean iterations", "most iterations")
  }
  title("contacts per query: mean (most)")
  for (n = 1; n <= lines; n++) if (measure[n] == "mean contacts") {
    row(subject[n], "gjk", subject[n], "mean contacts", "most contacts")
  }
  title("stack, bytes: by the call graph (painted, most)")
  row("intersect, within, distance", "gjk", "any query", "stack bound", "painted stack")
  for (s = 2; s <= count; s++) row("", solver[s], "any query", "painted stack")
  row("gjk_penetration", "gjk", "gjk_penetration", "stack bound", "painted stack")
  for (s = 2; s <= count; s++) row("", solver[s], "gjk_penetration", "painted stack")
  row("gjk_contacts", "gjk", "gjk_contacts", "stack bound", "painted stack")
  row("gjk_time_of_impact", "gjk", "gjk_time_of_impact", "stack bound", "painted stack")
  title("workspace needed, bytes: the most of the pairs")
  for (n = 1; n <= lines; n++) if (measure[n] == "workspace") row(subject[n], "gjk", subject[n], "workspace")
  title("code linked at -Os, bytes")
  for (n = 1; n <= lines; n++) if (measure[n] == "code") {
    for (s = 1; s <= count; s++) row(subject[n], solver[s], subject[n], "code")
  }
}
