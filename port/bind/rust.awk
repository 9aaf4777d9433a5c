# Writes the declarations of api.sh as Rust, with their names in C: awk -f rust.awk api.txt api.txt
#
# An int has 32 bits wherever there is a Rust that this serves.
function scalar(t) {
  if (t == "void") return "c_void"
  if (t == "bool") return "bool"
  if (t == "char") return "u8"
  if (t == "unsigned") return "u32"
  if (t == "int") return "i32"
  if (t == "size_t") return "usize"
  if (t ~ /^u?int[0-9]+_t$/) { sub(/_t$/, "", t); sub(/^uint/, "u", t); sub(/^int/, "i", t) }
  return t
}

function type_of(t) {
  if (t ~ /^\*/ && substr(t, index(t, ":") + 1) in callback) return "Option<" substr(t, index(t, ":") + 1) ">"
  if (t ~ /^\*const:/) return "*const " type_of(substr(t, 8))
  if (t ~ /^\*mut:/) return "*mut " type_of(substr(t, 6))
  return scalar(t)
}

function word(name) {
  return name ~ /^(type|box|move|ref|in|where|final|yield|loop|match)$/ ? name "_" : name
}

NR == FNR { if ($1 == "callback") callback[$3]; next }
FNR == 1 {
  print "// Made from the C headers; what a name means stands there."
  print "use core::ffi::c_void;\n"
}
/^opaque/ { print "#[repr(C)]\npub struct " $2 " {\n    _private: [u8; 0],\n}" }
/^(struct|union)/ {
  print "#[repr(C)]\n#[derive(Clone, Copy" ($1 == "struct" ? ", Debug, PartialEq" : "") ")]\npub " $1 " " $2 " {"
}
/^field/ { print "    pub " word($3) ": " ($4 != 0 ? "[" type_of($2) "; " $4 "]" : type_of($2)) "," }
/^alias|^enum / { print "pub type " $2 " = " ($1 == "enum" ? "i32" : scalar($3)) ";" }
/^(constant|enumerator)/ {
  print "pub const " $2 ": " ($3 >= -2147483648 && $3 <= 2147483647 ? "i32" : $3 > 0 && $3 <= 4294967295 ? "u32" : "u64") " = " $3 ";"
}
/^(function|callback)/ { kind = $1; name = $3; result = $2 == "void" ? "" : " -> " type_of($2); arguments = "" }
/^argument/ { arguments = arguments (arguments == "" ? "" : ", ") word($3) ": " type_of($2) }
/^data/ { foreign[++foreigners] = "    pub static " $3 ": " type_of($2) ";" }
/^end/ {
  if (kind == "function") foreign[++foreigners] = "    pub fn " name "(" arguments ")" result ";"
  else if (kind == "callback") print "pub type " name " = unsafe extern \"C\" fn(" arguments ")" result ";"
  else print "}"
  kind = ""
}
END {
  print "\nextern \"C\" {"
  for (i = 1; i <= foreigners; i++) print foreign[i]
  print "}"
}
