#!/bin/sh
# Public headers: each compiles alone, as C99 and as C++; so does every initialiser of a shape. test_headers.sh BUILD
. tests/build/count.sh
scratch=$1/headers
mkdir -p "$scratch"
warnings='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror'

# Every macro of shape.h that makes a shape is used once, with as many arguments as it has. vertices is for the macros
# whose first argument is an array, support for those whose first is a function.
uses() {
  sed -n 's/^#define GJK_\([A-Z_]*\)\(([^)]*)\)\{0,1\} .*/\1\2/p' include/gjk/shape.h | awk '
    /^SHAPE_H/ { next }
    {
      macro = $0; sub(/\(.*/, "", macro)
      arguments = ""
      if (match($0, /\(.*\)/)) {
        count = split(substr($0, RSTART + 1, RLENGTH - 2), name, / *, */)
        for (i = 1; i <= count; i++) {
          value = "3"
          if (name[i] ~ /^vertices/ || name[i] == "user_pointer") value = "vertices"
          if (name[i] == "function") value = "support"
          if (name[i] == "faces_pointer") value = "0"
          arguments = arguments (i > 1 ? ", " : "") value
        }
        arguments = "(" arguments ")"
      }
      printf "extern const gjk_shape shape_%s;\nconst gjk_shape shape_%s = GJK_%s%s;\n", macro, macro, macro, arguments
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
  uses
} >"$scratch/initialisers.c"

# compile COMPILER FLAGS... FILE
compile() {
  # shellcheck disable=SC2086
  "$@" $warnings -Iinclude -fsyntax-only
}

all_initialisers_used() {
  used=$(grep -c '^const gjk_shape ' "$scratch/initialisers.c")
  [ "$used" = "$(grep -cE '^#define GJK_[A-Z_]+(\(.*\))? ' include/gjk/shape.h)" ]
}

check 'every initialiser is in the test' all_initialisers_used
for compiler in gcc clang; do
  if ! have $compiler; then
    skip "headers with $compiler" $compiler
    continue
  fi
  for header in include/gjk/*.h; do
    check "$header as C99, $compiler" compile $compiler -std=c99 -x c "$header"
  done
  check "initialisers as C99, $compiler" compile $compiler -std=c99 -x c "$scratch/initialisers.c"
done
for compiler in g++ clang++; do
  if ! have $compiler; then
    skip "headers with $compiler" $compiler
    continue
  fi
  for header in include/gjk/*.h; do
    check "$header as C++98, $compiler" compile $compiler -std=c++98 -Wno-long-long -x c++ "$header"
    check "$header as C++11, $compiler" compile $compiler -std=c++11 -x c++ "$header"
  done
  check "initialisers as C++11, $compiler" compile $compiler -std=c++11 -x c++ "$scratch/initialisers.c"
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
