# Facts of runs, in short and at length. First the names of all runs, then what -v mode says:
#
#   mode=join    RUN, tab, STATUS, tab, PLACES, tab, WHAT: a line per status and set of runs, STATUS, tab, the runs in short,
#                tab, WHAT, space, PLACES of each fact, with ", " between
#   mode=split   such lines: a line per fact and run, of -v only=RUN, or of all but the runs that the file -v without= lists
#
# In short: * is every run, a driver all of its runs, DRIVER-*-VARIANT every case, DRIVER-CASE both variants.
BEGIN {
  FS = "\t"
  OFS = "\t"
  while (without != "" && (getline line < without) > 0) left_out[line]
}

function driver_of(run) { return substr(run, 1, index(run, "-") - 1) }
function variant_of(run) { match(run, /-[^-]*$/); return substr(run, RSTART + 1) }
function case_of(run) { sub(/-[^-]*$/, "", run); return run }
function every_case(run) { return driver_of(run) "-*-" variant_of(run) }

# The names that stand for more than the run, largest set first.
function names_of(run, names) {
  names[1] = "*"
  names[2] = driver_of(run)
  names[3] = every_case(run)
  names[4] = case_of(run)
  names[5] = run
}

FILENAME == ARGV[1] {
  runs[++count] = $1
  names_of($1, names)
  for (i = 1; i <= 5; i++) size[names[i]]++
  next
}

/^#/ || /^$/ { next }

mode == "split" {
  split($2, short, " ")
  facts_here = split($3, fact_here, ", ")
  split("", is_short)
  for (i in short) is_short[short[i]]
  for (r = 1; r <= count; r++) {
    run = runs[r]
    if ((only != "" && run != only) || run in left_out) continue
    names_of(run, names)
    for (i = 1; i <= 5; i++) {
      if (names[i] in is_short) {
        for (k = 1; k <= facts_here; k++) {
          places = fact_here[k]
          sub(/^.* /, "", places)
          print run, $1, places, substr(fact_here[k], 1, length(fact_here[k]) - length(places) - 1)
        }
        break
      }
    }
  }
}

mode == "join" {
  fact = $2 OFS $3 OFS $4
  if (!(fact in facts)) order[++fact_count] = fact
  facts[fact]
  has[fact, $1]
  names_of($1, names)
  for (i = 1; i <= 5; i++) found[fact, names[i]]++
}

END {
  for (f = 1; f <= fact_count; f++) {
    fact = order[f]
    text = ""
    split("", written)
    for (r = 1; r <= count; r++) {
      run = runs[r]
      if (!((fact, run) in has)) continue
      names_of(run, names)
      for (i = 1; found[fact, names[i]] < size[names[i]]; i++) { }
      if (!(names[i] in written)) text = text (text == "" ? "" : " ") names[i]
      written[names[i]]
    }
    split(fact, field, OFS)
    line = field[1] OFS text
    if (!(line in folded)) lines[++line_count] = line
    folded[line] = folded[line] ", " field[3] " " field[2]
  }
  for (f = 1; f <= line_count; f++) print lines[f], substr(folded[lines[f]], 3)
}
