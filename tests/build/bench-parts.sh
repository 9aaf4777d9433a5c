#!/bin/sh
# Convex parts beside those of HACD, if it is installed (libbullet-extras-dev): bench-parts.sh BUILD [MESH[=PARTS]...].
# Meshes are in millimetres; without any, those of tests/data and some brackets. MESH=PARTS: see tests/measure/parts/main.c.
# OBJECTS: what to link. Fails where the library's own parts do not enclose a mesh.
set -e
build=$1/parts
shift
mkdir -p "$build"
flags='-O2 -I. -Iinclude -Iport -Itests/support -Itests/measure/parts'
peer=
defines=
libraries=
if [ -e /usr/include/bullet/HACD/hacdHACD.h ] && command -v "${CXX:-c++}" >/dev/null; then
  ${CXX:-c++} -std=c++17 $flags -isystem /usr/include/bullet/HACD -c tests/measure/parts/hacd.cpp -o "$build/hacd.o"
  peer=$build/hacd.o defines=-DWITH_HACD libraries='-lHACD -lstdc++'
else
  echo 'skipped: HACD (libbullet-extras-dev is not installed)' >&2
fi
${CC:-cc} -std=c99 $flags $defines tests/measure/parts/main.c $peer $OBJECTS $libraries -lm -o "$build/bench"

# bracket NAME X Y ...: a prism over an outline, counterclockwise, from which each face of many corners is one face of the file.
bracket() {
  name=$1
  shift
  echo "$@" | awk '{
    n = NF / 2
    for (z = 0; z < 2; z++) for (i = 0; i < n; i++) print "v", $(2 * i + 1), $(2 * i + 2), 25 * z
    line = "f"; for (i = 1; i <= n; i++) line = line " " n + i
    print line
    line = "f"; for (i = n; i > 0; i--) line = line " " i
    print line
    for (i = 0; i < n; i++) print "f", 1 + i, 1 + (i + 1) % n, 1 + n + (i + 1) % n, 1 + n + i
  }' >"$build/$name.obj"
}
if [ $# -eq 0 ]; then
  bracket cross 30 0 50 0 50 30 80 30 80 50 50 50 50 80 30 80 30 50 0 50 0 30 30 30
  bracket stairs 0 0 100 0 100 20 80 20 80 40 60 40 60 60 40 60 40 80 20 80 20 100 0 100
  bracket comb 0 0 90 0 90 50 80 50 80 10 50 10 50 50 40 50 40 10 10 10 10 50 0 50
  awk '/^v/ { x = $2 * .8 - $3 * .6; y = $2 * .6 + $3 * .8; printf "v %.6f %.6f %.6f\n", x, y * .28 - $4 * .96, y * .96 + $4 * .28 }
    /^f/' tests/data/hulls/u_channel.obj >"$build/u_turned.obj"
  awk -f tests/data/meshes/torus.awk >"$build/torus.obj"
  set -- tests/data/hulls/l_bracket.obj tests/data/hulls/u_channel.obj "$build/u_turned.obj" "$build/cross.obj" \
    "$build/stairs.obj" "$build/comb.obj" tests/data/meshes/bracket.obj "$build/torus.obj" tests/data/meshes/rock.obj
fi
"$build/bench" "$@"
