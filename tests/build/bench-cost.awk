# Prints what queries cost as tables: awk -F, [-v markdown=1] -f bench-cost.awk COST.csv
#
# markdown: the README's table alone.
#
# The rows are family,library,method,mode,measure,value, as bench-cost.sh collects them. A library answers by several
# methods; the cheapest of those that answer right stands for it. A method answers right if the sum of its answers is
# that of this library, to within TOLERANCE of it. In each table ns are those of this library, and those of the others
# are in parts of them.
BEGIN { TOLERANCE = 0.01 }

NR == 1 { next }

{
  if (!($1 in known_family)) { known_family[$1] = 1; family[++families] = $1 }
  if (!($2 in known_library) && $2 != "gjk" && $2 != "nothing") { known_library[$2] = 1; library[++libraries] = $2 }
  if (!(($2, $3) in known_method)) { known_method[$2, $3] = 1; method[$2, ++methods[$2]] = $3 }
  value[$1, $3, $4, $5] = $6
}

# What a query costs, without what the loop around it costs.
function cost(of, by, mode, measure) {
  return value[of, by, mode, measure] - value[of, "nothing", "cold", measure]
}

function deviation(of, by, mode,    own, off) {
  own = value[of, "gjk", "cold", "sum"]
  off = value[of, by, mode, "sum"] - own
  if (off < 0) off = -off
  if (own < 0) own = -own
  return own > 0 ? off / own : off
}

# The least cost of a library's methods that answer right; "": there is none.
function least(of, from, mode, measure,    i, by, found, here) {
  found = ""
  for (i = 1; i <= methods[from]; i++) {
    by = method[from, i]
    if (((of, by, mode, measure) in value) && deviation(of, by, mode) <= TOLERANCE) {
      here = cost(of, by, mode, measure)
      if (found == "" || here < found) found = here
    }
  }
  return found
}

function grouped(number,    out) {
  out = sprintf("%.0f", number)
  while (match(out, /^-?[0-9]+[0-9][0-9][0-9]/)) {
    out = substr(out, 1, RLENGTH - 3) "," substr(out, RLENGTH - 2)
  }
  return out
}

function number(x, measure) {
  return measure == "mispredictions" ? sprintf("%.1f", x) : grouped(x)
}

# A family that has a figure of this library in the mode.
function is_in(of, mode, measure) {
  return least(of, "gjk", mode, measure) != "" && of !~ /^posing/
}

function heading(title, text,    i) {
  printf "\n%s\n%s\n%-34s%10s", title, text, "", "gjk"
  for (i = 1; i <= libraries; i++) printf "%12s", library[i]
  printf "\n"
}

# A figure of another library: below this library's it is marked. as_ratio: in parts of this library's.
function other(own, here, measure, as_ratio,    text) {
  if (here == "") return "-  "
  text = as_ratio ? sprintf("%.2f", here / own) : number(here, measure)
  return text (here < own ? " <" : "  ")
}

function table(title, text, mode, measure, as_ratio,    f, i, own) {
  heading(title, text)
  for (f = 1; f <= families; f++) {
    if (!is_in(family[f], mode, measure)) continue
    own = least(family[f], "gjk", mode, measure)
    printf "%-34s%10s", family[f], number(own, measure)
    for (i = 1; i <= libraries; i++) {
      printf "%12s", other(own, least(family[f], library[i], mode, measure), measure, as_ratio)
    }
    printf "\n"
  }
}

function posing_table(    f) {
  printf "\nposing a shape\nof this library alone: others rotate directions instead, in each query; lazy: a hull without a buffer\n"
  printf "%-34s%14s%8s%20s%18s%11s\n", "", "instructions", "ns", "wrong predictions", "lazy instructions", "lazy ns"
  for (f = 1; f <= families; f++) {
    if (family[f] !~ /^posing/) continue
    printf "%-34s", family[f]
    posing(family[f], "gjk", "instructions", 14)
    posing(family[f], "gjk", "ns", 8)
    posing(family[f], "gjk", "mispredictions", 20)
    posing(family[f], "gjk lazy", "instructions", 18)
    posing(family[f], "gjk lazy", "ns", 11)
    printf "\n"
  }
}

function posing(of, by, measure, width) {
  printf "%" width "s", (of, by, "cold", measure) in value ? number(cost(of, by, "cold", measure), measure) : "-"
}

function modes_table(measure, text,    f, m, mode, names) {
  printf "\n%s\n%s\n%-34s%10s%10s%10s%13s%12s%14s\n", "this library, " measure " a query", text, "", "cold", "warm", "posed", \
    "posed, warm", "lazy, cold", "posed, lazy"
  for (f = 1; f <= families; f++) {
    if (!is_in(family[f], "cold", measure)) continue
    printf "%-34s", family[f]
    modes_field(family[f], "gjk", "cold", measure, 10)
    modes_field(family[f], "gjk", "warm", measure, 10)
    modes_field(family[f], "gjk", "posed", measure, 10)
    modes_field(family[f], "gjk", "posed warm", measure, 13)
    modes_field(family[f], "gjk lazy", "cold", measure, 12)
    modes_field(family[f], "gjk lazy", "posed", measure, 14)
    printf "\n"
  }
}

function modes_field(of, by, mode, measure, width) {
  printf "%" width "s", (of, by, mode, measure) in value ? number(cost(of, by, mode, measure), measure) : "-"
}

# Which methods are in the tables, and which answer something else.
function sums(    f, l, i, by, off, worst, bad) {
  printf "\nsums of answers\n"
  for (f = 1; f <= families; f++) for (l = 0; l <= libraries; l++) {
    lib = l == 0 ? "gjk" : library[l]
    for (i = 1; i <= methods[lib]; i++) {
      by = method[lib, i]
      for (m = 1; m <= 4; m++) {
        if (!((family[f], by, mode_name[m], "sum") in value)) continue
        off = deviation(family[f], by, mode_name[m])
        if (off > TOLERANCE) {
          printf "  %s, %s (%s): off by %.1f %%, left out\n", family[f], by, mode_name[m], 100 * off
        } else if (off > worst) {
          worst = off
        }
      }
    }
  }
  printf "  all methods in the tables give the sum of this library, to %.2f %% at most\n", 100 * worst
}

# The families in which a method of another library takes less.
function behind(title, mode, measure,    f, l, i, by, own, count) {
  for (f = 1; f <= families; f++) {
    if (!is_in(family[f], mode, measure)) continue
    own = least(family[f], "gjk", mode, measure)
    for (l = 1; l <= libraries; l++) for (i = 1; i <= methods[library[l]]; i++) {
      by = method[library[l], i]
      if (((family[f], by, mode, measure) in value) && deviation(family[f], by, mode) <= TOLERANCE &&
          cost(family[f], by, mode, measure) < own) {
        if (!count++) printf "\n%s\n", title
        printf "  %-34s%-22s%10s of %s\n", family[f], by, number(cost(family[f], by, mode, measure), measure), number(own, measure)
      }
    }
  }
  if (!count) printf "\n%s\n  nowhere\n", title
}

# A row for each family: this library's costs, cold and warm, then the times of others, cold, in parts of this library's.
function markdown_table(    f, i, of, own) {
  printf "| query | instructions | mispredictions | ns | warm: instructions | ns |"
  for (i = 1; i <= libraries; i++) printf " %s |", library[i]
  printf "\n|---|---|---|---|---|---|"
  for (i = 1; i <= libraries; i++) printf "---|"
  printf "\n"
  for (f = 1; f <= families; f++) {
    of = family[f]
    if (!is_in(of, "cold", "ns")) continue
    own = cost(of, "gjk", "cold", "ns")
    printf "| %s | %s | %s | %s | %s | %s |", of, figure(of, "cold", "instructions"), figure(of, "cold", "mispredictions"), \
      figure(of, "cold", "ns"), figure(of, "warm", "instructions"), figure(of, "warm", "ns")
    for (i = 1; i <= libraries; i++) printf " %s |", in_parts(own, least(of, library[i], "cold", "ns"))
    printf "\n"
  }
}

function figure(of, mode, measure) {
  return (of, "gjk", mode, measure) in value ? number(cost(of, "gjk", mode, measure), measure) : ""
}

function in_parts(own, here) {
  return here == "" ? "" : sprintf("%.1f", here / own)
}

function has(measure,    f) {
  for (f = 1; f <= families; f++) if ((family[f], "gjk", "cold", measure) in value) return 1
  return 0
}

END {
  if (markdown) {
    markdown_table()
    exit
  }
  split("cold,warm,posed,posed warm", mode_name, ",")
  mark = "<: less than this library takes"
  if (has("instructions")) {
    table("instructions a query", "by callgrind, cold, shapes posed beforehand; " mark, "cold", "instructions", 0)
    modes_table("instructions", "posed: both shapes are posed by each query; lazy: hulls without a buffer")
  }
  if (has("ns")) {
    table("ns a query, cold", "shapes posed beforehand; others in parts of gjk's ns; " mark, "cold", "ns", 1)
    table("ns a query, warm", "one step of coherent motion after an answer; posed beforehand; " mark, "warm", "ns", 1)
    table("ns a query, cold, posing included", "both shapes are posed by each query; hulls baked or lazy, whichever is faster", \
      "posed", "ns", 1)
    table("ns a query, warm, posing included", "both of these", "posed warm", "ns", 1)
    modes_table("ns", "as above")
  }
  if (has("mispredictions")) {
    table("branch mispredictions a query", "by callgrind's predictor, cold, shapes posed beforehand; " mark, "cold", "mispredictions", 0)
    modes_table("mispredictions", "as above")
  }
  posing_table()
  sums()
  if (libraries > 0) {
    if (has("instructions")) behind("others take fewer instructions, cold", "cold", "instructions")
    if (has("ns")) {
      behind("others take fewer ns, cold", "cold", "ns")
      behind("others take fewer ns, warm", "warm", "ns")
      behind("others take fewer ns, cold, posing included", "posed", "ns")
    }
  }
}
