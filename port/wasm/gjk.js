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
    const { gjk_port_allocate: allocate, gjk_port_release: release, gjk_wasm_collider: make } = this.exports;
    const list = vertices.length > 0 ? allocate(12 * vertices.length) : 0;
    if (list === 0 && vertices.length > 0) {
      throw new Error('out of memory');
    }
    this.words().set(vertices.flat(), list / 4);
    const made = make(kind, ...size, convexRadius, list, vertices.length);
    release(list);
    if (made === 0) {
      throw new GjkError(this.report()[0]);
    }
    return made;
  }

  release(shape) {
    this.exports.gjk_port_release(shape);
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
    const r = this.report(), points = [];
    for (let i = 0, at = 4; i < r[0]; i++, at += 8) {
      points.push({ pointA: r.slice(at, at + 3), pointB: r.slice(at + 3, at + 6), distance: r[at + 6], id: r[at + 7] });
    }
    return { normal: r.slice(1, 4), points };
  }

  // B moves in a straight line, until its position is `to`. fraction: of 2^30.
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
    return Array.from(this.words().subarray(at, at + 68));
  }

  check(status) {
    if (status !== 0) {
      throw new GjkError(status);
    }
  }
}

if (typeof module !== 'undefined') {
  module.exports = { gjkLoad, Gjk, GjkError };
}
