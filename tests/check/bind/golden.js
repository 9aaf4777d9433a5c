// The golden set of queries of tests/check/target/golden.c through WebAssembly: golden.js GJK.WASM PAIRS HASH
//
// Every public function is called as the module exports it, its structures laid out as C does. On the way, what gjk.js
// answers about each pair is compared. Exits with 0 if the hash over so many pairs is HASH, and gjk.js agrees.
'use strict';

const assert = require('assert');
const fs = require('fs');
const path = require('path');
const { gjkLoad } = require(path.resolve('port/wasm/gjk.js'));
const { Random } = require('./random.js');

const VERTICES = 16, WORKSPACE = 20, ONE = 1 << 30, INT32_MAX = 2147483647;

// Structures: a name of C, and each field's name with its type, a number or a structure, perhaps with a count.

const NUMBERS = {
  i32: { size: 4, align: 4, read: (view, at) => view.getInt32(at, true) },
  u32: { size: 4, align: 4, read: (view, at) => view.getUint32(at, true) },
  u16: { size: 2, align: 2, read: (view, at) => view.getUint16(at, true) },
  i16: { size: 2, align: 2, read: (view, at) => view.getInt16(at, true) },
  u8: { size: 1, align: 1, read: (view, at) => view.getUint8(at) },
  i8: { size: 1, align: 1, read: (view, at) => view.getInt8(at) },
};

function structure(name, fields) {
  const made = { name, size: 0, align: 1, offset: {} };
  const types = {};
  for (const [field, kind, count] of fields) {
    const type = typeof kind === 'string' ? NUMBERS[kind] : kind;
    made.align = Math.max(made.align, type.align);
    made.offset[field] = Math.ceil(made.size / type.align) * type.align;
    made.size = made.offset[field] + type.size * (count || 1);
    types[field] = { type, count };
  }
  made.size = Math.ceil(made.size / made.align) * made.align;
  made.read = (view, at) => {
    const value = {};
    for (const [field, { type, count }] of Object.entries(types)) {
      const item = (i) => type.read(view, at + made.offset[field] + i * type.size);
      value[field] = count ? Array.from({ length: count }, (_, i) => item(i)) : item(0);
    }
    return value;
  };
  return made;
}

const VEC3 = structure('gjk_vec3', [['x', 'i32'], ['y', 'i32'], ['z', 'i32']]);
const QUAT = structure('gjk_quat', [['x', 'i32'], ['y', 'i32'], ['z', 'i32'], ['w', 'i32']]);
const POSE = structure('gjk_pose', [['position', VEC3], ['rotation', QUAT]]);
const SHAPE = structure('gjk_shape', [['type', 'u32'], ['vertices', 'u32'], ['support', 'u32'], ['user', 'u32'],
  ['size', VEC3], ['convexRadius', 'i32'], ['count', 'u16'], ['faces', 'u32']]);
const COLLIDER = structure('gjk_collider', [['shape', 'u32'], ['buffer', 'u32'], ['position', VEC3], ['centre', VEC3],
  ['localCentre', VEC3], ['frame', VEC3, 3], ['coreRadius', 'i32'], ['radius', 'i32'], ['state', 'u16'],
  ['count', 'u16'], ['bits', 'u8'], ['fraction', 'i8', 3]]);
const CACHE = structure('gjk_cache', [['direction', 'i16', 3], ['count', 'u16'], ['a', 'u16', 4], ['b', 'u16', 4]]);
const CERTIFICATE = structure('gjk_certificate', [['direction', VEC3], ['a', 'u16', 4], ['b', 'u16', 4],
  ['count', 'u8'], ['proof', 'u8']]);
const DECISION = structure('gjk_decision', [['yes', 'u8'], ['iterations', 'u8'], ['certificate', CERTIFICATE]]);
const WITHIN = structure('gjk_within_result', [['answer', 'i32'], ['decision', DECISION]]);
const DISTANCE = structure('gjk_distance_result', [['distance', 'i32'], ['lower', 'i32'], ['upper', 'i32'],
  ['pointA', VEC3], ['pointB', VEC3], ['normal', VEC3], ['intersecting', 'u8'], ['saturated', 'u8'],
  ['iterations', 'u8'], ['certificate', CERTIFICATE]]);
const EFFORT = structure('gjk_effort', [['iterations', 'u8'], ['error', 'i32']]);
const MEMORY = structure('gjk_workspace', [['cells', 'u32'], ['count', 'u32']]);
const PENETRATION = structure('gjk_penetration_result', [['depth', 'i32'], ['lower', 'i32'], ['upper', 'i32'],
  ['pointA', VEC3], ['pointB', VEC3], ['normal', VEC3], ['intersecting', 'u8'], ['iterations', 'u16'],
  ['certificate', CERTIFICATE]]);
const CONTACT = structure('gjk_contact', [['pointA', VEC3], ['pointB', VEC3], ['distance', 'i32'], ['id', 'u16']]);
const MANIFOLD = structure('gjk_manifold', [['normal', VEC3], ['count', 'u8'], ['featureA', 'u16'], ['featureB', 'u16'],
  ['contact', CONTACT, 8]]);

// FNV-1a over words, as tests/support/fnv.h.
let hash = 0xCBF29CE484222325n;

function mix(...words) {
  for (let word of words.flat()) {
    for (let i = 0; i < 4; i++) {
      hash = BigInt.asUintN(64, (hash ^ BigInt(word & 0xFF)) * 0x100000001B3n);
      word >>= 8;
    }
  }
}

const list = (vector) => Object.values(vector);

class Golden {
  constructor(gjk) {
    this.gjk = gjk;
    this.call = gjk.exports;
    this.random = new Random(2026);
    this.results = {};
    for (const type of [VEC3, QUAT, POSE, SHAPE, COLLIDER, CACHE, CERTIFICATE, DECISION, WITHIN, DISTANCE, EFFORT,
      MEMORY, PENETRATION, CONTACT, MANIFOLD]) {
      assert.strictEqual(this.sizeOf(type.name), type.size, type.name);
      this.results[type.name] = this.room(type.size);
    }
    const bytes = this.call.gjk_workspace_bytes(WORKSPACE);
    this.memory = this.room(MEMORY.size);
    this.words(this.memory, [this.room(bytes), bytes / this.sizeOf('gjk_epa_cell')]);
    this.cache = this.room(CACHE.size);
    this.bodies = [0, 1].map(() => ({ vertices: this.room(12 * VERTICES), buffer: this.room(12 * VERTICES),
      shape: this.room(SHAPE.size), collider: this.room(COLLIDER.size) }));
    [this.a, this.b] = this.bodies.map((body) => body.collider);
  }

  sizeOf(name) {
    const at = this.gjk.putText(name), size = this.call.gjk_size_of(at);
    this.call.gjk_port_release(at);
    return size;
  }

  room(bytes) { return this.call.gjk_port_allocate(bytes); }
  words(at, values) { this.gjk.words().set(values, at / 4); }

  // The status and the result, of that type, of a query whose last argument is where it writes that.
  ask(name, type, ...args) {
    const out = this.results[type.name];
    const status = this.call[name](...args, out);
    return { status, ...type.read(new DataView(this.call.memory.buffer), out) };
  }

  makeShape(body, size) {
    const { random, call } = this;
    const kind = [0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7][random.below(11)];  // boxes and hulls more often
    const lengths = [0, 1, 2].map(() => random.range(1, size)), [x, y, z] = lengths;
    const count = kind === 2 ? 3 : 4 + random.below(VERTICES - 3);
    const grid = random.below(4) === 0 ? Math.trunc(size / 2) + 1 : 1;  // coarse: ties, and parallel faces
    const vertices = [];
    for (let i = 0; i < count; i++) {
      vertices.push(random.vector(size).map((c) => Math.trunc(c / grid) * grid));
    }
    const radius = random.below(4) === 0 ? random.range(0, Math.trunc(size / 2)) : 0;
    this.words(body.vertices, vertices.flat());
    const made = [
      () => call.gjk_shape_point(radius, body.shape),
      () => call.gjk_shape_segment(z, radius, body.shape),
      () => call.gjk_shape_triangle(body.vertices, radius, body.shape),
      () => call.gjk_shape_box(x, y, z, radius, body.shape),
      () => call.gjk_shape_hull(body.vertices, count, 0, radius, body.shape),
      () => call.gjk_shape_cylinder(x, z, radius, body.shape),
      () => call.gjk_shape_cone(x, z, radius, body.shape),
      () => call.gjk_shape_ellipsoid(x, y, z, radius, body.shape),
    ][kind]();
    assert.strictEqual(made, 0);
    this.words(body.shape + SHAPE.offset.size, lengths);  // all three, also where fewer are used; golden.c does so
    Object.assign(body, { kind, lengths, radius, list: kind === 2 || kind === 4 ? vertices : [] });
  }

  makePose(body, reach) {
    const { random, call } = this, q = this.results.gjk_quat;
    body.rotation = [0, 0, 0, ONE];
    if (random.below(4) !== 0) {
      this.words(q, [1000, 1000, 1000, 1001].map((high) => random.range(-1000, high)));
      mix(call.gjk_quat_normalize(q, q));
      body.rotation = Array.from(this.gjk.words().slice(q / 4, q / 4 + 4));
    }
    body.position = random.vector(reach);
  }

  place(body) {
    const baked = this.random.below(2) === 0, pose = this.results.gjk_pose;
    mix(this.call.gjk_collider_init(body.collider, body.shape, baked ? body.buffer : 0, VERTICES));
    this.words(pose, [...body.position, ...body.rotation]);
    mix(this.call.gjk_collider_pose(body.collider, pose));
  }

  distance(cache) {
    const out = this.ask('gjk_distance', DISTANCE, this.a, this.b, cache);
    mix(out.status, out.intersecting, out.saturated, out.distance);
    if (!out.intersecting) {
      mix(list(out.pointA), list(out.pointB), list(out.normal));
    }
    return out;
  }

  // most below 0: gjk_intersect.
  decision(most, cache) {
    const out = most < 0 ? this.ask('gjk_intersect', DECISION, this.a, this.b, cache)
      : this.ask('gjk_within', DECISION, this.a, this.b, most, cache);
    mix(out.status, out.yes);
  }

  withinUntil(most, iterations) {
    const out = this.ask('gjk_within_until', WITHIN, this.a, this.b, most, iterations, 0);
    mix(out.status, out.answer);
  }

  distanceUntil(iterations, error) {
    const effort = this.results.gjk_effort;
    this.words(effort, [iterations, error]);
    const out = this.ask('gjk_distance_until', DISTANCE, this.a, this.b, effort, 0);
    mix(out.status, out.intersecting, out.distance, out.lower, out.upper);
    if (!out.intersecting) {
      mix(list(out.pointA));
    }
  }

  penetration(cache) {
    const out = this.ask('gjk_penetration', PENETRATION, this.a, this.b, cache, this.memory);
    mix(out.status, out.intersecting);
    if (out.intersecting) {
      mix(out.depth, out.lower, out.upper, list(out.pointA), list(out.pointB), list(out.normal));
    }
  }

  contacts(margin) {
    const out = this.ask('gjk_contacts', MANIFOLD, this.a, this.b, margin, 4, 0, this.memory);
    mix(out.status, out.count);
    for (const contact of out.contact.slice(0, out.count)) {
      mix(list(contact.pointA), list(contact.pointB), contact.distance, contact.id);
    }
  }

  // Moves B along the normal until the gap is near 0.
  approach(found) {
    const by = BigInt(found.distance + this.random.range(-2, 2)), b = this.bodies[1], to = this.results.gjk_vec3;
    const part = (component) => Number(BigInt(component) * by / BigInt(ONE));
    this.words(to, list(found.normal).map((component, i) => b.position[i] - part(component)));
    mix(this.call.gjk_collider_move(this.b, to));
  }

  // gjk.js about the same pair. Its shapes have only the lengths that their kind uses, which may change iterations.
  compare(found) {
    const names = ['point', 'capsule', 'triangle', 'box', 'hull', 'cylinder', 'cone', 'ellipsoid'];
    const make = (body) => {
      const [x, y, z] = body.lengths, { gjk } = this;
      const shape = [() => gjk.sphere(body.radius), () => gjk.capsule(body.radius, z),
        () => gjk.triangle(body.list, body.radius), () => gjk.box(x, y, z, body.radius),
        () => gjk.hull(body.list, body.radius), () => gjk.cylinder(x, z, body.radius),
        () => gjk.cone(x, z, body.radius), () => gjk.ellipsoid(x, y, z, body.radius)][body.kind]();
      gjk.pose(shape, body.position, body.rotation);
      return shape;
    };
    const [a, b] = this.bodies.map(make), answer = this.gjk.distance(a, b);
    const what = this.bodies.map((body) => names[body.kind]).join(' and ');
    assert.strictEqual(answer.intersecting, found.intersecting !== 0, what);
    assert.strictEqual(this.gjk.intersect(a, b).intersecting, answer.intersecting, what);
    if (!answer.intersecting) {
      assert.strictEqual(answer.distance, found.distance, what);
    }
    this.gjk.release(a);
    this.gjk.release(b);
  }

  pair() {
    const { random, cache } = this;
    const size = 1 << (3 + random.below(23)), far = random.below(8) === 0;
    for (const body of this.bodies) {
      this.makeShape(body, size);
      this.makePose(body, far ? INT32_MAX : 2 * size);
      this.place(body);
    }
    this.words(cache, new Array(CACHE.size / 4).fill(0));
    let found = this.distance(0);
    this.compare(found);
    this.decision(-1, 0);
    this.decision(found.distance, 0);
    found = this.distance(cache);
    this.penetration(cache);
    this.contacts(0);
    if (!found.intersecting && !far) {
      this.approach(found);
      found = this.distance(cache);
      this.decision(-1, cache);
      this.decision(1, 0);
      this.withinUntil(1 + Math.trunc(size / 32), 1);
      this.withinUntil(found.distance, 2);
      this.distanceUntil(2, 0);
      this.distanceUntil(0, 1 + Math.trunc(size / 16));
      this.penetration(0);
      this.contacts(Math.trunc(size / 8));
    }
  }
}

async function main([file, pairs, expected]) {
  const golden = new Golden(await gjkLoad(fs.readFileSync(file)));
  for (let i = 0; i < Number(pairs); i++) {
    golden.pair();
  }
  const found = hash.toString(16).padStart(16, '0');
  console.log(found);
  return found === expected ? 0 : 1;
}

main(process.argv.slice(2)).then((status) => { process.exitCode = status; });
