# Merges files of cases like tests/data/worst.txt: of each id the one whose measure, named by the id's end, is higher.
function flush() {
  if (id == "") return
  value = id ~ /-iterations$/ ? iterations : instructions
  if (!(id in most)) order[++ids] = id
  if (!(id in most) || value > most[id]) { most[id] = value; text[id] = block }
  id = ""
}

FNR == 1 { flush() }
/^case / { flush(); id = $2; block = ""; iterations = instructions = 0 }
/^# iterations / { iterations = $3 + 0; instructions = $5 + 0 }
id != "" { block = block $0 "\n" }

END {
  flush()
  for (i = 1; i <= ids; i++) printf "%s", text[order[i]]
}
