#!/bin/sh
# The wheel as pip installs it: second opinions against brute force in rational numbers, batches over numpy, the golden hashes of
# pairs and of a scene, the README's example and the dispute. test_wheel.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/wheel-test
rm -rf "$dir"
mkdir -p "$dir"
dir=$(cd "$dir" && pwd)
hash_of() {
  sed -n "s/^#define $1 UINT64_C(0x\(.*\))\$/\1/p" "tests/check/target/$2.h"
}

if ! have python3; then
  skip 'the wheel' python3
  finish wheel
  exit
fi
# A Python with pip and numpy, if there is one.
python=python3
for one in python3 /usr/bin/python3; do
  if "$one" -c 'import numpy, pip' 2>/dev/null; then
    python=$one
    break
  fi
done

runs() {
  PYTHONPATH=$dir/site PYTHONDONTWRITEBYTECODE=1 GJK_LIBRARY='' "$python" "$@"
}

installed() {
  "$python" -m pip install --quiet --no-index --no-deps --no-compile --disable-pip-version-check --target "$dir/site" \
    "$dir"/package/wheel/*.whl && test -e "$dir/site/gjk/libgjk.so" && grep -q '^License: none' "$dir"/site/gjk_exact-*/METADATA
}

readme() {
  awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/python/README.md >"$dir/readme.py"
  sed -n 's/.*# prints: //p' "$dir/readme.py" >"$dir/expected"
  test -s "$dir/expected" && runs "$dir/readme.py" >"$dir/printed" && diff "$dir/expected" "$dir/printed"
}

dispute() {
  runs port/python/examples/dispute.py "$dir/dispute.svg" >"$dir/printed" && cat "$dir/printed" &&
    awk '/certainly apart/ { apart = $1 } /^float32/ { wrong = $2 } END { exit !(apart > 1000 && wrong > 100 && wrong < apart) }' \
      "$dir/printed" && test -s "$dir/dispute.svg"
}

# The roadmap: most motions are free, some touch, and samples miss some of these.
roadmap() {
  runs port/python/examples/roadmap.py tests/data/robot/six.urdf tests/data/robot/six.srdf >"$dir/printed" && cat "$dir/printed" &&
    awk '/motions are free/ { free = $1; touch = $7 } /look free/ { missed = $1 } END { exit !(free > 2000 && touch > 400 && missed > 0) }' \
      "$dir/printed"
}

tidy() {
  python3 -c 'import ast, sys; [ast.parse(open(name).read(), name) for name in sys.argv[1:]]' "$@" &&
    ! grep -nE '.{121}|[[:blank:]]$|	' "$@"
}

check 'make package' sh tests/build/package.sh "$dir" wheel
if "$python" -c 'import pip' 2>/dev/null; then
  check 'pip install' installed
  check 'second opinions' runs tests/check/bind/opinion.py "${GJK_TEST_SEED:-1}"
  check 'the golden hash' runs tests/check/bind/golden.py 150 "$(hash_of GOLDEN_FEW_HASH golden)"
  check 'the golden hash of a scene' runs tests/check/bind/scene_golden.py 500 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
  check "the README's example" readme
  if "$python" -c 'import numpy' 2>/dev/null; then
    check 'the dispute' dispute
    check 'the roadmap' roadmap
    check 'arms in numpy' runs tests/check/bind/arm_behaviour.py "$build/gjk-convert"
  else
    skip 'batches of second opinions' python3-numpy
  fi
else
  skip 'pip install' python3-pip
fi
check 'the files are tidy' tidy port/python/examples/*.py tests/build/*.py tests/measure/bench/report/*.py
finish wheel
