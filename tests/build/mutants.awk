# Adds up what became of the mutants: see mutants.sh. First file: tests/mutate/equivalent.txt, lines
# of FILE, TEXT, CHANGE, REASON with tabs between, TEXT a part of the source line, CHANGE 'OLD => NEW', each or * for any.

FNR == NR {
  if ($0 !~ /^#/ && split($0, field, /\t/) == 4) {
    entries++
    file_of[entries] = field[1]
    text_of[entries] = field[2]
    change_of[entries] = field[3]
  }
  next
}

function is_argued(file, change, text,   i) {
  for (i = 1; i <= entries; i++) {
    if ((file_of[i] == "*" || file_of[i] == file) && (text_of[i] == "*" || index(text, text_of[i]) > 0) &&
        (change_of[i] == "*" || change_of[i] == change)) {
      return 1
    }
  }
  return 0
}

{
  files[$2]
  split($1, verdict, " ")
  if (verdict[1] == "noticed") {
    noticed[$2]++
    by[verdict[2]]++
  } else if (verdict[1] == "survived") {
    if (is_argued($2, $4, $5)) {
      argued[$2]++
    } else {
      survived[$2]++
      list[++survivors] = "survived: " $2 ":" $3 ": " $4 ": " $5
    }
  } else {
    same[$2]++
  }
}

END {
  printf "%-24s %8s %8s %8s %8s\n", "file", "noticed", "survived", "argued", "no code"
  command = "sort"
  for (f in files) {
    printf "%-24s %8d %8d %8d %8d\n", f, noticed[f], survived[f], argued[f], same[f] | command
    n += noticed[f]; s += survived[f]; a += argued[f]; e += same[f]
  }
  close(command)
  for (test in by) {
    printf "first noticed by %s: %d\n", test, by[test]
  }
  for (i = 1; i <= survivors; i++) {
    print list[i]
  }
  share = n + s > 0 ? 100 * n / (n + s) : 0
  printf "mutants: %d noticed, %d survived, %.1f %% noticed; %d argued equivalent, %d without other code\n", n, s, share, a, e
  exit share < 95
}
