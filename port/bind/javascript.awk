# Writes the declarations of api.sh as JavaScript, or with as=types as TypeScript: classes that look at a structure in the memory
# of a WebAssembly module, and constants.
# With as=layout the sizes and offsets that the classes have, as NAME NUMBER and NAME.FIELD NUMBER.
#   awk -v as=code|types|layout [-v skip=REGEX] -f javascript.awk api.txt api.txt
#
# gjk_distance_result is DistanceResult, gjk2_distance_result DistanceResult2; point_a is pointA. Structures of up to four int32 are
# typed arrays, and so are arrays of numbers. skip: structures that nobody needs.
function camel(text, first,   parts, n, i, out) {
  n = split(text, parts, "_")
  out = first ? toupper(substr(parts[1], 1, 1)) substr(parts[1], 2) : parts[1]
  for (i = 2; i <= n; i++) out = out toupper(substr(parts[i], 1, 1)) substr(parts[i], 2)
  return out
}

function class_of(t,   base) {
  base = t
  sub(/^gjk2?_/, "", base)
  return camel(base, 1) (t ~ /^gjk2_/ ? "2" : "")
}

# The view of memory that has a number, and its bytes.
function view_of(t) {
  if (t ~ /^\*/ || t == "size_t" || t == "unsigned" || t == "uint32_t") return "u32"
  if (t == "bool" || t == "uint8_t" || t == "char") return "u8"
  if (t == "int8_t") return "i8"
  if (t == "int16_t") return "i16"
  if (t == "uint16_t") return "u16"
  if (t == "int64_t") return "i64"
  if (t == "uint64_t") return "u64"
  if (t == "int32_t" || t == "int" || t in alias || t in enum) return "i32"
  return ""
}

function bytes_of(view) { return substr(view, 2) / 8 }
function shift_of(view) { return view ~ /8/ ? 0 : view ~ /16/ ? 1 : view ~ /32/ ? 2 : 3 }
function array_of(view) {
  return view ~ /64/ ? (view ~ /u/ ? "BigUint64Array" : "BigInt64Array") : (view ~ /u/ ? "Uint" : "Int") substr(view, 2) "Array"
}
function up(n, to) { return int((n + to - 1) / to) * to }

function line(text) { body = body "  " text "\n" }

# A property that is looked up once: its parts stay where they are.
function once(name, type, value) {
  if (as == "types") line("readonly " name ": " type ";")
  else {
    line("get " name "() {")
    line("  const value = " value ";")
    line("  Object.defineProperty(this, '" name "', { value });")
    line("  return value;\n  }")
  }
}

function add_field(t, name, count,   view, size, at, index_, where) {
  view = view_of(t)
  size = view != "" ? bytes_of(view) : size_of[t]
  at = up(bytes, view != "" ? size : align_of[t])
  if (align < (view != "" ? size : align_of[t])) align = view != "" ? size : align_of[t]
  bytes = at + size * (count != 0 ? count : 1)
  if (view == "i32" && count == 0) numbers++
  else numbers = -1000
  offsets = offsets record "." name " " at "\n"
  name = camel(name, 0)
  where = at != 0 ? "this.at + " at : "this.at"
  if (view != "" && count != 0) once(name, array_of(view), "new " array_of(view) "(this.memory.buffer, " where ", " count ")")
  else if (view == "" && vector[t] && count == 0) once(name, "Int32Array", "new Int32Array(this.memory.buffer, " where ", " vector[t] ")")
  else if (view == "" && count != 0) once(name, "readonly " class_of(t) "[]", "parts(" class_of(t) ", this, " where ", " count ")")
  else if (view == "") once(name, class_of(t), "new " class_of(t) "(this.memory, " where ")")
  else if (as == "types") line((t ~ /^\*/ ? "/** An address in the module's memory. */\n  " : "") name ": " (t == "bool" ? "boolean" : view ~ /64/ ? "bigint" : "number") ";")
  else {
    index_ = "this.memory." view "[" (shift_of(view) > 0 ? (at != 0 ? "(" where ")" : where) " >> " shift_of(view) : where) "]"
    line("get " name "() { return " index_ (t == "bool" ? " !== 0" : "") "; }")
    line("set " name "(value) { " index_ " = " (t == "bool" ? "+value" : "value") "; }")
  }
}

NR == FNR {
  if ($1 == "alias") alias[$2]
  if ($1 == "enum") enum[$2]
  next
}
FNR == 1 && as == "code" {
  print "// Made from the C headers; what a name means stands there."
  print "export class Record {\n  constructor(memory, at) {\n    this.memory = memory;\n    this.at = at;\n  }\n}\n"
  print "function parts(of, record, at, count) {\n  return Array.from({ length: count }, (_, i) => new of(record.memory, at + of.bytes * i));\n}\n"
}
FNR == 1 && as == "types" {
  print "// Made from the C headers; what a name means stands there."
  print "export interface Memory {\n  readonly buffer: ArrayBuffer;\n}\n"
  print "export class Record {\n  constructor(memory: Memory, at: number);\n  readonly memory: Memory;\n  readonly at: number;\n}\n"
}
/^(constant|enumerator)/ && $2 != "GJK_HASH_BEGIN" {
  constants = constants (as == "types" ? "  readonly " : "  ") $2 ": " $3 (as == "types" ? ";\n" : ",\n")
}
/^(struct|union)/ { record = $2; bytes = align = numbers = 0; body = offsets = ""; is_record = $1 == "struct" }
/^field/ { add_field($2, $3, $4) }
/^end/ && is_record {
  size_of[record] = up(bytes, align)
  align_of[record] = align
  vector[record] = numbers > 1 && numbers <= 4 ? numbers : 0
  layout = layout record " " size_of[record] "\n" offsets
  if (as != "layout" && (skip == "" || record !~ skip)) {
    print "export class " class_of(record) " extends Record {\n" body (as == "types" ? "  static readonly bytes: number;\n}\n" : "}\n" \
      class_of(record) ".bytes = " size_of[record] ";\n" class_of(record) ".inC = '" record "';\n")
  }
  is_record = 0
}
/^end/ { is_record = 0 }
END {
  if (as == "layout") printf "%s", layout
  else print (as == "types" ? "export const Constants: {\n" : "export const Constants = Object.freeze({\n") constants (as == "types" ? "};" : "});")
}
