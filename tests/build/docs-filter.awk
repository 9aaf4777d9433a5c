# Turns a public header into what doxygen reads: awk -f docs-filter.awk HEADER. Headers have plain comments:
#
#   // ...             above a declaration; it is that of the declarations below it too, up to an empty line
#   member;  // ...    behind a member or enumerator, and on lines below at the same column
#   the first comment  the file's
#   one that stands alone  what follows it, as a group with a name
#   Word  text         a row of a table: its text goes on below, indented; rows line up, and a row may hold a table
#   four spaces        code
#
# A comment's first sentence becomes the brief one, names become links, 'type a, b;' two declarations. Doxygen 1.9 does not
# miss comments of enumerators, nor of members of structs that it shows with their header: the filter does.
# -v links=0: names stay as they are.

BEGIN {
  if (links == "") links = 1
}

function escape(text) {
  gsub(/&/, "\\&amp;", text)
  gsub(/</, "\\&lt;", text)
  gsub(/>/, "\\&gt;", text)
  gsub(/\\/, "\\\\", text)
  gsub(/@/, "@@", text)
  gsub(/"/, "\\&quot;", text)
  gsub(/#/, "\\#", text)
  return text
}

# Names of the library become links; those within paths of files do not.
function link(text,    done, before, name, after) {
  done = ""
  while (match(text, /(gjk2?_[a-z0-9_]*[a-z0-9]|GJK2?_[A-Z0-9_]*[A-Z0-9])/)) {
    before = substr(text, 1, RSTART - 1)
    name = substr(text, RSTART, RLENGTH)
    after = substr(text, RSTART + RLENGTH)
    linked = links && name !~ /^gjk_port_/ && before !~ /[A-Za-z0-9_\/]$/ && after !~ /^([\/_(]|\.[chp]|\.elf|\.\.)/ && name !~ /^GJK_(NARROW_MULTIPLY|ERROR_UNKNOWN|NO_SKIP)$/
    done = done before (linked ? "#" : "") name
    text = after
  }
  return done text
}

# The length of a row's label in text, where a row begins there; else 0. at: where rows of its table have their text
function label_length(text, at) {
  if (match(text, /^[^ ]+( [^ ]+)*  +/) && RLENGTH < length(text)) return RLENGTH
  if (at > 1 && substr(text, at - 1, 1) == " " && substr(text, at, 1) != " " && match(text, /^[^ ]+ /) && RLENGTH >= at - 3) return RLENGTH
  if (at > 1 && match(text, /^[A-Z][a-z]+ /) && RLENGTH >= at - 1 && RLENGTH <= at) return RLENGTH
  return 0
}

function close_table() {
  return base[depth--] < 0 ? "" : "</dd></dl>"
}

function close_tables(    out) {
  out = ""
  while (depth > 0) out = out close_table()
  return out
}

# A row of a table at an indentation; opens a table unless one is open there.
function row(text, indent,    length_of, out) {
  out = "</dd>"
  length_of = label_length(text, depth > 0 && base[depth] == indent ? column[depth] : 0)
  if (depth == 0 || base[depth] != indent) {
    base[++depth] = indent
    column[depth] = length_of + 1
    out = "<dl>"
  }
  label = substr(text, 1, length_of)
  sub(/ +$/, "", label)
  return out "<dt>" link(escape(label)) "</dt><dd>" link(escape(substr(text, length_of + 1)))
}

# One line of a comment's text, rendered.
function render_line(text,    indent, out) {
  match(text, /^ */)
  indent = RLENGTH
  text = substr(text, indent + 1)
  out = ""
  if (code && (indent < 4 || text == "")) {
    code = 0
    out = "</pre>"
  }
  if (text == "") return out close_tables()
  if (depth == 0 && indent >= 4) {
    out = code ? "" : "<pre>"
    code = 1
    return out sprintf("%" (indent - 4) "s", "") escape(text)
  }
  while (depth > 0 && indent < base[depth]) out = out close_table()
  if (depth > 0 && indent == base[depth]) {
    if (label_length(text, column[depth])) return out row(text, indent)
    out = out close_table()
  }
  if (label_length(text, 0)) return out row(text, indent)
  if (indent > (depth > 0 ? base[depth] + column[depth] - 1 : 0)) out = out "<br>"
  return out link(escape(text))
}

# Writes the comment that was gathered in text[1 .. lines], with a first line of its own.
function render(first,    i, all, cut, count, part) {
  depth = code = 0
  if (first != "") print "/// " first
  # The first sentence: up to a stop before a capital or the end of its paragraph.
  all = ""
  for (i = 1; i <= lines && text[i] != "" && !label_length(text[i], 0) && text[i] !~ /^  /; i++) all = all (i > 1 ? " " : "") text[i]
  cut = match(all, /[.?!:] +[A-Z][a-z]* /) && all !~ /^[A-Z][a-z]*[?] / ? RSTART : length(all)
  if (all ~ /^[^.?!]*[?] The [^.]*[.]/) { match(all, /[?] The [^.]*[.]/); cut = RSTART + RLENGTH - 1 }
  if (cut > 0) {
    print "/// @brief " link(escape(substr(all, 1, cut)))
    print "///"
    if (cut < length(all)) print "/// " link(escape(substr(all, cut + 2)))
  }
  for (; i <= lines; i++) print "/// " render_line(text[i])
  print "/// " render_line("")
}

# A comment that stands alone begins a group: its first sentence is the name.
function open_group(    stop, i) {
  close_group()
  stop = match(text[1], /[.:]( |$)/) ? RSTART : length(text[1]) + 1
  print "/// @name " substr(text[1], 1, stop - 1)
  text[1] = substr(text[1], stop + 2)
  depth = code = 0
  for (i = 1; i <= lines; i++) print "/// " render_line(text[i])
  print "/// " render_line("")
  print "/// @{"
  group = 1
}

function close_group() {
  if (group) print "/// @}"
  group = 0
}

# Writes a declaration of one or several names, each with the comment.
function declare(line,    head, names, count, i) {
  if (line ~ /^ *(extern )?(const )?(struct )?[a-z0-9_]+ [^()]*,[^()]*;$/) {
    match(line, /^ *(extern )?(const )?(struct )?[a-z0-9_]+ /)
    head = substr(line, 1, RLENGTH)
    names = substr(line, RLENGTH + 1)
    sub(/;$/, "", names)
    count = split(names, each, / *, */)
    for (i = 1; i <= count; i++) {
      if (lines > 0) render("")
      print head each[i] ";"
    }
  } else {
    if (lines > 0) render("")
    print line
  }
}

# Gathers the rows of a struct's comment by their labels, before its members.
function note_rows(    i, n, label, each) {
  rows = 0
  for (i = 1; i <= lines; i++) {
    if (text[i] !~ /^ / && label_length(text[i], 0)) {
      row_text[++rows] = substr(text[i], label_length(text[i], 0) + 1)
      label = substr(text[i], 1, label_length(text[i], 0))
      sub(/ +$/, "", label)
      row_names[rows] = ", " label ","
    } else if (text[i] ~ /^ / && rows > 0) {
      sub(/^ +/, " ", text[i])
      row_text[rows] = row_text[rows] text[i]
    }
  }
}

# The row of the struct's comment that names the member, as the member's own comment.
function use_row(member,    name, i) {
  name = member
  sub(/[;,=\[(].*/, "", name)
  sub(/.*[ *]/, "", name)
  for (i = 1; i <= rows; i++) {
    if (index(row_names[i], ", " name ",")) text[lines = 1] = row_text[i]
  }
}

# A member or enumerator with what is said behind it, held back until its comment ends.
function flush_member() {
  if (member == "") return
  if (lines == 0) use_row(member)
  if (lines == 0) {
    sub(/^ +/, "", member)
    printf "%s:%d: warning: '%s' is not documented.\n", FILENAME, member_line, member >"/dev/stderr"
  }
  declare(member)
  member = ""
  lines = 0
}

function comment_text(line) {
  sub(/^ *\/\/ ?/, "", line)
  return line
}

# Is the line wholly a comment? Where it goes on one behind a member it stands in the same column.
/^ *\/\// {
  match($0, /\/\//)
  if (member != "" && RSTART == behind) {
    text[++lines] = comment_text($0)
    next
  }
  flush_member()
  if (!gathering) lines = 0
  gathering = 1
  text[++lines] = comment_text($0)
  next
}

!file_done && gathering {
  render("@file")
  file_done = 1
  gathering = lines = 0
}

# Guards, C++ and includes say nothing to a reader.
/^#ifdef __cplusplus/ {
  close_group()
}

/^#(ifdef __cplusplus|ifndef GJK2?_[A-Z0-9_]*_H$|define GJK2?_[A-Z0-9_]*_H$)/ || /^extern "C" \{/ || (/^\}$/ && !braces) {
  print ($0 ~ /^#if/ ? $0 : "")
  gathering = lines = 0
  next
}

/^$/ {
  flush_member()
  if (!braces && gathering) open_group()
  if (!braces) lines = 0
  gathering = 0
  print
  next
}

# In a struct, union or enum.
braces && !continued {
  flush_member()
  gathering_before = gathering
  gathering = 0
  if ($0 ~ /^\}/) {
    braces = lines = 0
    print
    next
  }
  if (!gathering_before) lines = 0
  behind = 0
  member = $0
  member_line = FNR
  if (match($0, / +\/\/ /)) {
    member = substr($0, 1, RSTART - 1)
    behind = RSTART + RLENGTH - 3
    text[++lines] = comment_text(substr($0, RSTART))
  }
  next
}

# Other declarations; what follows one without an empty line between has its comment, too.
{
  gathering = 0
  line = $0
  sub(/  +\/\/ .*/, "", line)
  if (!continued && line !~ /^#(if|else|endif|error|include|undef)/) {
    declare(line)
  } else {
    print line
  }
  if (!continued) macro = line ~ /^#define/
  continued = macro ? line ~ /\\$/ : line !~ /[;{]$/ && line !~ /^#/
  if (line ~ /^typedef (struct|union|enum)[^;]*\{$/) {
    braces = 1
    note_rows()
    lines = 0
    continued = 0
  }
}

END {
  close_group()
}
