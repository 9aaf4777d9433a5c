# The table from lines TARGET|NAME|MEAN|...: a row for each of the first five families, a column for each target.
BEGIN { FS = "|" }
{
  if (!($1 in seen)) { seen[$1]; target[++targets] = $1 }
  if (targets == 1 && rows < 5) name[++rows] = $2
  mean[$1, $2] = $3
}
END {
  head = "| query |"
  rule = "|---|"
  for (t = 1; t <= targets; t++) {
    head = head " Cortex-" toupper(substr(target[t], 8)) " |"
    rule = rule "---|"
  }
  print head
  print rule
  for (r = 1; r <= rows; r++) {
    line = "| " name[r] " |"
    for (t = 1; t <= targets; t++) line = line " " about(mean[target[t], name[r]]) " |"
    print line
  }
}
