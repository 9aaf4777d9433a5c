#!/bin/sh
# The library in JavaScript, by WebAssembly, in node: the golden hashes of pairs and of a scene, what gjk.js does around the
# calls, little memory and low ceilings on iterations, and the README's examples.
# test_javascript.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/javascript-test
golden=$(sed -n 's/^#define GOLDEN_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/golden.h)
few=$(sed -n 's/^#define GOLDEN_FEW_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/golden.h)
scene_golden=$(sed -n 's/^#define SCENE_GOLDEN_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/scene_golden.h)
rm -rf "$dir"
mkdir -p "$dir"

missing=
have clang || missing="$missing clang"
have wasm-ld || missing="$missing lld"
have node || missing="$missing nodejs"
if [ -n "$missing" ]; then
  skip 'JavaScript' "${missing# }"
  finish javascript
  exit
fi

# The block of JavaScript in port/README.md, in a folder with the module, prints what its comments '// prints: TEXT' say.
readme() {
  awk '/^```js$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/README.md >"$dir/readme.js"
  cp port/wasm/gjk.js "$dir"
  sed -n 's|.*// prints: ||p' "$dir/readme.js" >"$dir/expected"
  (cd "$dir" && node readme.js >printed && test -s expected && diff expected printed)
}

# No browser and no node is asked for anything: the module has no imports.
has_no_imports() {
  node -e 'process.exitCode = WebAssembly.Module.imports(new WebAssembly.Module(require("fs").readFileSync(process.argv[1]))).length' \
    "$dir/gjk.wasm"
}

# What the library refuses, gjk.js throws.
throws() {
  node -e '
    const { gjkLoad, GjkError } = require(require("path").resolve("port/wasm/gjk.js"));
    const refused = (call) => {
      try { call(); } catch (error) { return error instanceof GjkError ? error.status : error; }
      return 0;
    };
    gjkLoad(require("fs").readFileSync(process.argv[1])).then((gjk) => {
      const ball = gjk.sphere(65536);
      const found = [() => gjk.sphere(-1), () => gjk.hull([]), () => gjk.pose(ball, [0, 0, 0], [0, 0, 0, 5]),
        () => gjk.contacts(ball, ball, -1), () => gjk.sphere(1)].map(refused);
      console.log(found.join(" "));
      process.exitCode = found.join(" ") === "-3 -1 -7 -3 0" ? 0 : 1;
    });' "$dir/gjk.wasm"
}

is_tidy() {
  node --check "$1" && ! grep -nE '.{121}|[[:blank:]]$|	' "$1"
}

other_bits() {
  ! node tests/check/bind/golden.js "$dir/gjk.wasm" 149 "$few"
}

other_match() {
  ! node tests/check/bind/scene_golden.js "$dir/gjk.wasm" 499 "$scene_golden"
}

# With modules of 2 MB and low ceilings, too.
scenes() {
  for max in 1 3; do
    sh port/wasm/build.sh "$dir/ceiling-$max.wasm" -O0 "-DGJK_ITERATIONS_MAX=$max" -Wl,--max-memory=2097152 || return 1
  done
  node tests/check/bind/scene_behaviour.js "$dir/gjk.wasm" "$dir"/ceiling-[13].wasm
}

check 'the module is built' wasm_library "$dir/gjk.wasm"
check 'it has no imports' has_no_imports
check 'the golden hash' node tests/check/bind/golden.js "$dir/gjk.wasm" 3000 "$golden"
check 'another set has another hash' other_bits
check 'the golden hash of a scene' node tests/check/bind/scene_golden.js "$dir/gjk.wasm" 10000 "$scene_golden"
check 'another match has another hash' other_match
check 'scenes, hulls, little memory, low ceilings' scenes
check "the README's examples" readme
check 'errors are thrown' throws
for file in port/wasm/*.js tests/check/bind/*.js; do
  check "$file is tidy" is_tidy "$file"
done
finish javascript
