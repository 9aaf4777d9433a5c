# Adds up what became of the mutants: see mutants.sh. Survivors are a table, fit for tests/check/mutate/README.md. Input:
# tests/check/mutate/equivalent.txt, lines of FILE, TEXT, CHANGE, KIND, REASON with tabs between; all mutants as mutate lists
# them; the verdicts.

BEGIN { FS = "\t" }

FILENAME == ARGV[1] {
  if ($0 ~ /^#/ || $0 == "") next
  if (NF != 5 || ($4 != "equivalent" && $4 != "slower")) {
    wrong[++wrongs] = "not of the form: " $0
    next
  }
  entries++
  file_of[entries] = $1
  text_of[entries] = $2
  change_of[entries] = $3
  kind_of[entries] = $4
  next
}

function argument(file, change, text,   i) {
  for (i = 1; i <= entries; i++) {
    if (file_of[i] == file && change_of[i] == change && index(text, text_of[i]) > 0) {
      return i
    }
  }
  return 0
}

FILENAME == ARGV[2] {
  i = argument($1, $4, $5)
  if (i > 0) met[i]++
  line[$1, $2] = $3
  next
}

# Code in a cell of a table.
function cell(s) {
  gsub(/\|/, "\\\\|", s)
  return "`" s "`"
}

# Verdicts: key, verdict, file, number, line, change, text.
{
  files[$3]
  split($2, verdict, " ")
  i = argument($3, $6, $7)
  what = $3 ":" line[$3, $4] ": " $6 ": " $7
  if (verdict[1] == "noticed") {
    noticed[$3]++
    by[verdict[2]]++
    if (i > 0 && kind_of[i] == "equivalent") wrong[++wrongs] = "argued equivalent, but " $2 ": " what
    if (i > 0 && kind_of[i] == "slower") wrong[++wrongs] = "argued slower, but " $2 ": " what
  } else if (verdict[1] != "survived") {
    none[$3]++
  } else if (i > 0) {
    if (kind_of[i] == "slower") slower[$3]++
    else argued[$3]++
  } else {
    survived[$3]++
    list[++survivors] = "| " $3 ":" line[$3, $4] " | " cell($7) " | " cell($6) " |"
  }
}

END {
  for (i = 1; i <= entries; i++) {
    if (!(i in met)) wrong[++wrongs] = "argues for no mutant: " file_of[i] ": " text_of[i] ": " change_of[i]
  }
  printf "%-24s %8s %8s %10s %8s %8s\n", "file", "noticed", "survived", "equivalent", "slower", "no code"
  command = "sort"
  for (f in files) {
    printf "%-24s %8d %8d %10d %8d %8d\n", f, noticed[f], survived[f], argued[f], slower[f], none[f] | command
    n += noticed[f]; s += survived[f]; a += argued[f]; l += slower[f]; e += none[f]
  }
  close(command)
  command = "sort -k 5 -n -r"
  for (test in by) {
    printf "first noticed by %s: %d\n", test, by[test] | command
  }
  close(command)
  if (survivors > 0) {
    print "| survived | line | change |"
    print "|---|---|---|"
  }
  command = "sort -t : -k 1,1 -k 2,2n"
  for (i = 1; i <= survivors; i++) {
    print list[i] | command
  }
  close(command)
  for (i = 1; i <= wrongs; i++) {
    print wrong[i]
  }
  share = n + s > 0 ? 100 * n / (n + s) : 0
  printf "%d mutants judged: %d noticed, %d survived, %.1f %% noticed; %d argued equivalent, %d argued slower alone, %d without other code\n", \
    n + s + a + l + e, n, s, share, a, l, e
  exit share < 95 || wrongs > 0
}
