// What gjk.js does around scenes and hulls: reports, full tables, wrong handles, little memory, saves, lifetimes, low
// ceilings on iterations: scene_behaviour.js GJK.WASM CEILING.WASM...
//
// The modules with low ceilings have little memory. Exits with 0 if all is as it should be.
'use strict';

const fs = require('fs');
const path = require('path');
const { gjkLoad, GjkError } = require(path.resolve('port/wasm/gjk.js'));
const { Random } = require('./random.js');

const Q16 = 65536, HALF = 32768, SEED = 9, ROUNDING = 4;
const CAPACITY = -5, ROTATION = -7, RANGE = -8, ITERATION_LIMIT = -10, BODY_ID = -13, CORRUPT = -15;
let failed = 0;

function check(condition, what) {
  if (!condition) {
    failed++;
    console.log('failed: ' + what);
  }
}

// What a call throws: a status, an Error, or nothing.
function thrown(call) {
  try {
    call();
  } catch (error) {
    return error instanceof GjkError ? error.status : error;
  }
  return undefined;
}

function refuses(status, what, ...calls) {
  for (const call of calls) {
    const found = thrown(call);
    check(found === status, what + ': ' + found + ' from ' + call);
  }
}

function refusesAny(what, ...calls) {
  for (const call of calls) {
    check(thrown(call) instanceof Error, what + ': ' + call);
  }
}

const same = (a, b) => a.slot === b.slot && a.generation === b.generation;

// A scene of a floor, number 0; a crate and a ball may fall on it.
function pile(gjk, config = {}) {
  const shapes = [gjk.box(9 * Q16, 9 * Q16, HALF), gjk.box(HALF, HALF, HALF), gjk.sphere(HALF)];
  const scene = gjk.scene(shapes, { bodies: 8, detail: 'contacts', ...config });
  return { scene, shapes, floor: scene.add(0) };
}

const above = (z) => ({ position: [0, 0, z], kind: 'dynamic' });

function reports(gjk) {
  const { scene, floor } = pile(gjk, { persist: true });
  const crate = scene.add(1, above(0.9 * Q16 | 0));
  const [begin] = scene.update();
  check(begin.event === 'begin' && same(begin.a, floor) && same(begin.b, crate), 'begin');
  check(begin.contacts.points.length === 4 && begin.distance === begin.contacts.points[0].distance, 'contacts');
  check(scene.update()[0].event === 'persist', 'persist');
  scene.sleep(crate);
  check(scene.get(crate).asleep && scene.update().length === 0, 'asleep');
  scene.wake(crate);
  scene.remove(crate);
  const [end] = scene.update();
  check(end.event === 'end' && same(end.b, crate) && end.contacts.points.length === 0, 'end');
  const many = gjk.scene([gjk.sphere(Q16)], { bodies: 20, pairs: 200 });
  for (let i = 0; i < 20; i++) {
    many.add(0, { kind: 'dynamic' });
  }
  const found = many.update().map((report) => 100 * report.a.slot + report.b.slot);
  check(found.length === 190 && found.every((n, i) => i === 0 || n > found[i - 1]), '190 reports in order');
  const bullet = scene.add(2, { position: [5 * Q16, 0, 5 * Q16], kind: 'dynamic' });
  scene.setMotion(bullet, 'fast');
  scene.update();
  scene.move(bullet, [5 * Q16, 0, -5 * Q16]);
  const [impact] = scene.update();
  check(impact.event === 'impact' && impact.fraction > 0 && same(impact.a, bullet), 'impact');
  scene.setUser(bullet, 4000000000);
  scene.setFilter(bullet, 2, 4);
  const state = scene.get(bullet);
  check(state.user === 4000000000 && state.category === 2 && state.mask === 4 && state.motion === 'fast', 'state');
  const ray = (filter) => scene.castRay([0, 0, 9 * Q16], [0, 0, -9 * Q16], filter);
  check(same(ray().body, floor) && ray().point[2] === HALF, 'a ray');
  check(ray({ ignore: floor }) === null && ray({ category: 2 }).part === 0 && ray({ mask: 2 }) === null, 'a filter');
}

function refused(gjk) {
  const { scene, shapes, floor } = pile(gjk, { bodies: 2, pairs: 1, motions: 0 });
  const stale = scene.add(1);
  scene.remove(stale);
  const crate = scene.add(1, above(0.9 * Q16 | 0)), before = scene.hash();
  refuses(CAPACITY, 'a full scene', () => scene.add(1), () => scene.add(1, { slot: 2 }),
    () => scene.setMotion(crate, 'fast'));
  const wrong = [stale, { slot: 0, generation: 0 }, { slot: 0, generation: 3 }, { slot: 1 << 20, generation: 1 }, {}];
  for (const id of wrong) {
    refuses(BODY_ID, 'a wrong id', () => scene.remove(id), () => scene.sleep(id), () => scene.get(id),
      () => scene.move(id, [0, 0, 0]), () => scene.setUser(id, 1));
  }
  refuses(BODY_ID, 'a slot that is taken', () => scene.add(1, { slot: 0 }));
  refuses(ROTATION, 'a pose that is none', () => scene.move(crate, [0, 0, 0], [0, 0, 0, 5]));
  refuses(RANGE, 'a shape or part that is not there', () => scene.setShape(crate, 1, 0),
    () => scene.setShape(crate, 0, 3));
  refusesAny('no number, or no name', () => scene.move(crate, [0.5, 0, 0]), () => scene.move(crate, [2 ** 32, 0, 0]),
    () => scene.add(65536), () => scene.add(1, { mask: 2 ** 32 }), () => scene.add(1, { kind: 'heavy' }),
    () => scene.setMotion(crate, 'quick'), () => scene.setShape(crate, 0, 65536),
    () => scene.move(crate, [0, 0]), () => scene.castRay([0, 0, 0], [0, 0]), () => gjk.hullBuild([[0, 0]]));
  check(scene.hash() === before, 'what is refused changes nothing');
  refuses(RANGE, 'a configuration', () => gjk.scene(shapes, { bodies: 0 }),
    () => gjk.scene(shapes, { bodies: 1, pairs: 0 }), () => gjk.scene(shapes, { bodies: (1 << 20) + 1 }));
  refusesAny('a configuration', () => gjk.scene(shapes, { bodies: -1e10 }), () => gjk.scene([12345], { bodies: 1 }));
  const crowd = gjk.scene([shapes[2]], { bodies: 3, pairs: 1 });
  const bodies = [0, 1, 2].map((z) => crowd.add(0, above(z * HALF)));
  refuses(CAPACITY, 'no room for pairs', () => crowd.update());
  crowd.remove(bodies[0]);
  check(crowd.update().length === 1 && same(floor, scene.update()[0].a), 'an update after that');
}

function saves(gjk) {
  const { scene, shapes } = pile(gjk, { persist: true });
  const crate = scene.add(1, above(0.9 * Q16 | 0));
  scene.update();
  const save = scene.save(), before = scene.hash();
  const play = () => {
    for (let i = 0; i < 3; i++) {
      scene.move(crate, [0, 0, scene.get(crate).position[2] + 9000]);
      scene.update();
    }
    return scene.hash();
  };
  const played = play();
  scene.load(save);
  check(scene.hash() === before && played !== before && play() === played, 'back and on again');
  refuses(CAPACITY, 'another size', () => scene.load(save.slice(4)), () => scene.load(new Uint8Array(save.length + 4)));
  refuses(CORRUPT, 'no scene', () => scene.load(new Uint8Array(save.length)));
  for (let at = 0; at < save.length; at += 97) {
    const broken = save.slice();
    broken[at] ^= 1;
    check(thrown(() => scene.load(broken)) < 0, 'byte ' + at + ' is changed');
  }
  check(scene.hash() === played, 'after saves that are none');
  const fewer = gjk.scene(shapes.slice(0, 1), { bodies: 8, detail: 'contacts', persist: true });
  refuses(RANGE, 'fewer shapes', () => fewer.load(save));
}

// Shapes that are released while scenes have them; what is released twice; memory that comes back.
function lifetimes(gjk) {
  const round = (release) => {
    const cube = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, i >> 1 & 1, i >> 2].map((bit) => (2 * bit - 1) * Q16));
    const shapes = [gjk.hullBuild(cube), gjk.hullBuild(cube)];
    const scenes = [0, 1].map(() => gjk.scene(shapes, { bodies: 2, detail: 'contacts' }));
    release(shapes);
    const litter = [0, 1, 2, 3].map(() => gjk.hullBuild(cube.map((vertex) => vertex.map((n) => n * 3))));
    for (const scene of scenes) {
      scene.add(0);
      scene.add(1, { position: [0, 0, 1.9 * Q16 | 0], kind: 'dynamic' });
      const [report] = scene.update();
      check(report.contacts.points.length === 4, 'hulls that only scenes have');
      scene.release();
      refusesAny('a scene that is released', () => scene.update(), () => scene.release());
    }
    litter.forEach((shape) => gjk.release(shape));
    return shapes;
  };
  const early = (shapes) => shapes.forEach((shape) => gjk.release(shape));
  const [shape] = round(early);
  refusesAny('a shape that is released', () => gjk.release(shape), () => gjk.scene([shape], { bodies: 1 }),
    () => gjk.polyhedron(shape));
  const size = gjk.bytes().length;
  for (let i = 0; i < 200; i++) {
    round(early);
    early(round(() => {}));
  }
  check(gjk.bytes().length === size, 'memory comes back');
}

function hulls(gjk) {
  const points = [];
  for (const x of [0, 5, 9]) for (const y of [0, 9]) for (const z of [0, 9]) points.push([x, y, z]);
  const { vertices, faces } = gjk.polyhedron(gjk.hullBuild(points, 5));
  check(vertices.length === 8 && faces.length === 6 && faces.every((face) => face.length === 4), 'the hull of a box');
  const circle = Array.from({ length: 300 }, (_, i) => [i, i * i, 0]), flat = gjk.polyhedron(gjk.hullBuild(circle));
  check(flat.vertices.length === 300 && flat.faces.length > 2, 'faces are cut');
  check(flat.faces.every((face) => face.length <= 12), 'small enough');
  check(flat.faces.flat().length === 600 + 2 * (flat.faces.length - 2), 'their corners');
  const line = gjk.polyhedron(gjk.hullBuild([[0, 0, 0], [1, 1, 1], [2, 2, 2]]));
  check(line.vertices.length === 2 && line.faces.length === 0, 'points in a line');
  check(gjk.polyhedron(gjk.hull(points)).faces.length === 0, 'a hull without faces');
  refuses(-4, 'no points', () => gjk.hullBuild([]));
  refuses(-2, 'points too far apart', () => gjk.hullBuild([[0, 0, 0], [1 << 30, 0, 0]]));
  refuses(-3, 'a radius below 0', () => gjk.hullBuild(points, -1));
  refuses(RANGE, 'too many points', () => gjk.hullBuild(new Array(65536).fill([0, 0, 0])));
  refusesAny('no integers', () => gjk.hullBuild([[0.5, 0, 0]]));
}

// Scenes and hulls of growing size until the memory is used up: an error, and what there is goes on.
function little(gjk) {
  const { scene } = pile(gjk), before = scene.hash();
  const full = (make) => {
    for (let size = 16; size <= 65535; size *= 2) {
      const error = thrown(() => make(size));
      if (error !== undefined) {
        return error === CAPACITY || error.message === 'out of memory';
      }
    }
    return false;
  };
  check(full((bodies) => gjk.scene([gjk.point()], { bodies })), 'scenes fill the memory');
  check(full((count) => gjk.hullBuild(Array.from({ length: count }, (_, i) => [i, i * i & 4095, i & 63]))), 'hulls do');
  check(thrown(() => { for (;;) gjk.point(); }) === CAPACITY, 'points do');
  const save = thrown(() => scene.load(scene.save()));
  check((save === undefined || save.message === 'out of memory') && scene.hash() === before, 'the scene goes on');
}

// Balls around a drum: what touches is not missed, and what is not settled is counted.
function ceiling(gjk, save) {
  const random = new Random(SEED), drum = gjk.cylinder(Q16, Q16), ball = gjk.sphere(HALF);
  const scene = gjk.scene([drum, ball], { bodies: 2, detail: 'distance', persist: true });
  scene.add(0);
  const moved = scene.add(1, { kind: 'dynamic' });
  let near = 0, unsettled = 0, open = 0;
  for (let i = 0; i < 300; i++) {
    const at = random.vector(3 * Q16);
    const exact = Math.hypot(Math.max(Math.hypot(at[0], at[1]) - Q16, 0), Math.max(Math.abs(at[2]) - Q16, 0)) - HALF;
    scene.move(moved, at);
    gjk.pose(ball, at);
    const found = scene.update().filter((report) => report.event !== 'end');
    near += found.length;
    unsettled += scene.stats().unsettled;
    check(found.length === 1 || exact > 0, 'seed ' + SEED + ': a ball that touches at ' + at);
    const bound = Math.max(exact, 0) + ROUNDING;
    check(found.every((report) => report.distance <= bound), 'seed ' + SEED + ': the bound at ' + at);
    const status = thrown(() => gjk.distance(drum, ball));
    check(status === undefined || status === ITERATION_LIMIT, 'seed ' + SEED + ': status at ' + at);
    open += status === ITERATION_LIMIT;
  }
  check(near > 10 && open > 5, near + ' near, ' + open + ' open, ' + unsettled + ' unsettled');
  refuses(CORRUPT, 'a save of another ceiling', () => scene.load(save));
}

async function main(file, ...ceilings) {
  const load = (name) => gjkLoad(fs.readFileSync(name));
  const gjk = await load(file);
  for (const part of [reports, refused, saves, lifetimes, hulls]) {
    part(gjk);
  }
  little(await load(ceilings[0]));
  const usual = gjk.scene([gjk.point(), gjk.point()], { bodies: 2, detail: 'distance', persist: true }).save();
  for (const name of ceilings) {
    ceiling(await load(name), usual);
  }
  process.exitCode = failed === 0 ? 0 : 1;
}

main(...process.argv.slice(2));
