# Adds up the counts of all variants and prints the table and the list: see coverage.sh.
# only: a regular expression for the files that count.
# Input: lines 'B FILE LINE COLUMN TRUE FALSE', then lcov files of all variants.

function place(file) {
  sub(root, "", file)
  sub(/[a-z_]+\/\.\.\//, "", file)  # a file that is included from another room
  return file
}

# Reads a source file's arguments: argued[file, line] where a comment beside the line or just above stands. An argument
# for a condition is one for the lines of its block, too: block[file, line] is where it stands.
function read_source(file,   text, number, above, head, depth) {
  number = 0
  above = 0
  head = 0
  while ((getline text < file) > 0) {
    number++
    code[file, number] = text
    if (head > 0) {
      block[file, number] = head
      match(text, /^ */)
      if (RLENGTH <= depth && text ~ /^ *}/) head = 0
    }
    if (text ~ /^ *\/\/ not reached: ./) {
      above = 1
    } else if (text ~ /\/\/ not reached: ./) {
      argued[file, number] = 1
      arguments++
    } else if (above && text !~ /^ *\/\//) {
      argued[file, number] = 1
      arguments++
      above = 0
    }
    if (((file, number) in argued) && text ~ /^ *(if|while|for) .*{( *\/\/.*)?$/) {
      head = number
      match(text, /^ */)
      depth = RLENGTH
    }
  }
  close(file)
}

function miss(file, line, what) {
  if ((file, line) in argued) {
    used[file, line] = 1
    reasons[file]++
  } else if (what == "line" && (file, line) in block) {
    reasons[file]++
  } else {
    missing[++misses] = file ":" line ": " what ": " code[file, line]
  }
}

$1 == "B" {
  file = place($2)
  if (file !~ only) next
  key = file SUBSEP $3 SUBSEP $4
  if (!(key in is_true)) order[++branches] = key
  is_true[key] += $5
  is_false[key] += $6
  next
}

/^SF:/ {
  file = place(substr($0, 4))
  if (!(file in known) && file ~ /^(src|include)\// && file ~ only) {
    known[file] = ++files
    name[files] = file
    read_source(file)
  }
  next
}

/^DA:/ && file ~ only {
  split(substr($0, 4), field, ",")
  if (!((file, field[1]) in hits)) {
    line_of[++lines] = file SUBSEP field[1]
  }
  hits[file, field[1]] += field[2]
}

END {
  for (i = 1; i <= lines; i++) {
    split(line_of[i], at, SUBSEP)
    total[at[1]]++
    if (hits[line_of[i]] > 0) reached[at[1]]++
    else miss(at[1], at[2], "line")
  }
  for (i = 1; i <= branches; i++) {
    split(order[i], at, SUBSEP)
    both[at[1]] += 2
    taken[at[1]] += (is_true[order[i]] > 0) + (is_false[order[i]] > 0)
    if (is_true[order[i]] == 0) miss(at[1], at[2], "column " at[3] " never true")
    if (is_false[order[i]] == 0) miss(at[1], at[2], "column " at[3] " never false")
  }
  printf "%-26s %14s %16s %8s\n", "file", "lines", "branches", "argued"
  for (i = 1; i <= files; i++) {
    f = name[i]
    printf "%-26s %6d of %4d %8d of %4d %8d\n", f, reached[f], total[f], taken[f], both[f], reasons[f]
    sum_reached += reached[f]; sum_total += total[f]; sum_taken += taken[f]; sum_both += both[f]
    sum_reasons += reasons[f]
  }
  printf "%-26s %6d of %4d %8d of %4d %8d\n", "all", sum_reached, sum_total, sum_taken, sum_both, sum_reasons
  for (i = 1; i <= misses; i++) print "not reached: " missing[i]
  for (key in argued) {
    if (!(key in used)) {
      split(key, at, SUBSEP)
      print "reached after all: " at[1] ":" at[2] ": " code[key]
      misses++
    }
  }
  exit misses > 0 || sum_total == 0
}
