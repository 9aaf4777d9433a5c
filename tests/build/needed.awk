# Lists the sources that a program is linked with: its own, and of the others those alone that define what these mention.
#
#   awk -f tests/build/needed.awk PROGRAM.c... -- OTHER.c... PUBLIC.h...
#
# A source mentions its words, those of the macros that it uses, and those of the private headers that it includes. A header of
# tests/support brings the source beside it. One source too many is harmless, one too few stops the link. A definition
# begins in column 0, and its line does not end with ;.

function defined(line) {
  if (line ~ /^(static|typedef|extern|return|[ #\/}])/ || line ~ /;$/ && line !~ /=/) return ""
  if (!match(line, /[a-z][a-z0-9_]*(\[[^]]*\])*(\(| =)/)) return ""
  line = substr(line, RSTART, RLENGTH)
  sub(/[^a-z0-9_].*/, "", line)
  return line
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
function learn(file,   line, name, macro) {
  if (file in learnt) return
  learnt[file]
  while ((getline line <file) > 0) {
    sub(/\/\/.*/, "", line)
    if (line ~ /^#include "/) {
      name = included(line, file)
      if (name != "") includes[file] = includes[file] " " name
    } else if (line ~ /^#define / || macro != "") {
      if (macro == "") {
        split(line, part, /[ (]/)
        macro = part[2]
        definer[macro] = macro
        learnt[macro]
      }
      mention(macro, line)
      if (line !~ /\\$/) macro = ""
    } else {
      name = file ~ /\.c$/ ? defined(line) : ""
      if (name != "") definer[name] = file
      mention(file, line)
    }
  }
  close(file)
}

# Puts a file or macro on the list of those to look at.
function want(file) {
  if (file in wanted) return
  wanted[file]
  queue[++queued] = file
}

BEGIN {
  for (k = 1; k < ARGC && ARGV[k] != "--"; k++) want(ARGV[k])
  while (++k < ARGC) learn(ARGV[k])
  for (k = 1; k <= queued; k++) {
    file = queue[k]
    learn(file)
    count = split(includes[file], name, " ")
    for (j = 1; j <= count; j++) want(name[j])
    count = split(mentions[file], name, " ")
    for (j = 1; j <= count; j++) {
      if (name[j] in definer) want(definer[name[j]])
    }
    beside = file
    if (file ~ /^tests\/support\/.*\.h$/ && sub(/h$/, "c", beside) && can_read(beside)) want(beside)
  }
  for (k = 1; k <= queued; k++) {
    if (queue[k] ~ /\.c$/) print queue[k]
  }
}
