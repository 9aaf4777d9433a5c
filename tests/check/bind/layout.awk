# Reads what port/bind/api.sh prints. names: prints a line for each structure and each of its fields, NAME or NAME.FIELD.
# c: a source in C with a table of their sizes and offsets, in this order. rust: a program that prints them, as NAME NUMBER.
#   awk -v as=names|c|rust -f layout.awk api.txt
function entry(name, c, rust) {
  if (as == "names") print name
  else if (as == "c") print "  " c ","
  else print "    println!(\"" name " {}\", " rust ");"
}

BEGIN {
  if (as == "c") print "#include \"gjk.h\"\n#include <stddef.h>\nconst unsigned layout[] = {"
  if (as == "rust") print "use gjk_sys::*;\nuse std::mem::{size_of, MaybeUninit};\nuse std::ptr::addr_of;\n\nfn main() {"
}
/^(struct|union)/ {
  record = $2
  entry(record, "sizeof(" record ")", "size_of::<" record ">()")
  if (as == "rust") print "    let memory = MaybeUninit::<" record ">::uninit();\n    let at = memory.as_ptr();"
}
/^field/ {
  field = $3 ~ /^(type|box|move|ref|in|where)$/ ? $3 "_" : $3
  entry(record "." $3, "offsetof(" record ", " $3 ")", "unsafe { addr_of!((*at)." field ") as usize } - at as usize")
}
END {
  if (as == "c") print "};"
  if (as == "rust") print "}"
}
