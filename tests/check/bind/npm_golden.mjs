// The golden set of queries of tests/check/target/golden.c through the npm package: npm_golden.mjs PAIRS HASH. Exits with 0 if
// the hash over so many pairs is HASH, in hexadecimal digits.
import { load } from 'gjk-exact';
import { Hash, Random, along } from './npm_common.mjs';

const VERTICES = 16, UPRIGHT = [0, 0, 0, 1 << 30];
const gjk = await load({ cells: 66 });  // GJK_EPA_CELLS(20): too few for some
const hash = new Hash(), random = new Random(2026n);

function parts(call) {
  try {
    return [0, call()];
  } catch (error) {
    return [error.status, error.partial];
  }
}

function body(size, reach) {
  const kind = [0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7][random.below(11)];
  const [x, y, z] = [0, 0, 0].map(() => random.range(1, size));
  const count = kind === 2 ? 3 : 4 + random.below(VERTICES - 3);
  const grid = random.below(4) === 0 ? (size >> 1) + 1 : 1;  // coarse: ties, and parallel faces
  const vertices = Array.from({ length: count }, () => random.vector(size).map((c) => Math.trunc(c / grid) * grid));
  const radius = random.below(4) === 0 ? random.range(0, size >> 1) : 0;
  let rotation = UPRIGHT;
  if (random.below(4) !== 0) {
    rotation = gjk.normalize([1000, 1000, 1000, 1001].map((high) => random.range(-1000, high)));
    hash.mix(0);
  }
  const position = random.vector(reach), baked = random.below(2) === 0;
  hash.mix(0, 0);  // of gjk_collider_init and gjk_collider_pose
  const shape = [
    () => gjk.sphere(radius), () => gjk.capsule(radius, z), () => gjk.triangle(vertices, radius),
    () => gjk.box(x, y, z, radius), () => gjk.hull(vertices, radius), () => gjk.cylinder(x, z, radius),
    () => gjk.cone(x, z, radius), () => gjk.ellipsoid(x, y, z, radius),
  ][kind]();
  return gjk.collider(shape, position, rotation, baked);
}

function distance(a, b, cache) {
  const [status, r] = parts(() => gjk.distance(a, b, undefined, cache));
  hash.mix(status, r.intersecting, r.saturated, r.distance);
  if (!r.intersecting) {
    hash.mix(...r.pointA, ...r.pointB, ...r.normal);
  }
  return r;
}

function decision(call) {
  const [status, d] = parts(call);
  hash.mix(status, d.yes);
}

function withinUntil(a, b, most, iterations) {
  const [status, r] = parts(() => gjk.withinUntil(a, b, most, iterations));
  hash.mix(status, r.answer);
}

function distanceUntil(a, b, iterations, error) {
  const [status, r] = parts(() => gjk.distanceUntil(a, b, iterations, error));
  hash.mix(status, r.intersecting, r.distance, r.lower, r.upper);
  if (!r.intersecting) {
    hash.mix(...r.pointA);
  }
}

function penetration(a, b, cache) {
  const [status, r] = parts(() => gjk.penetration(a, b, undefined, cache));
  hash.mix(status, r.intersecting);
  if (r.intersecting) {
    hash.mix(r.depth, r.lower, r.upper, ...r.pointA, ...r.pointB, ...r.normal);
  }
}

function contacts(a, b, margin) {
  const [status, m] = parts(() => gjk.contacts(a, b, margin));
  hash.mix(status, m.count);
  for (const c of m.contact.slice(0, m.count)) {
    hash.mix(...c.pointA, ...c.pointB, c.distance, c.id);
  }
}

function pair() {
  const size = 1 << (3 + random.below(23)), far = random.below(8) === 0, reach = far ? 2 ** 31 - 1 : 2 * size;
  const a = body(size, reach), b = body(size, reach), cache = gjk.create('Cache');
  let r = distance(a, b, null);
  decision(() => gjk.intersect(a, b));
  decision(() => gjk.within(a, b, r.distance));
  r = distance(a, b, cache);
  penetration(a, b, cache);
  contacts(a, b, 0);
  if (!r.intersecting && !far) {
    const by = r.distance + random.range(-2, 2);
    b.move(Array.from(b.position, (p, i) => p - along(r.normal[i], by)));
    hash.mix(0);
    r = distance(a, b, cache);
    decision(() => gjk.intersect(a, b, undefined, cache));
    decision(() => gjk.within(a, b, 1));
    withinUntil(a, b, 1 + (size >> 5), 1);
    withinUntil(a, b, r.distance, 2);
    distanceUntil(a, b, 2, 0);
    distanceUntil(a, b, 0, 1 + (size >> 4));
    penetration(a, b, null);
    contacts(a, b, size >> 3);
  }
  gjk.release(cache);
  for (const one of [a, b]) {
    one.dispose();
    one.shape.dispose();
  }
}

for (let i = 0; i < +process.argv[2]; i++) {
  pair();
}
console.log(hash.text());
process.exitCode = hash.text() === process.argv[3] ? 0 : 1;
