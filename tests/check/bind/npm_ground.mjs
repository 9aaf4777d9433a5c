// What the npm package does around ground of the plane: its kinds, queries, scenes, errors.
import assert from 'node:assert';
import { BodyKind, Constants, Detail, Event, load } from 'gjk-exact';

const UNIT = 65536, { plane } = await load();
const status = (call) => {
  try { call(); } catch (error) { return error.status ?? error.name; }
  return 0;
};
const disc = plane.circle(UNIT / 2), ball = (x, y) => plane.collider(disc, [x, y]);
const forms = { '#': { left: 4, right: 4 }, '/': { left: 0, right: 4 }, '-': { left: 4, right: 4, oneWay: true } };
const level = () => plane.tiles('########      ##', 8, UNIT, forms);

const chain = plane.chain(Array.from({ length: 51 }, (_, i) => [(50 - i) * UNIT, 0]));
const at = 10.5 * UNIT;
assert.ok(chain.within(ball(at, 2 * UNIT), 2 * UNIT) && !chain.within(ball(at, 2 * UNIT), UNIT));
const near = chain.distance(ball(at, UNIT));
assert.ok(near.segment === 39 && near.result.distance === UNIT / 2);
assert.equal(chain.distance(ball(at, -UNIT)), null);
const fall = chain.cast(ball(at, 3 * UNIT), [at, 0]);
assert.ok(fall.segment === 39 && Math.abs(fall.result.restB[1] - UNIT / 2) <= 2);
assert.equal(chain.cast(ball(at, -UNIT), [at, 3 * UNIT]), null);
assert.equal(chain.castRay([UNIT / 2, UNIT], [UNIT / 2, -UNIT]).segment, 49);
assert.equal(chain.castRay([UNIT / 2, -UNIT], [UNIT / 2, UNIT]), null);
assert.ok(chain.within(ball(at, 2 * UNIT), 0, [0, 2 * UNIT]) && !chain.within(ball(at, 2 * UNIT)));
const rake = plane.collider(plane.box(20 * UNIT, UNIT), [25 * UNIT, UNIT]);
let partial = [];
try { chain.contacts(rake, 5); } catch (error) { partial = error.partial; }
assert.ok(partial.length === 16 && partial[0].manifold.count > 0);

const profile = plane.heights([0, 0, null, 100, 100], UNIT, 10);
assert.equal(profile.castRay([3.5 * UNIT, 9 * UNIT], [3.5 * UNIT, -UNIT]).result.pointA[1], 102400);
assert.equal(profile.castRay([1.5 * UNIT, 9 * UNIT], [1.5 * UNIT, -UNIT]), null);
assert.equal(status(() => plane.heights([0, 40000], UNIT)), 'RangeError');
assert.equal(status(() => plane.heights([0, null], UNIT)), Constants.GJK_ERROR_EMPTY);

const grid = level(), [contact] = grid.contacts(ball(2 * UNIT, 1.5 * UNIT - 100));
assert.ok(contact.segment === 4 * 5 + 2 && contact.manifold.contact[0].distance === -100);
const push = () => grid.cast(ball(4 * UNIT, 1.75 * UNIT), [9 * UNIT, 1.75 * UNIT]);
assert.equal(push().segment, 4 * 14 + 3);
grid.cells[14] = 32;
assert.equal(push().segment, 4 * 15 + 3);
assert.equal(status(() => plane.tiles('###', 2, UNIT, forms)), 'RangeError');
assert.equal(status(() => plane.tiles('##', 2, 5, forms)), Constants.GJK_ERROR_SIZE);
assert.equal(status(() => plane.tiles('', 1, UNIT, forms)), Constants.GJK_ERROR_EMPTY);
assert.equal(status(() => plane.collider(grid.shape)), Constants.GJK_ERROR_UNSUPPORTED);
assert.equal(plane.tiles([7, 7], 2, UNIT, { 7: { left: 2, right: 2 } }).castRay([UNIT, UNIT], [UNIT, 0]).result.pointA[1], UNIT / 2);

const ground = level(), scene = plane.scene([ground.shape, disc], { bodies: 2, detail: Detail.CONTACTS }), events = [];
const floor = scene.add(0, { user: 5 });
scene.add(1, { position: [2.5 * UNIT, 1.5 * UNIT - 100], kind: BodyKind.DYNAMIC });
const tick = () => scene.update((report, manifold) => events.push([report.event, report.userA, manifold?.count]));
tick();
assert.equal(scene.castRay([0, 3 * UNIT], [0, 0]).hit.user, 5);
ground.cells[2] = 32;
tick();
scene.refilter(floor);
tick();
assert.deepEqual(events, [[Event.BEGIN, 5, 1], [Event.END, 5, undefined]]);
assert.throws(() => ground.dispose());
scene.dispose();
ground.dispose();
