// The library in JavaScript, over gjk.wasm. Lengths are integers, 65536 to a unit; unit vectors and quaternions have
// 2^30. So every answer has the bits that it has anywhere else. Works as a plain script, and with require().
//
//     const gjk = await gjkLoad(bytes);            // an ArrayBuffer or Uint8Array with gjk.wasm
//     const crate = gjk.box(32768, 32768, 32768), ball = gjk.sphere(16384);
//     gjk.pose(ball, [98304, 0, 0]);
//     gjk.distance(crate, ball);             // {intersecting: false, distance: 49152, pointA: [32768, 0, 0], ...}
'use strict';

class GjkError extends Error {
  constructor(status) {
    super('gjk_status ' + status);
    this.status = status;
  }
}

async function gjkLoad(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  return new Gjk(instance.exports);
}

class Gjk {
  // exports: of a module that port/wasm/build.sh has made.
  constructor(exports) {
    this.exports = exports;
    this.shapes = new Set();
  }

  // Memory as numbers. It may move when the module allocates, so take it anew each time.
  bytes() {
    return new Uint8Array(this.exports.memory.buffer);
  }

  words() {
    return new Int32Array(this.exports.memory.buffer);
  }

  // Text to the module, UTF-8 with a zero at its end. The memory is the caller's to release.
  putText(text) {
    const bytes = new TextEncoder().encode(text);
    const at = this.exports.gjk_port_allocate(bytes.length + 1);
    if (at === 0) {
      throw new Error('out of memory');
    }
    this.bytes().set(bytes, at);
    this.bytes()[at + bytes.length] = 0;
    return at;
  }

  getText(at) {
    const bytes = this.bytes();
    return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
  }

  // Shapes stand at the origin until they are posed. Each takes memory, until release().
  point() { return this.shape(0, [0, 0, 0], 0); }
  sphere(radius) { return this.shape(0, [0, 0, 0], radius); }
  segment(half) { return this.shape(1, [0, 0, half], 0); }
  capsule(radius, half) { return this.shape(1, [0, 0, half], radius); }
  box(x, y, z, convexRadius = 0) { return this.shape(2, [x, y, z], convexRadius); }
  triangle(vertices, convexRadius = 0) { return this.shape(3, [0, 0, 0], convexRadius, vertices); }
  hull(vertices, convexRadius = 0) { return this.shape(4, [0, 0, 0], convexRadius, vertices); }
  cylinder(radius, half, convexRadius = 0) { return this.shape(5, [radius, radius, half], convexRadius); }
  cone(radius, half, convexRadius = 0) { return this.shape(6, [radius, radius, half], convexRadius); }
  ellipsoid(x, y, z, convexRadius = 0) { return this.shape(7, [x, y, z], convexRadius); }

  // kind as in gjk_wasm.h; vertices: a list of [x, y, z].
  shape(kind, size, convexRadius, vertices = []) {
    return this.keep(this.lend([numbersOf(vertices)], (list) =>
      this.exports.gjk_wasm_collider(kind, ...size, convexRadius, list, vertices.length)));
  }

  // The convex hull of points in any order, exactly, with its faces.
  hullBuild(points, convexRadius = 0) {
    return this.keep(this.lend([numbersOf(points)], (list) =>
      this.exports.gjk_wasm_hull_build(list, points.length, convexRadius)));
  }

  // Of a hull: {vertices, faces}; faces: the numbers of each one's vertices, none for a hull that was made without.
  polyhedron(shape) {
    this.exports.gjk_wasm_polyhedron(this.known(shape));
    const [vertices, count, faces, corner, end] = this.report();
    const memory = this.exports.memory.buffer, ends = Array.from(new Uint16Array(memory, end, faces));
    const numbers = new Int32Array(memory, vertices, 3 * count);
    const corners = new Uint16Array(memory, corner, ends[faces - 1] || 0);
    return {
      vertices: Array.from({ length: count }, (_, i) => Array.from(numbers.subarray(3 * i, 3 * i + 3))),
      faces: ends.map((last, i) => Array.from(corners.subarray(i > 0 ? ends[i - 1] : 0, last))),
    };
  }

  // Scenes that have the shape keep its memory until they are released.
  release(shape) {
    this.exports.gjk_wasm_release(this.known(shape));
    this.shapes.delete(shape);
  }

  // Calls a function with lists of integers in the module's memory, 0 for an empty one.
  lend(lists, call) {
    const { gjk_port_allocate: allocate, gjk_port_release: release } = this.exports, lent = [];
    try {
      for (const list of lists) {
        lent.push(list.length > 0 ? allocate(4 * list.length) : 0);
        if (lent[lent.length - 1] === 0 && list.length > 0) {
          throw new Error('out of memory');
        }
        this.words().set(integers(list, -(2 ** 31), 2 ** 32 - 1), lent[lent.length - 1] / 4);
      }
      return call(...lent);
    } finally {
      lent.forEach(release);
    }
  }

  // What a call has made, or the status that stands in its place.
  made(address) {
    if (address === 0) {
      throw new GjkError(this.report()[0]);
    }
    return address;
  }

  keep(shape) {
    this.shapes.add(this.made(shape));
    return shape;
  }

  known(shape) {
    if (!this.shapes.has(shape)) {
      throw new Error('no shape, or released');
    }
    return shape;
  }

  // Many bodies: see Scene. shapes: all that its bodies may have, which name them by their places in this list.
  scene(shapes, config) {
    return new Scene(this, shapes, config);
  }

  pose(shape, position, quaternion = [0, 0, 0, 1 << 30]) {
    this.check(this.exports.gjk_wasm_pose(shape, ...position, ...quaternion));
  }

  intersect(a, b) {
    this.check(this.exports.gjk_wasm_intersect(a, b));
    return { intersecting: this.report()[0] !== 0, iterations: this.report()[1] };
  }

  // Apart: distance, points, normal. proven: the certificate has been checked in integers; curved shapes have none.
  distance(a, b) {
    this.check(this.exports.gjk_wasm_distance(a, b));
    return this.separation('distance');
  }

  // Overlapping: depth, points, normal.
  penetration(a, b) {
    this.check(this.exports.gjk_wasm_penetration(a, b));
    return this.separation('depth');
  }

  separation(length) {
    const r = this.report(), answer = { intersecting: r[0] !== 0, iterations: r[11], proven: r[12] !== 0 };
    if (answer.intersecting === (length === 'depth')) {
      answer[length] = r[1];
      answer.pointA = r.slice(2, 5);
      answer.pointB = r.slice(5, 8);
      answer.normal = r.slice(8, 11);
    }
    return answer;
  }

  contacts(a, b, margin = 0) {
    this.check(this.exports.gjk_wasm_contacts(a, b, margin));
    return this.manifold(this.report());
  }

  manifold(r) {
    const points = [];
    for (let i = 0, at = 6; i < r[0]; i++, at += 8) {
      points.push({ pointA: r.slice(at, at + 3), pointB: r.slice(at + 3, at + 6), distance: r[at + 6], id: r[at + 7] });
    }
    return { normal: r.slice(1, 4), features: r.slice(4, 6), points };
  }

  // B moves in a straight line to the position `to`. fraction: of 2^30.
  cast(a, b, to, margin = 0) {
    this.check(this.exports.gjk_wasm_cast(a, b, ...to, margin));
    const r = this.report();
    if (r[0] === 0) {
      return { hit: false, iterations: r[14] };
    }
    return { hit: true, fraction: r[1], pointA: r.slice(2, 5), pointB: r.slice(5, 8), normal: r.slice(8, 11),
      restB: r.slice(11, 14), iterations: r[14] };
  }

  report() {
    const at = this.exports.gjk_wasm_report() / 4;
    return Array.from(this.words().subarray(at, at + 82));
  }

  check(status) {
    if (status !== 0) {
      throw new GjkError(status);
    }
  }
}

const UPRIGHT = [0, 0, 0, 1 << 30];
const KINDS = ['static', 'kinematic', 'dynamic'], DETAILS = ['touch', 'distance', 'depth', 'contacts', 'sensor'];
const EVENTS = ['', 'begin', 'persist', 'end', 'impact'], MOTIONS = ['notKept', 'kept', 'fast'];
const [REMOVE, SLEEP, WAKE, SET_MOTION, SET_SHAPE, SET_FILTER, SET_USER] = [0, 1, 2, 3, 4, 5, 6];

function numberOf(names, name) {
  const number = names.indexOf(name);
  if (number < 0) {
    throw new RangeError(name + ' is none of ' + names.join(' '));
  }
  return number;
}

// A list of integers from least to most: what a typed array would cut off is refused.
function integers(list, least, most) {
  for (const n of list) {
    if (!Number.isInteger(n) || n < least || n > most) {
      throw new RangeError(n + ' is no integer from ' + least + ' to ' + most);
    }
  }
  return list;
}

// The numbers of vectors, one after the other, each of so many.
function numbersOf(vectors, count = 3) {
  for (const vector of vectors) {
    if (vector.length !== count) {
      throw new RangeError('[' + vector + '] has not ' + count + ' numbers');
    }
  }
  return vectors.flat();
}

function poseOf(position, quaternion) {
  return [...numbersOf([position]), ...numbersOf([quaternion], 4)];
}

// Many bodies, asked every tick which of them touch. Bodies are {slot, generation}.
class Scene {
  // config: bodies, and the other fields of gjk_scene_config where they differ from what follows from that.
  constructor(gjk, shapes, { bodies, parts = bodies, ownPoses = parts, pairs = 16 * bodies, boxMargin = 0,
    detail = 'touch', persist = false, retestAll = false, workspaceCells = 0xFFFFFFFF, motions = bodies }) {
    const list = [bodies, parts, ownPoses, pairs, boxMargin, numberOf(DETAILS, detail), +persist, +retestAll, 0,
      workspaceCells, motions];
    this.gjk = gjk;
    this.call = gjk.exports;
    this.at = gjk.lend([shapes.map((shape) => gjk.known(shape)), list], (table, config) =>
      gjk.made(this.call.gjk_wasm_scene_make(table, shapes.length, config)));
  }

  release() {
    this.call.gjk_wasm_scene_release(this.handle());
    this.at = 0;
  }

  handle() {
    if (this.at === 0) {
      throw new Error('a scene that is released');
    }
    return this.at;
  }

  report(status) {
    this.gjk.check(status);
    return this.gjk.report();
  }

  // parts: the number of a shape, or a list of numbers and of {shape, position, quaternion} in the body's frame.
  add(parts, { position = [0, 0, 0], quaternion = UPRIGHT, kind = 'static', detail = 'touch', category = 1,
    mask = 0xFFFFFFFF, user = 0, margin = 0, slot = -1 } = {}) {
    const list = (Array.isArray(parts) ? parts : [parts]).map((part) => (typeof part === 'number'
      ? [part, 0, 0, 0, 0, ...UPRIGHT] : [part.shape, 1, ...poseOf(part.position, part.quaternion || UPRIGHT)]));
    integers(list.map((part) => part[0]), 0, 65535);
    const setup = [...poseOf(position, quaternion), numberOf(KINDS, kind), numberOf(DETAILS, detail), category, mask,
      user, margin];
    const [at, generation] = this.report(this.gjk.lend([setup, list.flat()], (of, its) =>
      this.call.gjk_wasm_scene_add(this.handle(), slot, of, its, list.length)));
    return { slot: at, generation: generation >>> 0 };
  }

  change(change, { slot, generation }, first = 0, second = 0) {
    integers([first, second], 0, change === SET_SHAPE || change === SET_MOTION ? 65535 : 0xFFFFFFFF);
    this.gjk.check(this.call.gjk_wasm_scene_change(this.handle(), change, slot, generation, first, second));
  }

  remove(body) { this.change(REMOVE, body); }
  sleep(body) { this.change(SLEEP, body); }
  wake(body) { this.change(WAKE, body); }
  setMotion(body, motion) { this.change(SET_MOTION, body, numberOf(MOTIONS, motion)); }
  setShape(body, part, shape) { this.change(SET_SHAPE, body, part, shape); }
  setFilter(body, category, mask) { this.change(SET_FILTER, body, category, mask); }
  setUser(body, user) { this.change(SET_USER, body, user); }

  // teleport: the body does not go on the same way.
  move({ slot, generation }, position, quaternion = UPRIGHT, teleport = false) {
    this.gjk.check(this.gjk.lend([poseOf(position, quaternion)], (pose) =>
      this.call.gjk_wasm_scene_move(this.handle(), slot, generation, pose, teleport)));
  }

  get({ slot, generation }) {
    const r = this.report(this.call.gjk_wasm_scene_get(this.handle(), slot, generation));
    return { position: r.slice(0, 3), quaternion: r.slice(3, 7), category: r[7] >>> 0, mask: r[8] >>> 0,
      user: r[9] >>> 0, margin: r[10], partCount: r[11], kind: KINDS[r[12]], detail: DETAILS[r[13]],
      asleep: r[14] !== 0, motion: MOTIONS[r[15]] };
  }

  // All reports of an update. contacts: as those of a pair; without points where none are wanted.
  update() {
    const reports = [];
    for (let more = 1; more !== 0;) {
      const r = this.report(this.call.gjk_wasm_scene_update(this.handle()));
      more = r[0];
      if (r[1] !== 0) {
        reports.push({ a: { slot: r[2], generation: r[3] >>> 0 }, b: { slot: r[4], generation: r[5] >>> 0 },
          partA: r[6], partB: r[7], event: EVENTS[r[8]], detail: DETAILS[r[9]], distance: r[10], fraction: r[11],
          contacts: this.gjk.manifold(r.slice(12)) });
      }
    }
    return reports;
  }

  // What a ray enters first; null: nothing. ignore: a body to leave out.
  castRay(from, to, { category = 0xFFFFFFFF, mask = 0xFFFFFFFF, ignore = { slot: 0, generation: 0 } } = {}) {
    const filter = [category, mask, ignore.slot, ignore.generation];
    const r = this.report(this.gjk.lend([numbersOf([from]), numbersOf([to]), filter], (...lists) =>
      this.call.gjk_wasm_scene_cast_ray(this.handle(), ...lists)));
    return r[0] === 0 ? null : { body: { slot: r[1], generation: r[2] >>> 0 }, part: r[3], fraction: r[4],
      point: r.slice(5, 8), normal: r.slice(8, 11) };
  }

  // Of gjk_scene_stats: bodies, parts, pairs, unsettled queries and updates.
  stats() {
    const r = this.report(this.call.gjk_wasm_scene_stats(this.handle()));
    return { bodies: r[0], parts: r[1], pairs: r[2], unsettled: r[14], updates: r[15] };
  }

  // 64 bits over all that decides further answers, a BigInt.
  hash() {
    const r = this.report(this.call.gjk_wasm_scene_hash(this.handle()));
    return BigInt(r[1] >>> 0) << 32n | BigInt(r[0] >>> 0);
  }

  // The scene as bytes, sealed: what C opens with gjk_scene_open, too.
  save() {
    const [block, count] = this.report(this.call.gjk_wasm_scene_save(this.handle()));
    return this.gjk.bytes().slice(block, block + count);
  }

  // Takes what a scene of the same shapes and configuration has saved. The bytes are checked; after an error the scene
  // is as it was.
  load(save) {
    const at = this.call.gjk_port_allocate(save.length);
    if (at === 0) {
      throw new Error('out of memory');
    }
    this.gjk.bytes().set(save, at);
    const status = this.call.gjk_wasm_scene_load(this.handle(), at, save.length);
    if (status !== 0) {
      this.call.gjk_port_release(at);
    }
    this.gjk.check(status);
  }
}

if (typeof module !== 'undefined') {
  module.exports = { gjkLoad, Gjk, GjkError, Scene };
}
