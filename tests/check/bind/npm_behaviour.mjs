// What the npm package does around the calls: errors, records, hulls, casts, saves, memory that does not grow.
import assert from 'node:assert';
import * as gjk from 'gjk-exact';

const { BodyKind, BodyMotion, Constants, Detail, Event, GjkError, load } = gjk;
const space = await load(), { plane } = space;
const status = (call) => { try { call(); } catch (error) { return error instanceof GjkError ? error.status : error.name; } return 0; };
const UNIT = 65536;

// The layout of each record is that of the module.
for (const of of Object.values(gjk)) {
  if (of.inC !== undefined) {
    const text = space.module.allocate(64);
    new TextEncoder().encodeInto(of.inC, space.memory.u8.subarray(text, text + 63));
    assert.equal(space.call.size_of(text), of.bytes, of.inC);
    space.module.exports.gjk_port_release(text);
  }
}

assert.equal(status(() => space.sphere(-1)), Constants.GJK_ERROR_NEGATIVE);
assert.equal(status(() => space.sphere(0.5)), 'RangeError');
assert.equal(status(() => space.hull([])), Constants.GJK_ERROR_EMPTY);
assert.equal(status(() => space.hull([[1, 2]])), 'RangeError');
const box = space.box(UNIT, UNIT, UNIT), a = space.collider(box), b = space.collider(box, [3 * UNIT, 0, 0]);
assert.equal(status(() => a.pose([0, 0, 0], [0, 0, 0, 5])), Constants.GJK_ERROR_ROTATION);
assert.equal(status(() => box.dispose()), 'Error');
assert.match(new GjkError(-7, null).message, /GJK_ERROR_ROTATION/);

// A record of one's own stays; the query's is written again.
const mine = space.create('DistanceResult'), first = space.distance(a, b, mine);
assert.ok(first === mine && first.distance === UNIT && first.pointA instanceof Int32Array && first.pointA[0] === UNIT);
space.check(a, b, mine);
mine.distance++;
assert.equal(status(() => space.check(a, b, mine)), Constants.GJK_ERROR_UNPROVEN);
assert.equal(space.distance(a, b), space.distance(a, a));
assert.equal(space.aabb(a).upper[2], UNIT);
space.check(a, b, space.within(a, b, UNIT), UNIT);

// Hulls of points: inner ones go, faces come, contacts know them.
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [0, 1, 2].map((bit) => (i >> bit & 1 ? UNIT : -UNIT)));
const hull = space.hullOf([...corners, [0, 0, 0], ...corners, [5, UNIT, 7]]), on = space.collider(hull, [0, 0, 2 * UNIT], undefined, true);
assert.equal(hull.record.count, 8);
const contacts = space.contacts(a, on);
assert.ok(contacts.count === 4 && contacts.normal[2] === 1 << 30 && contacts.contact[0].distance === 0);
assert.equal(status(() => space.hullOf([])), Constants.GJK_ERROR_EMPTY);
on.move([0, 0, 2 * UNIT - 100]);
const depth = space.penetration(a, on);
assert.equal(depth.depth, 100);
space.check(a, on, depth);
assert.equal(space.signedDistance(a, on).distance, -100);

const cast = space.cast(a, b, null, [0, 0, 0]);
space.checkCast(a, b, null, [0, 0, 0], 0, cast);
assert.ok(cast.hit && cast.restB[0] === 2 * UNIT);
assert.equal(space.castRay(a, [5 * UNIT, 0, 0], [0, 0, 0]).pointA[0], UNIT);
const still = { from: { position: [0, 0, 0] } };
const impact = space.timeOfImpact(a, still, b, { from: { position: [3 * UNIT, 0, 0] }, to: { position: [0, 0, 0] } });
assert.ok(impact.hit && impact.lower > 1 << 28);
const disc = plane.circle(UNIT), c = plane.collider(disc), d = plane.collider(disc, [3 * UNIT, 0]);
assert.equal(plane.distance(c, d).pointB[0], 2 * UNIT);
assert.ok(plane.timeOfImpact(c, { from: { position: [0, 0] } }, d, { from: { position: [3 * UNIT, 0] }, to: { position: [0, 0] } }).hit);

// Scenes: fast bodies, rays, words of a pair, saves.
const scene = space.scene([box, space.sphere(UNIT / 2)], { bodies: 4, parts: 6, detail: Detail.CONTACTS, persist: true, pairWords: 2,
  motions: 4, workspaceCells: 66 });
const wall = scene.add(0);
const ball = scene.add([1, { shape: 1, position: [0, 0, UNIT] }], { position: [4 * UNIT, 0, 0], kind: BodyKind.DYNAMIC });
scene.setMotion(ball, BodyMotion.FAST);
scene.setUser(ball, 0xFFFFFFFF);
assert.equal(scene.get(ball).user, 0xFFFFFFFF);
scene.update(() => assert.fail());
const before = scene.save(), events = [];
const fly = () => {
  scene.move(ball, [-4 * UNIT, 0, 0]);
  scene.update((report) => events.push([report.event, report.a.slot, report.b.slot, report.fraction, report.userA, report.userB]));
  return scene.hash();
};
const hash = fly();
scene.load(before);
assert.equal(fly(), hash);
assert.ok(events.length === 2 && events[0][0] === Event.IMPACT && events[0][4] === 0xFFFFFFFF && events[0][5] === 0);
assert.deepEqual(events[0], events[1]);
scene.move(ball, [0, UNIT * 1.5, 0]);
let seen = 0;
scene.update((report, manifold, words) => {
  if (words !== null) {
    seen += manifold.count;
    words[0] = 7;
  }
});
scene.update((report, manifold, words) => { assert.equal(words[0], 7); });
assert.ok(seen > 0);
scene.seal();
const sealed = scene.save(), there = scene.hash();
scene.load(before);
scene.open(sealed);
assert.equal(scene.hash(), there);
new Uint8Array(sealed)[90] ^= 1;
assert.equal(status(() => scene.open(sealed)), Constants.GJK_ERROR_CORRUPT);
assert.equal(scene.hash(), there);
const ray = scene.castRay([0, 0, 9 * UNIT], [0, 0, 0], { ignore: ball });
assert.ok(ray.hit.body.slot === wall.slot && ray.result.pointA[2] === UNIT);
assert.equal(scene.castRay([0, 0, 9 * UNIT], [0, 9 * UNIT, 9 * UNIT]), null);
assert.equal(scene.cast(space.collider(box, [0, -9 * UNIT, 0]), [0, 0, 0]).hit.body.slot, wall.slot);
assert.equal(scene.within(a, 0).length, 3);
assert.equal(scene.stats().bodies, 2);
scene.remove(wall);
assert.equal(status(() => scene.get(wall)), Constants.GJK_ERROR_BODY_ID);
scene.dispose();

// Memory that is used up is an error, and what was given back can be had again.
const small = await load({ bytes: 700000, cells: 66 });
const held = [];
assert.equal(status(() => { for (;;) held.push(small.scene([], { bodies: 100 })); }), 'Error');
const { buffer } = small.memory;
held.forEach((one) => one.dispose());
for (let i = 0; i < 1000; i++) {
  small.scene([], { bodies: 100 }).dispose();
}
assert.ok(buffer.byteLength > 0 && held.length > 0);
