# Reads public headers and prints what they declare, a line each, for the scripts beside this one:
#
#   opaque NAME                       a structure that is only pointed to
#   struct NAME | union NAME          followed by its fields, then 'end'
#   field TYPE NAME COUNT             COUNT 0: no array; otherwise a number, or the name of a constant
#   enum NAME | enumerator NAME       an enumerator follows its enum
#   constant NAME                     a macro without arguments that is a number
#   alias NAME TYPE                   a typedef of an integer
#   function TYPE NAME                followed by 'argument TYPE NAME' for each, then 'end'
#   callback TYPE NAME                the same, of a type of function that the caller has
#   data TYPE NAME                    a constant of the library
#
# A TYPE is one word: pointers stand before what they point to, as *const:gjk_vec3 and *mut:void. Headers have one form, which
# clang-format keeps.

# The word for a type as C writes it.
function type_of(text,   pointers, parts, n, i, word) {
  gsub(/ *\* */, " * ", text)
  n = split(text, parts, " ")
  word = ""
  is_const = 0
  for (i = 1; i <= n; i++) {
    if (parts[i] == "const") is_const = 1
    else if (parts[i] == "*") { word = (is_const ? "*const:" : "*mut:") word; is_const = 0 }
    else if (parts[i] != "struct") base = parts[i]
  }
  return word base
}

# Splits 'const gjk_vec3 *name' into type and name.
function declare(text) {
  sub(/^ +/, "", text)
  sub(/ +$/, "", text)
  match(text, /[A-Za-z_][A-Za-z0-9_]*$/)
  name = substr(text, RSTART)
  type = type_of(substr(text, 1, RSTART - 1))
}

function fields(text,   n, i, parts, first, count) {
  sub(/;.*/, "", text)
  if (text ~ /\(\*/) {  # a pointer to a function
    match(text, /\(\*[a-z_]+\)/)
    print "field *const:void " substr(text, RSTART + 2, RLENGTH - 3) " 0"
    return
  }
  n = split(text, parts, ",")
  for (i = 1; i <= n; i++) {
    count = 0
    if (match(parts[i], /\[[A-Za-z0-9_]+\]/)) {
      count = substr(parts[i], RSTART + 1, RLENGTH - 2)
      parts[i] = substr(parts[i], 1, RSTART - 1)
    }
    if (i == 1) { declare(parts[i]); first = type }
    else { name = parts[i]; gsub(/[ ]/, "", name) }
    print "field", first, name, count
  }
}

# word: function or callback
function prototype(word, text,   open, arguments, n, i, parts) {
  open = index(text, "(")
  arguments = substr(text, open + 1)
  sub(/\);.*/, "", arguments)
  declare(substr(text, 1, open - 1))
  print word, type, name
  n = arguments == "void" ? 0 : split(arguments, parts, ",")
  for (i = 1; i <= n; i++) {
    declare(parts[i])
    print "argument", type, name
  }
  print "end"
}

{ sub(/ *\/\/.*/, "") }
/^$/ { next }
pending != "" { $0 = pending " " $0; pending = "" }
kind == "record" && /^}/ { print "end"; kind = ""; next }
kind == "enum" && /^}/ { kind = ""; next }
kind == "enum" { sub(/^ +/, ""); sub(/[ ,=].*/, ""); if ($0 != "") print "enumerator", $0; next }
kind == "record" { if (!/;/) { pending = $0; next } fields($0); next }
/^typedef (struct|union) [a-z0-9_]+ \{/ { print $2, $3; kind = "record"; next }
/^typedef struct [a-z0-9_]+ [a-z0-9_]+;/ { print "opaque", $3; next }
/^typedef enum / { print "enum", $3; kind = "enum"; next }
/^typedef [a-z0-9_]+ [a-z0-9_]+;/ { sub(/;/, ""); print "alias", $3, $2; next }
/^typedef / { if (!/;/) { pending = $0; next } sub(/^typedef /, ""); prototype("callback", $0); next }
/^extern "C"/ { next }
/^extern / {
  sub(/^extern /, "")
  sub(/;/, "")
  n = split($0, names, ",")
  declare(names[1])
  print "data", type, name
  for (i = 2; i <= n; i++) { gsub(/ /, "", names[i]); print "data", type, names[i] }
  next
}
/^ *# *define GJK2?_[A-Z0-9_]+ / {
  sub(/# +define/, "#define")
  if ($2 !~ /_H$|_(POINT|POSE_IDENTITY)$/ && NF > 2) print "constant", $2
  next
}
/^#/ || /^ / || /^}/ { next }
/\(/ { if (!/;/) { pending = $0; next } prototype("function", $0) }
