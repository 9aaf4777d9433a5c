#!/bin/sh
# Public headers: each compiles alone, all as C99 and as C++; so does every initialiser of a shape. test_headers.sh BUILD
. tests/build/count.sh
scratch=$1/headers
mkdir -p "$scratch"
warnings='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror'

# Every macro of shape.h that makes a shape is used once, with as many arguments as it has. vertices is for the macros
# whose first argument is an array, support for those whose first is a function. uses GJK or GJK2, in space or in the plane
uses() {
  upper=$1
  lower=$(echo "$upper" | tr GJK gjk)
  sed -n "s/^#define ${upper}_\([A-Z_]*\)\(([^)]*)\)\{0,1\} .*/\1\2/p" "include/$lower/shape.h" | awk -v upper="$upper" -v lower="$lower" '
    /^SHAPE_H|^LENGTHS/ { next }
    {
      macro = $0; sub(/\(.*/, "", macro)
      arguments = ""
      if (match($0, /\(.*\)/)) {
        count = split(substr($0, RSTART + 1, RLENGTH - 2), name, / *, */)
        for (i = 1; i <= count; i++) {
          value = "3"
          if (name[i] ~ /^vertices/ || name[i] == "user_pointer") value = "vertices"
          if (name[i] == "n") value = "2"
          if (name[i] == "function") value = "support"
          if (name[i] == "faces_pointer" || name[i] == "table_pointer") value = "0"
          arguments = arguments (i > 1 ? ", " : "") value
        }
        arguments = "(" arguments ")"
      }
      type = lower "_shape shape_" macro
      printf "extern const %s;\nconst %s = %s_%s%s;\n", type, type, upper, macro, arguments
    }'
}

{
  echo '#include "gjk/gjk.h"'
  echo 'static const gjk_vec3 vertices[3] = {{0, 0, 0}, {1, 0, 0}, {0, GJK_Q16(-1.5), 0}};'
  echo 'static void support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {'
  echo '  (void)user;'
  echo '  *out = *direction;'
  echo '}'
  echo 'extern const gjk_pose pose;'
  echo 'const gjk_pose pose = GJK_POSE_IDENTITY;'
  uses GJK
} >"$scratch/initialisers.c"

{
  echo '#include "gjk2/gjk2.h"'
  echo 'static const gjk2_vec vertices[3] = {{0, 0}, {1, 0}, {0, GJK_Q16(-1.5)}};'
  echo 'static void support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {'
  echo '  (void)user;'
  echo '  *out = *direction;'
  echo '}'
  echo 'extern const gjk2_pose pose;'
  echo 'const gjk2_pose pose = GJK2_POSE_IDENTITY;'
  uses GJK2
} >"$scratch/initialisers2.c"

# compile COMPILER FLAGS... FILE
compile() {
  # shellcheck disable=SC2086
  "$@" $warnings -Iinclude -fsyntax-only
}

all_initialisers_used() {
  used=$(grep -c '^const gjk_shape ' "$scratch/initialisers.c")
  [ "$used" = "$(grep -E '^#define GJK_[A-Z_]+(\(.*\))? ' include/gjk/shape.h | grep -vc GJK_LENGTHS\()" ] || return 1
  used=$(grep -c '^const gjk2_shape ' "$scratch/initialisers2.c")
  [ "$used" = "$(grep -E '^#define GJK2_[A-Z_]+(\(.*\))? ' include/gjk2/shape.h | grep -vc GJK2_LENGTHS\()" ]
}

check 'every initialiser is in the test' all_initialisers_used

# all_included FOLDER: FOLDER/FOLDER.h, which says that it includes all headers of FOLDER, does.
all_included() {
  cc -Iinclude -MM "include/$1/$1.h" | tr ' ' '\n' | grep "^include/$1/" | sort >"$scratch/reached"
  find "include/$1" -name '*.h' | sort | diff - "$scratch/reached"
}
check 'gjk/gjk.h includes all headers' all_included gjk
check 'gjk2/gjk2.h includes all headers of the plane' all_included gjk2

# Does each header include what it needs? One language tells that of all. C wants a declaration, which a header of macros alone
# does not have.
echo 'extern int declaration;' >"$scratch/declaration.c"
if have gcc; then
  for header in include/gjk/*.h include/gjk2/*.h; do
    check "$header alone" compile gcc -std=c99 -include "$header" -x c "$scratch/declaration.c"
  done
else
  skip 'headers alone' gcc
fi

# The files below include all headers.
for language in 'gcc -std=c99 -x c' 'clang -std=c99 -x c' 'g++ -std=c++11 -x c++' 'clang++ -std=c++11 -x c++'; do
  if ! have "${language%% *}"; then
    skip "headers, $language" "${language%% *}"
    continue
  fi
  # shellcheck disable=SC2086
  check "headers and initialisers, $language" compile $language "$scratch/initialisers.c"
  # shellcheck disable=SC2086
  check "headers and initialisers of the plane, $language" compile $language "$scratch/initialisers2.c"
done
for compiler in g++ clang++; do
  if have $compiler; then
    check "headers as C++98, $compiler" compile $compiler -std=c++98 -Wno-long-long -include gjk2/gjk2.h -x c++ include/gjk/gjk.h
  else
    skip "headers with $compiler" $compiler
  fi
done

# Lengths that are no integers and numbers that leave their format do not compile, even where warnings are off. Each argument of
# each initialiser in turn that is a length in the test of all initialisers becomes 0.5. A line of a file is a case.
declared='#include "gjk/gjk.h"
extern const gjk_vec3 vertices[]; gjk_support_function support;'
{
  echo "$declared"
  awk '
    /^const gjk_shape / {
      for (at = 1; (found = match(substr($0, at), /[(,] *3[,)]/)) > 0; at += found + 1) {
        length_at = at + found - 1 + RLENGTH - 2
        line = "static " substr($0, 1, length_at - 1) "0.5" substr($0, length_at + 1)
        sub(/ = /, "_" ++cases " = ", line)
        print line
      }
    }' "$scratch/initialisers.c"
} >"$scratch/halves.c"
check 'lengths to be refused' test "$(wc -l <"$scratch/halves.c")" -ge 36

# numbers VALUES...: constants of these values
numbers() {
  echo "$declared"
  for value; do
    printf 'extern const int32_t number_%d; const int32_t number_%d = %s;\n' $# $# "$value"
    shift
  done
}
numbers 'GJK_Q16(32767.99999)' 'GJK_Q16(-32768.0)' 'GJK_Q16(0.0)' 'GJK_Q16(7)' 'GJK_Q30(1.9999999)' 'GJK_Q30(-2.0)' \
  >"$scratch/numbers.c"
numbers 'GJK_Q16(40000.0)' 'GJK_Q16(-40000.0)' 'GJK_Q16(32768)' 'GJK_Q16(32767.999993)' 'GJK_Q16(-32768.00001)' \
  'GJK_Q16(1e300)' 'GJK_Q30(2.0)' 'GJK_Q30(-2.1)' >"$scratch/far.c"

# each_refused FILE COMPILER FLAGS...: every line of the file after its second has an error, and nothing else has
each_refused() {
  file=$1
  shift
  "$@" -w -Iinclude -fsyntax-only "$file" >"$scratch/refusal" 2>&1
  grep -E '(^| )(fatal )?error: ' "$scratch/refusal" | sed -n 's|^\([^ :]*:[0-9]*\):.*|\1|p' | sort -u >"$scratch/refused"
  awk -v file="$file" 'NR > 2 { print file ":" NR }' "$file" | sort | diff - "$scratch/refused"
}

for language in 'gcc -std=c99 -ftrack-macro-expansion=0 -x c' 'clang -std=c99 -ferror-limit=0 -x c' \
  'g++ -std=c++11 -ftrack-macro-expansion=0 -x c++' 'clang++ -std=c++11 -ferror-limit=0 -x c++'; do
  if have "${language%% *}"; then
    # shellcheck disable=SC2086
    check "numbers within their format compile, $language" compile $language "$scratch/numbers.c"
    for file in halves far; do
      # shellcheck disable=SC2086
      check "$file.c is refused, $language" each_refused "$scratch/$file.c" $language
    done
  fi
done

# A C++ program calls the C library.
cat >"$scratch/program.cpp" <<'END'
#include "gjk/gjk.h"

int main() {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider a = {};
  gjk_decision decision = {};
  if (gjk_collider_init(&a, &ball, 0, 0) != GJK_OK || gjk_collider_pose(&a, &pose) != GJK_OK) return 1;
  return gjk_intersect(&a, &a, 0, &decision) == GJK_OK && decision.yes ? 0 : 2;
}
END
links_and_runs() {
  g++ -std=c++11 -Iinclude "$scratch/program.cpp" "$1/host/libgjk.a" "$1/hosted/port/hosted/gjk_hosted.o" \
    -o "$scratch/program" && "$scratch/program"
}
if have g++; then
  check 'a C++ program links and runs' links_and_runs "$1"
else
  skip 'a C++ program' g++
fi
finish headers
