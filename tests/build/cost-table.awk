# A table of costs from lines TARGET|NAME|MEAN|...: a column for each target, a row for each name of -v rows='NAME;NAME;...'.
# -v head: of the names.
BEGIN { FS = "|"; count = split(rows, name, ";") }
{
  if (!($1 in seen)) { seen[$1]; target[++targets] = $1 }
  mean[$1, $2] = $3
}
END {
  line = "| " head " |"
  rule = "|---|"
  for (t = 1; t <= targets; t++) {
    line = line " Cortex-" toupper(substr(target[t], 8)) " |"
    rule = rule "---|"
  }
  print line
  print rule
  for (r = 1; r <= count; r++) {
    line = "| " name[r] " |"
    for (t = 1; t <= targets; t++) {
      if (!((target[t], name[r]) in mean)) { print "not counted: " name[r] >"/dev/stderr"; missing = 1 }
      line = line " " about(mean[target[t], name[r]]) " |"
    }
    print line
  }
  exit missing
}
