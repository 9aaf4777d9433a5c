# Lists the sources that programs are linked with, in a line 'NAME= SOURCE...' for each: a program's own, and of the others
# those alone that define what these mention.
#
#   awk -f tests/build/needed.awk NAME= SOURCE.c... NAME= SOURCE.c... -- OTHER.c... PUBLIC.h...
#
# A source mentions its words, those of the macros that it uses, and those of the private headers that it includes, but for
# the functions that they declare. A header of tests/support brings the source beside it. A source of scenes of the plane,
# whose names are made by macros, brings all of them. One source too many is harmless, one too few stops the link. A
# definition begins in column 0, and its line does not end with ;.

function defined(line, file) {
  if (line ~ /^(static|typedef|extern|return|[ #\/}])/ || line ~ /;$/ && line !~ /=/) return ""
  if (!match(line, /[a-z][a-z0-9_]*(\[[^]]*\])*(\(| =)/)) return ""
  line = substr(line, RSTART, RLENGTH)
  sub(/[^a-z0-9_].*/, "", line)
  return file ~ /^src/ && line !~ /^gjk/ ? "" : line
}

# The path of the header that a line of a file includes; "": a public one.
function included(line, file,   name) {
  name = line
  sub(/^[^"]*"/, "", name)
  sub(/".*/, "", name)
  sub(/[^\/]*$/, "", file)
  while (sub(/^\.\.\//, "", name)) sub(/[^\/]*\/$/, "", file)
  if (can_read(file name)) return file name
  return can_read("tests/support/" name) ? "tests/support/" name : ""
}

function can_read(file,   line) {
  if (!(file in readable)) {
    readable[file] = (getline line <file) > 0
    close(file)
  }
  return readable[file]
}

# Adds the words of a line to what a file or macro mentions.
function mention(of, line,   count, i, word) {
  gsub(/[^A-Za-z0-9_]+/, " ", line)
  count = split(line, word, " ")
  for (i = 1; i <= count; i++) {
    if (!((of, word[i]) in mentioned)) {
      mentioned[of, word[i]]
      mentions[of] = mentions[of] " " word[i]
    }
  }
}

# Reads a file once.
function learn(file,   line, declares, name, macro) {
  if (file in learnt) return
  learnt[file]
  while ((getline line <file) > 0) {
    sub(/\/\/.*/, "", line)
    declares = file ~ /\.h$/ && (declares || line ~ /^[a-z][a-z0-9_]* [^={]*\(/ && line !~ /^(static|typedef)/)
    if (declares) {
      declares = line !~ /;$/
    } else if (line ~ /^#include "/) {
      name = included(line, file)
      if (name != "") includes[file] = includes[file] " " name
    } else if ((line ~ /^#define / || macro != "") && file !~ /^tests\/programs/) {
      if (macro == "") {
        split(line, part, /[ (]/)
        macro = part[2]
        definer[macro] = definer[macro] " " macro
        learnt[macro]
      }
      mention(macro, line)
      if (line !~ /\\$/) macro = ""
    } else {
      name = others && file ~ /\.c$/ ? defined(line, file) : ""
      if (name != "") definer[name] = definer[name] " " file
      mention(file, line)
    }
  }
  close(file)
}

# Reads a file and the private headers that it includes, whose macros it may use.
function learn_with_headers(file,   count, i, header) {
  if (file in ready) return
  ready[file]
  learn(file)
  count = split(includes[file], header, " ")
  for (i = 1; i <= count; i++) learn_with_headers(header[i])
}

# Puts a file or macro on the list of those to look at.
function want(file) {
  if (file in wanted) return
  wanted[file]
  queue[++queued] = file
}

# Prints the line of the program whose sources are on the list.
function print_line(name,   k, j, i, file, count, word, parts, part, beside, line) {
  for (k = 1; k <= queued; k++) {
    file = queue[k]
    learn_with_headers(file)
    count = split(includes[file], word, " ")
    for (j = 1; j <= count; j++) want(word[j])
    count = split(mentions[file], word, " ")
    for (j = 1; j <= count; j++) {
      parts = word[j] in definer ? split(definer[word[j]], part, " ") : 0
      for (i = 1; i <= parts; i++) want(part[i])
    }
    beside = file
    if (file ~ /^tests\/support\/.*\.h$/ && sub(/h$/, "c", beside) && can_read(beside)) want(beside)
    for (j = 1; file ~ /^src\/plane_scene\// && j <= plane_scenes; j++) want(plane_scene[j])
    if (file ~ /\.c$/) line = line " " file
  }
  print name line
  split("", wanted)
  queued = 0
}

BEGIN {
  others = 1
  for (k = 1; ARGV[k] != "--"; k++) continue
  while (++k < ARGC) {
    learn(ARGV[k])
    if (ARGV[k] ~ /^src\/plane_scene\/.*\.c$/) plane_scene[++plane_scenes] = ARGV[k]
  }
  others = 0
  for (k = 1; k < ARGC; k++) {
    if (ARGV[k] !~ /=$/ && ARGV[k] != "--") {
      want(ARGV[k])
      continue
    }
    if (name != "") print_line(name)
    if (ARGV[k] == "--") break
    name = ARGV[k]
  }
}
