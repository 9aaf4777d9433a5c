#!/bin/sh
# Hulls of points beside qhull and CGAL, as far as they are installed (libqhull-dev, libcgal-dev): bench-hull.sh BUILD.
# Prints times, and the answers on tests/data/hulls. Fails where the library's own are wrong.
set -e
build=$1/hull
mkdir -p "$build"
flags='-O2 -Iinclude -Itests/support -Itests/measure/hull'
objects=
defines=
libraries=
if [ -e /usr/include/libqhull_r/libqhull_r.h ]; then
  ${CC:-cc} $flags -c tests/measure/hull/qhull.c -o "$build/qhull.o"
  objects="$objects $build/qhull.o" defines="$defines -DWITH_QHULL" libraries="$libraries -lqhull_r"
else
  echo 'skipped: qhull (libqhull-dev is not installed)'
fi
if [ -e /usr/include/CGAL/convex_hull_3.h ]; then
  ${CXX:-c++} -std=c++17 -DNDEBUG $flags -c tests/measure/hull/cgal.cpp -o "$build/cgal.o"
  objects="$objects $build/cgal.o" defines="$defines -DWITH_CGAL" libraries="$libraries -lgmp -lmpfr -lstdc++"
else
  echo 'skipped: CGAL (libcgal-dev is not installed)'
fi
${CC:-cc} -std=c99 $flags $defines tests/measure/hull/main.c src/hull/*.c src/arith/*.c $objects $libraries -lm -o "$build/bench"
truths=$(sed -n 's|^\([^ ]*\) .*vertices=\([0-9]*\) faces=\([0-9]*\).*|tests/data/hulls/\1.txt=\2/\3|p' tests/data/hulls/expected)
"$build/bench" $truths
