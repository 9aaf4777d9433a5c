# Writes the declarations of api.sh as C#: structures laid out as in C, enumerations, constants and P/Invoke.
#   awk -f csharp.awk api.txt api.txt
#
# gjk_distance_result is Gjk.DistanceResult, gjk2_distance_result Gjk.Plane.DistanceResult; point_a is PointA. Structures that
# a class wraps end in Data. Functions keep their names in C. An int has 32 bits wherever C# runs.
function pascal(text,   parts, n, i, out) {
  n = split(text, parts, "_")
  out = ""
  for (i = 1; i <= n; i++) out = out toupper(substr(parts[i], 1, 1)) tolower(substr(parts[i], 2))
  return out
}

function name_of(t,   plane, base) {
  plane = t ~ /^gjk2_/
  base = t
  sub(/^gjk2?_/, "", base)
  return (plane ? "Gjk.Plane." : "Gjk.") pascal(base) (base ~ /^(shape|collider|scene|workspace)$/ ? "Data" : "")
}

function type_of(t,   rest) {
  if (t ~ /^\*/) {
    rest = substr(t, index(t, ":") + 1)
    if (rest in opaque || rest in callback || rest == "void") return "void*"
    return type_of(rest) "*"
  }
  if (t == "bool") return "Bool"
  if (t == "char" || t == "uint8_t") return "byte"
  if (t == "int8_t") return "sbyte"
  if (t == "int16_t") return "short"
  if (t == "uint16_t") return "ushort"
  if (t == "int") return "int"
  if (t == "int32_t" || t in alias) return "int"
  if (t == "unsigned" || t == "uint32_t") return "uint"
  if (t == "int64_t") return "long"
  if (t == "uint64_t") return "ulong"
  if (t == "size_t") return "UIntPtr"
  if (t == "void") return "void"
  return name_of(t)
}

function is_number(t) { return t ~ /^(s?byte|u?short|u?int|u?long)$/ }
function word(name) { return name ~ /^(in|out|ref|fixed|params|base|is|as|new|object)$/ ? "@" name : name }

# Puts a line into the namespace of a name.
function put(name, line) {
  if (name ~ /^gjk2_/) plane = plane line "\n"
  else space = space line "\n"
}

# An enumerator without what all of its enumeration begin with.
function put_enum(   i, j, common) {
  common = values[1]
  for (i = 2; i <= count; i++) while (index(values[i], common) != 1) common = substr(common, 1, length(common) - 1)
  sub(/[^_]*$/, "", common)
  put(enumeration, "    public enum " substr(name_of(enumeration), enumeration ~ /^gjk2_/ ? 11 : 5) " {")
  for (i = 1; i <= count; i++) put(enumeration, "        " pascal(substr(values[i], length(common) + 1)) " = " number[i] ",")
  put(enumeration, "    }")
  enumeration = ""
}

NR == FNR {
  if ($1 == "opaque") opaque[$2]
  if ($1 == "callback") callback[$3]
  if ($1 == "alias") alias[$2]
  next
}
enumeration != "" && !/^enumerator/ { put_enum() }
/^enum / { enumeration = $2; count = 0 }
/^enumerator/ { values[++count] = $2; number[count] = $3 }
/^constant/ {
  line = $2
  sub(/^GJK2?_/, "", line)
  line = "        public const " ($3 >= -2147483648 && $3 <= 2147483647 ? "int" : $3 <= 4294967295 ? "uint" : "long") " " pascal(line) " = " $3 ";\n"
  if ($2 ~ /^GJK2_/) flat_constants = flat_constants line
  else constants = constants line
}
/^(struct|union)/ {
  record = $2
  is_union = $1 == "union"
  short = name_of(record)
  sub(/^Gjk\.(Plane\.)?/, "", short)
  put(record, "    [StructLayout(LayoutKind." (is_union ? "Explicit" : "Sequential") ")]\n    public unsafe partial struct " short " {")
  sizes = sizes "            Check(\"" record "\", sizeof(" name_of(record) "));\n"
}
/^field/ {
  field = pascal($3)
  if (field == short) field = field "_"
  type = type_of($2)
  if (is_union) put(record, "        [FieldOffset(0)] public " type " " field ";")
  else if ($4 == 0) put(record, "        public " type " " field ";")
  else if (is_number(type)) put(record, "        public fixed " type " " field "[" $4 "];")
  else {
    line = "        " type
    for (i = 0; i < $4; i++) line = line (i > 0 ? "," : "") " " tolower(substr(field, 1, 1)) substr(field, 2) i
    put(record, line ";")
    put(record, "        public " type " " field "(int i) {")
    put(record, "            if ((uint)i >= " $4 ") throw new IndexOutOfRangeException();")
    put(record, "            fixed (" type "* first = &" tolower(substr(field, 1, 1)) substr(field, 2) "0) return first[i];\n        }")
  }
}
/^(function|callback)/ { kind = $1; name = $3; result = type_of($2); list = "" }
/^argument/ { list = list (list == "" ? "" : ", ") (type_of($2) == "Bool" ? "byte" : type_of($2)) " " word($3) }
/^end/ {
  if (kind == "function") {
    if (result == "Gjk.Status") result = "Status"
    functions = functions "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n        public static extern " \
      (result == "Bool" ? "byte" : result) " " name "(" list ");\n"
  } else if (kind == "") put(record, "    }")
  kind = ""
}
END {
  if (enumeration != "") put_enum()
  print "// Made from the C headers; what a name means stands there."
  print "using System;\nusing System.Runtime.InteropServices;\n\nnamespace Gjk {\n" space
  print "    public static class Constants {\n" constants "    }\n"
  print "    /// <summary>The functions of C. What a pointer points to must not move during a call.</summary>"
  print "    public static unsafe partial class Native {\n" functions "\n        static void CheckSizes() {\n" sizes "        }\n    }\n}\n"
  print "namespace Gjk.Plane {\n" plane "\n    public static class Constants {\n" flat_constants "    }\n}"
}
