#!/bin/sh
# The npm package as it is packed and installed: size, types, the golden hashes of pairs and of scenes in space and in the plane,
# what it does around the calls, the layout of structures, the README's example and two peers in lockstep. test_npm.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/npm-test
rm -rf "$dir"
mkdir -p "$dir/user"
dir=$(cd "$dir" && pwd)
user=$dir/user
packed=$dir/package/npm
hash_of() {
  sed -n "s/^#define $1 UINT64_C(0x\(.*\))\$/\1/p" "tests/check/target/$2.h"
}

missing=
have clang || missing="$missing clang"
have wasm-ld || missing="$missing lld"
have node || missing="$missing nodejs"
have npm || missing="$missing npm"
if [ -n "$missing" ]; then
  skip 'the npm package' "${missing# }"
  finish npm
  exit
fi

installed() {
  echo '{ "private": true, "type": "module" }' >"$user/package.json"
  cp tests/check/bind/*.mjs "$user"
  (cd "$user" && npm_config_cache=$dir/cache npm install --offline --no-audit --no-fund "$packed"/gjk-exact-*.tgz) &&
    test -e "$user/node_modules/gjk-exact/gjk.wasm"
}

is_small() {
  bytes=$(wc -c <"$(echo "$packed"/gjk-exact-*.tgz)")
  [ "$bytes" -lt 200000 ] || { echo "$bytes bytes"; return 1; }
}

runs() {
  (cd "$user" && node "$@")
}

other() {
  ! runs "$@"
}

same_layout() {
  sh tests/build/layout.sh "$dir/layout" "$dir/package-api.txt" clang --target=wasm32 "-I$dir/package-amalgamation" |
    grep -v '^gjk_epa_cell' >"$dir/of-c" &&
    awk -v as=layout -f port/bind/javascript.awk "$dir/package-api.txt" "$dir/package-api.txt" >"$dir/of-js" &&
    diff "$dir/of-c" "$dir/of-js"
}

readme() {
  awk '/^```js$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/npm/README.md >"$user/readme.mjs"
  sed -n 's|.*// prints: ||p' "$user/readme.mjs" >"$dir/expected"
  test -s "$dir/expected" && runs readme.mjs >"$dir/printed" && diff "$dir/expected" "$dir/printed"
}

lockstep() {
  cp port/npm/lockstep.mjs "$user" && runs lockstep.mjs >"$dir/printed" && grep -qx 'the same bits true' "$dir/printed"
}

# types NAME: does the program of standard input fit the types?
types() {
  cat >"$user/$1.ts"
  (cd "$user" && tsc --strict --noEmit --target es2020 --module es2020 --moduleResolution node --lib es2020,dom "$1.ts")
}

good_types() {
  types good <<'END'
import { Detail, DistanceResult, GjkError, load } from 'gjk-exact';
export async function play(): Promise<number> {
  const gjk = await load({ bytes: 1 << 22 });
  const a = gjk.collider(gjk.box(1, 2, 3)), b = gjk.collider(gjk.sphere(4), [5, 6, 7]);
  const mine = gjk.create('DistanceResult') as DistanceResult;
  const gap: number = gjk.distance(a, b, mine).pointA[0];
  const scene = gjk.plane.scene([gjk.plane.circle(1)], { bodies: 2, detail: Detail.CONTACTS });
  const body = scene.add(0, { position: [0, 0] });
  scene.update((report, manifold) => { if (manifold !== null) console.log(report.a.slot, manifold.contact[0].pointA[1]); });
  const level = gjk.plane.tiles('##', 2, 4, { '#': { left: 4, right: 4 } });
  const on: number | undefined = level.distance(gjk.plane.collider(gjk.plane.circle(1)))?.result.distance;
  gjk.plane.scene([level.shape], { bodies: 1 }).refilter(body);
  const save: ArrayBuffer = scene.save();
  scene.load(save);
  try { scene.move(body, [1, 2]); } catch (error) { if (error instanceof GjkError) console.log(error.status); }
  return gap + (on ?? 0);
}
END
}

# A shape of the plane is none of space, and a length no text.
bad_types() {
  ! types bad <<'END'
import { load } from 'gjk-exact';
export const made = load().then((gjk) => gjk.collider(gjk.plane.circle(1)));
END
  ! types worse <<'END'
import { load } from 'gjk-exact';
export const made = load().then((gjk) => gjk.sphere('1'));
END
}

is_tidy() {
  node --check "$1" && ! grep -nE '.{141}|[[:blank:]]$|	' "$1"
}

check 'make package' sh tests/build/package.sh "$dir" npm
check 'npm install, by its path' installed
check 'less than 200 KB' is_small
check 'the layout of structures' same_layout
check 'the golden hash' runs npm_golden.mjs 3000 "$(hash_of GOLDEN_HASH golden)"
check 'another set has another hash' other npm_golden.mjs 149 "$(hash_of GOLDEN_FEW_HASH golden)"
check 'the golden hash of a scene' runs npm_scene_golden.mjs 500 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'another match has another hash' other npm_scene_golden.mjs 499 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'the golden hash of a scene of the plane' runs npm_scene_golden.mjs 500 \
  "$(hash_of PLANE_SCENE_GOLDEN_FEW_HASH plane_scene_golden)" plane
check 'errors, records, hulls, saves, memory' runs npm_behaviour.mjs
check 'ground of the plane' runs npm_ground.mjs
check "the README's example" readme
check 'two peers in lockstep' lockstep
if have tsc; then
  check 'a program that fits the types' good_types
  check 'programs that do not' bad_types
else
  skip 'the types' node-typescript
fi
for file in "$packed"/*.js port/npm/*.mjs tests/check/bind/*.mjs; do
  check "$file is tidy" is_tidy "$file"
done
finish npm
