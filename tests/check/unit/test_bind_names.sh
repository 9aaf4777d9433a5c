#!/bin/sh
# gjk_size_of and gjk_constant know every structure, constant and enumerator of the public headers, with its value; and
# every macro of a shape has its function. test_bind_names.sh BUILD
. tests/build/count.sh
build=$1
scratch=$build/bind-names
mkdir -p "$scratch"
headers='include/gjk/*.h include/gjk2/*.h'

structures() {
  # shellcheck disable=SC2086
  awk '/^typedef (struct|union) [a-z0-9_]+ \{/ { inside = 1 }
    /^} / { if (inside) { sub(/;.*/, ""); print $2 } inside = 0 }' $headers
}

# Enumerators, and macros without arguments but for header guards and the initialisers of structures.
constants() {
  # shellcheck disable=SC2086
  awk '/^typedef enum / { inside = 1; next }
    /^}/ { inside = 0 }
    inside && /^  GJK2?_/ { sub(/[ ,].*/, "", $1); sub(/,$/, "", $1); print $1 }
    { sub(/^# +define/, "#define") }
    /^ *#define GJK2?_[A-Z0-9_]+ / && $2 !~ /_H$|_(POINT|POSE_IDENTITY)$/ && NF > 2 { print $2 }' $headers | sort -u
}

program() {
  echo '#include <stdio.h>'
  for header in $headers; do
    echo "#include \"${header#include/}\""
  done
  echo 'int main(void) {'
  echo '  int wrong = 0;'
  echo '  int64_t value = 0;'
  structures | awk '{ print "  if (gjk_size_of(\"" $1 "\") != sizeof(" $1 ")) { puts(\"" $1 "\"); wrong++; }" }'
  constants | awk '{
      print "  if (gjk_constant(\"" $1 "\", &value) != GJK_OK || value != (int64_t)(" $1 ")) { puts(\"" $1 "\"); wrong++; }"
    }'
  echo '  return wrong != 0;'
  echo '}'
}

knows_all() {
  program >"$scratch/names.c" && "${CC:-cc}" -std=c99 -Iinclude "$scratch/names.c" "$build/host/libgjk.a" \
    "$build/hosted/port/hosted/gjk_hosted.o" -o "$scratch/names" && "$scratch/names"
}

enough() {
  [ "$(structures | wc -l)" -ge 100 ] && [ "$(constants | wc -l)" -ge 130 ]
}

# as_functions UPPER LOWER: for each GJK_ROUNDED_KIND there is a gjk_shape_kind
as_functions() {
  for kind in $(sed -n "s/^#define $1_ROUNDED_\([A-Z_]*\)(.*/\1/p" "include/$2/shape.h" | tr '[:upper:]' '[:lower:]'); do
    case $kind in hull_with_faces) kind=hull ;; esac
    grep -q "^gjk_status $2_shape_$kind(" "include/$2/bind.h" || { echo "no $2_shape_$kind"; return 1; }
  done
}

check 'as many names as there are' enough
check 'every name is known' knows_all
check 'every shape by a function' as_functions GJK gjk
check 'every shape of the plane by a function' as_functions GJK2 gjk2
finish bind_names
