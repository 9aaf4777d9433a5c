# The table of wrong decisions, of lines FAMILY,METHOD,PAIRS,WRONG: awk -F, -v head='...' -v methods='METHOD=TITLE;...'
# -v families='FAMILY=WORDS;...'. Of several ways of a METHOD, 'METHOD WAY', the best one of each family is shown.
BEGIN {
  columns = split(methods, method, ";")
  for (m = 1; m <= columns; m++) {
    split(method[m], half, "=")
    method[m] = half[1]
    title[half[1]] = half[2]
  }
  count = split(families, family, ";")
  for (f = 1; f <= count; f++) {
    split(family[f], half, "=")
    what[half[1]] = half[2]
  }
}
{
  name = $2
  if (!(name in title)) sub(/ .*/, "", name)
  if (!($1 in seen)) { seen[$1]; shown_family[++rows] = $1 }
  share = 100 * $4 / $3
  if (!(($1, name) in wrong) || share < wrong[$1, name]) wrong[$1, name] = share
  known[name]
}
function shown(share) { return share == 0 ? "0" : share < 0.1 ? sprintf("%.3f %%", share) : sprintf("%.1f %%", share) }
END {
  line = "| " head " |"
  rule = "|---|"
  for (m = 1; m <= columns; m++) if (method[m] in known) {
    line = line " " title[method[m]] " |"
    rule = rule "---|"
  }
  print line "\n" rule
  for (f = 1; f <= rows; f++) {
    line = "| " what[shown_family[f]] " |"
    for (m = 1; m <= columns; m++) if (method[m] in known) {
      cell = shown(wrong[shown_family[f], method[m]])
      line = line " " (m == 1 && cell == "0" ? "**0**" : cell) " |"
    }
    print line
  }
}
