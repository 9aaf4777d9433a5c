#!/bin/sh
# The Python module, as it is installed: the golden hashes of pairs and of a scene, errors, lifetimes, low ceilings on
# iterations, and the README's examples. test_python.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/python-test
golden=$(sed -n 's/^#define GOLDEN_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/golden.h)
plane_golden=$(sed -n 's/^#define PLANE_GOLDEN_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/plane_golden.h)
few=$(sed -n 's/^#define GOLDEN_FEW_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/golden.h)
scene_few=$(sed -n 's/^#define SCENE_GOLDEN_FEW_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/scene_golden.h)
plane_scene_few=$(sed -n 's/^#define PLANE_SCENE_GOLDEN_FEW_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/plane_scene_golden.h)
rm -rf "$dir"
mkdir -p "$dir"
dir=$(cd "$dir" && pwd)
prefix=$dir/prefix
modules=$prefix/lib/python3/dist-packages

# python FILE...: with the installed module, which finds the installed library by itself
python() {
  PYTHONPATH=$modules PYTHONDONTWRITEBYTECODE=1 GJK_LIBRARY='' python3 "$@"
}

# The blocks of Python in port/README.md, as one program, print what their comments '# prints: TEXT' say.
readme() {
  awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/README.md >"$dir/readme.py"
  sed -n 's/.*# prints: //p' "$dir/readme.py" >"$dir/expected"
  test -s "$dir/expected" && python "$dir/readme.py" >"$dir/printed" && diff "$dir/expected" "$dir/printed"
}

# tidy FILE...: they are Python, and have lines of at most 120 columns without blanks at their ends
tidy() {
  python3 -c 'import ast, sys; [ast.parse(open(name).read(), name) for name in sys.argv[1:]]' "$@" &&
    ! grep -nE '.{121}|[[:blank:]]$|	' "$@"
}

# A module of other structures than the library's does not load.
refuses_another_version() {
  cp -r "$modules" "$dir/other" &&
    sed -i '0,/("saturated", c_bool),/s//("saturated", c_bool), ("surplus", c_int32),/' "$dir/other/gjk/_pairs.py" &&
    ! PYTHONPATH=$dir/other GJK_LIBRARY=$prefix/lib/libgjk.so python3 -c 'import gjk' 2>"$dir/refusal" &&
    grep -q 'ImportError: .* has another gjk2_distance_result' "$dir/refusal"
}

other_bits() {
  ! python tests/check/bind/golden.py 149 "$few"
}

other_match() {
  ! python tests/check/bind/scene_golden.py 499 "$scene_few"
}

# ceiling MAX: with a library that has it
ceiling() {
  # shellcheck disable=SC2086
  ceilings_library &&
    "${CC:-cc}" -shared -std=c99 -O1 -fPIC -Wl,-Bsymbolic -Iinclude -Iport "-DGJK_ITERATIONS_MAX=$1" src/bind/gjk_bind_names.c \
      port/hosted/gjk_hosted.c $ceilings_objects -o "$dir/libgjk-$1.so" &&
    PYTHONPATH=$modules PYTHONDONTWRITEBYTECODE=1 GJK_TEST_ITERATIONS=$1 GJK_LIBRARY=$dir/libgjk-$1.so python3 tests/check/bind/ceilings.py "$dir/save"
}

if ! have python3; then
  skip 'the Python module' python3
  finish python
  exit
fi
check 'make install' sh tests/build/install.sh "$build" "$prefix"
check 'the files are tidy' tidy port/python/gjk/*.py port/python/gjk/plane/*.py tests/check/bind/*.py
check 'numbers, names, errors, lifetimes' python tests/check/bind/behaviour.py
check 'ground of the plane' python tests/check/bind/ground_behaviour.py
check 'scenes' python tests/check/bind/scene_behaviour.py
check 'bodies of many parts, hulls, masses' python tests/check/bind/parts_behaviour.py
check 'arms' python tests/check/bind/arm_behaviour.py "$build/gjk-convert"
check 'a save' python tests/check/bind/ceilings.py "$dir/save"
for max in 1 2 3; do
  check "a ceiling of $max" ceiling $max
done
check 'the golden hash of a scene' python tests/check/bind/scene_golden.py 500 "$scene_few"
check 'the golden hash of a scene of the plane' python tests/check/bind/scene_golden.py 500 "$plane_scene_few" plane
check 'another match has another hash' other_match
check 'the golden hash' python tests/check/bind/golden.py 3000 "$golden"
check 'the golden hash of the plane' python tests/check/bind/plane_golden.py 3000 "$plane_golden"
check 'another set has another hash' other_bits
check "the README's examples" readme
check 'a library with other structures is refused' refuses_another_version
finish python
