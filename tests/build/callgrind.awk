# Reads dumps of callgrind that are named by the program: awk -v pairs=N -f callgrind.awk DUMP...
#
# Prints 'NAME,instructions,N' for each, and with --branch-sim=yes 'NAME,mispredictions,N', per pair. NAME is what
# CALLGRIND_DUMP_STATS_AT was given.
/^desc: Trigger: Client Request: / { name = substr($0, index($0, "Request: ") + 9) }
/^events: / {
  split("", column)
  count = split($0, event, " ")
  for (i = 2; i <= count; i++) column[event[i]] = i
}
/^totals: / && name != "" {
  printf "%s,instructions,%.6f\n", name, $column["Ir"] / pairs
  if ("Bcm" in column) printf "%s,mispredictions,%.6f\n", name, ($column["Bcm"] + $column["Bim"]) / pairs
  name = ""
}
