// Exact collision queries in Q16.16 as WebAssembly: shapes, colliders, queries and scenes over the module's memory, whose
// structures records.js knows. Lengths are integers, 65536 to a unit; unit vectors and rotations have 2^30.
//
// The memory never grows, so a view of it stays valid. Answers are records in it: nothing is copied or allocated for a call.
import { Memory, Q30, done, integer, write } from './core.js';
import * as ground from './ground.js';
import * as records from './records.js';
import { Scene } from './scene.js';

export { BodyKind, BodyMotion, Detail, Event, GjkError, Q16, Q30 } from './core.js';
export * from './records.js';
export { Ground } from './ground.js';
export { Scene };

const { Constants } = records;

// A shape; dispose() gives its memory back, once no collider and no scene has it.
export class Shape {
  constructor(home, vertices, call) {
    const { size } = home, count = vertices.length;
    this.home = home;
    this.record = home.make(home.of.Shape, 4 * size * count);
    this.users = 0;
    const at = this.record.at + home.of.Shape.bytes, memory = home.memory.i32.subarray(at / 4, at / 4 + size * count);
    try {
      integer(count, 0, 65535);
      vertices.forEach((vertex, i) => write(memory.subarray(size * i, size * i + size), vertex));
      done(call(this.record.at, at, count));
    } catch (error) {
      home.release(this.record);
      throw error;
    }
  }

  dispose() {
    if (this.users > 0) {
      throw new Error('a collider or a scene has this shape');
    }
    this.home.release(this.record);
  }
}

// A shape at a pose.
export class Collider {
  constructor(home, shape, position, rotation, baked) {
    const count = baked ? shape.record.count : 0;
    this.home = home;
    this.shape = shape;
    this.record = home.make(home.of.Collider, 4 * home.size * count);
    const buffer = count > 0 ? this.record.at + home.of.Collider.bytes : 0;
    try {
      done(home.call.collider_init(this.record.at, shape.record.at, buffer, count));
      this.pose(position, rotation);
    } catch (error) {
      home.release(this.record);
      throw error;
    }
    shape.users++;
  }

  // After an error it stays where it was.
  pose(position, rotation = this.home.upright) {
    done(this.home.call.collider_pose(this.record.at, this.home.pose(position, rotation)));
  }

  // Without turning: cheaper than a pose.
  move(position) {
    done(this.home.call.collider_move(this.record.at, this.home.vector(position)));
  }

  get position() {
    return this.record.position;
  }

  dispose() {
    this.home.release(this.record);
    this.shape.users--;
  }
}

// What space and the plane have alike. Each query writes to a record of its own, which stands until it is asked again, or to
// one that create() made.
class Dimension {
  constructor(module, prefix, suffix, size, upright) {
    const names = Object.keys(module.exports).filter((name) => name.startsWith(prefix));
    this.memory = module.memory;
    this.module = module;
    this.call = Object.fromEntries(names.map((name) => [name.slice(prefix.length), module.exports[name]]));
    this.of = {};
    for (const of of Object.values(records)) {
      if (of.inC !== undefined && of.inC.startsWith(prefix)) {
        this.of[of.name.slice(0, of.name.length - suffix.length)] = of;
      }
    }
    this.size = size;
    this.upright = upright;
    const { Aabb, CastPath, CastResult, Decision, DistanceResult, Effort, ImpactResult, ImpactSetup, Manifold, Motion,
      PenetrationResult, Pose, WithinResult } = this.of;
    this.scratch = [0, 1].map(() => this.make(Pose));
    this.motions = [0, 1].map(() => this.make(Motion));
    this.path = this.make(CastPath);
    this.effort = this.make(Effort);
    this.impact = this.make(ImpactSetup);
    this.answers = { aabb: this.make(Aabb), decision: this.make(Decision), within: this.make(WithinResult),
      distance: this.make(DistanceResult), penetration: this.make(PenetrationResult), manifold: this.make(Manifold),
      cast: this.make(CastResult), impact: this.make(ImpactResult), rotation: this.make(Pose) };
  }

  make(of, more = 0) {
    return new of(this.memory, this.module.allocate(of.bytes + more));
  }

  release(record) {
    if (record.at === 0) {
      throw new Error('released already');
    }
    this.module.exports.gjk_port_release(record.at);
    record.at = 0;
  }

  // A record of one's own, for answers and caches: create('Cache').
  create(name) {
    return this.make(this.of[name]);
  }

  pose(position, rotation, scratch = this.scratch[0]) {
    write(scratch.position, position);
    write(scratch.rotation, rotation);
    return scratch.at;
  }

  vector(position, scratch = this.scratch[0]) {
    write(scratch.position, position);
    return scratch.at;
  }

  shape(call, vertices = []) {
    return new Shape(this, vertices, call);
  }

  collider(shape, position = this.upright.slice(0, this.size).fill(0), rotation = this.upright, baked = false) {
    return new Collider(this, shape, position, rotation, baked);
  }

  aabb(a) {
    return done(this.call.collider_aabb(a.record.at, this.answers.aabb.at), this.answers.aabb);
  }

  intersect(a, b, out = this.answers.decision, cache = null) {
    return done(this.call.intersect(a.record.at, b.record.at, cache === null ? 0 : cache.at, out.at), out);
  }

  within(a, b, most, out = this.answers.decision, cache = null) {
    return done(this.call.within(a.record.at, b.record.at, integer(most), cache === null ? 0 : cache.at, out.at), out);
  }

  withinUntil(a, b, most, iterations, out = this.answers.within) {
    integer(iterations, 0, 255);
    return done(this.call.within_until(a.record.at, b.record.at, integer(most), iterations, 0, out.at), out);
  }

  distance(a, b, out = this.answers.distance, cache = null) {
    return done(this.call.distance(a.record.at, b.record.at, cache === null ? 0 : cache.at, out.at), out);
  }

  distanceUntil(a, b, iterations, error, out = this.answers.distance) {
    this.effort.iterations = integer(iterations, 0, 255);
    this.effort.error = integer(error);
    return done(this.call.distance_until(a.record.at, b.record.at, this.effort.at, 0, out.at), out);
  }

  setPath(toA, toB, margin) {
    this.path.toA = toA === null ? 0 : this.vector(toA, this.scratch[0]);
    this.path.toB = toB === null ? 0 : this.vector(toB, this.scratch[1]);
    this.path.margin = integer(margin);
    return this.path.at;
  }

  // On straight ways to these positions; null: it stands.
  cast(a, b, toA, toB, margin = 0, out = this.answers.cast) {
    return done(this.call.cast(a.record.at, b.record.at, this.setPath(toA, toB, margin), out.at), out);
  }

  castRay(a, from, to, out = this.answers.cast) {
    const [first, second] = this.scratch;
    return done(this.call.cast_ray(a.record.at, this.vector(from, first), this.vector(to, second), out.at), out);
  }

  // motions: {from, to, spin}; from and to: {position, rotation}.
  timeOfImpact(a, motionA, b, motionB, { margin = 0, tolerance = 16, iterations = 0 } = {}, out = this.answers.impact) {
    [motionA, motionB].forEach((motion, i) => this.setMotion(this.motions[i], motion));
    this.impact.margin = integer(margin);
    this.impact.tolerance = integer(tolerance);
    this.impact.iterations = integer(iterations, 0, 255);
    const [first, second] = this.motions;
    return done(this.call.time_of_impact(a.record.at, first.at, b.record.at, second.at, this.impact.at, out.at), out);
  }

  setMotion(record, { from, to = from, spin = 0 }) {
    for (const [end, pose] of [[record.from, from], [record.to, to]]) {
      write(end.position, pose.position);
      write(end.rotation, pose.rotation || this.upright);
    }
    if (typeof record.spin === 'number') {
      record.spin = integer(spin);
    } else {
      write(record.spin, spin === 0 ? [0, 0, 0] : spin);
    }
  }

  // Proves an answer in integers; throws GJK_ERROR_UNPROVEN where it is not true.
  check(a, b, answer, most = 0) {
    if (answer instanceof this.of.DistanceResult) {
      done(this.call.check_distance(a.record.at, b.record.at, answer.at));
    } else if (answer instanceof this.of.PenetrationResult) {
      done(this.call.check_penetration(a.record.at, b.record.at, answer.at));
    } else {
      done(this.call.check_decision(a.record.at, b.record.at, integer(most), answer.at));
    }
  }

  checkCast(a, b, toA, toB, margin, answer) {
    done(this.call.check_cast(a.record.at, b.record.at, this.setPath(toA, toB, margin), answer.at));
  }

  // Many bodies. shapes: all that they may have; parts name one by its place in this list.
  scene(shapes, config) {
    return new Scene(this, shapes, config);
  }

  turn(call) {
    const { rotation } = this.answers.rotation;
    done(call(rotation.byteOffset));
    return rotation.slice();
  }

  rotations(a, b) {
    write(this.scratch[0].rotation, a);
    write(this.scratch[1].rotation, b);
    return this.scratch.map((pose) => pose.rotation.byteOffset);
  }
}

export class Space extends Dimension {
  constructor(module, cells) {
    super(module, 'gjk_', '', 3, [0, 0, 0, Q30]);
    this.workspace = this.room(cells);
    this.plane = new Plane(module);
  }

  room(cells) {
    const workspace = this.make(records.Workspace, 16 * cells);
    workspace.cells = workspace.at + records.Workspace.bytes;
    workspace.count = cells;
    return workspace;
  }

  sphere(radius) { return this.shape((out) => this.call.shape_point(integer(radius), out)); }
  capsule(radius, half) { return this.shape((out) => this.call.shape_segment(integer(half), integer(radius), out)); }
  box(x, y, z, radius = 0) { return this.shape((out) => this.call.shape_box(...[x, y, z, radius].map((n) => integer(n)), out)); }

  triangle(vertices, radius = 0) {
    integer(vertices.length, 3, 3);
    return this.shape((out, at) => this.call.shape_triangle(at, integer(radius), out), vertices);
  }

  // The convex hull of vertices in any order, as they are: without faces, which contacts need.
  hull(vertices, radius = 0) {
    return this.shape((out, at, count) => this.call.shape_hull(at, count, 0, integer(radius), out), vertices);
  }

  // The exact convex hull of points: only extreme ones, with faces.
  hullOf(points, radius = 0) {
    const { module, call } = this, count = integer(points.length, 0, 65535), blocks = [];
    const take = (bytes) => { blocks.push(module.allocate(bytes)); return blocks[blocks.length - 1]; };
    try {
      const hull = new records.Hull(this.memory, take(records.Hull.bytes)), at = take(12 * count);
      points.forEach((point, i) => write(this.memory.i32.subarray(at / 4 + 3 * i, at / 4 + 3 * i + 3), point));
      const bytes = call.hull_workspace(count), room = take(bytes);
      done(call.hull_build(at, count, room, bytes, hull.at));
      // Cutting faces of many corners adds at most as many faces, and two corners for each.
      const faces = Math.min(hull.faces + hull.corners, 65535), corners = Math.min(3 * hull.corners, 65535);
      const made = this.shape((out, vertices) => {
        const list = vertices + 12 * hull.vertices, corner = list + records.HullFaces.bytes;
        const status = call.hull_vertices(hull.at, vertices, hull.vertices) ||
          call.hull_write_faces(hull.at, corner, corners, corner + 2 * corners, faces, list);
        return status || call.shape_hull(vertices, hull.vertices, hull.dimension === 3 ? list : 0, integer(radius), out);
      }, Array(Math.ceil((12 * hull.vertices + 16 + 2 * (corners + faces)) / 12)).fill([0, 0, 0]));
      return made;
    } finally {
      blocks.forEach((block) => module.exports.gjk_port_release(block));
    }
  }

  cylinder(baseRadius, half, radius = 0) {
    return this.shape((out) => this.call.shape_cylinder(integer(baseRadius), integer(half), integer(radius), out));
  }

  cone(baseRadius, half, radius = 0) {
    return this.shape((out) => this.call.shape_cone(integer(baseRadius), integer(half), integer(radius), out));
  }

  ellipsoid(x, y, z, radius = 0) {
    return this.shape((out) => this.call.shape_ellipsoid(...[x, y, z, radius].map((n) => integer(n)), out));
  }

  penetration(a, b, out = this.answers.penetration, cache = null) {
    const kept = cache === null ? 0 : cache.at;
    return done(this.call.penetration(a.record.at, b.record.at, kept, this.workspace.at, out.at), out);
  }

  signedDistance(a, b, out = this.answers.distance) {
    return done(this.call.signed_distance(a.record.at, b.record.at, 0, this.workspace.at, out.at), out);
  }

  contacts(a, b, margin = 0, most = 4, out = this.answers.manifold) {
    return done(this.call.contacts(a.record.at, b.record.at, integer(margin), most, 0, this.workspace.at, out.at), out);
  }

  // Rotations as arrays of their own. angle: Q16.16 radians.
  axisAngle(axis, angle) { return this.turn((out) => this.call.quat_from_axis_angle(this.vector(axis), integer(angle), out)); }
  normalize(q) { return this.turn((out) => this.call.quat_normalize(this.rotations(q, q)[0], out)); }
  compose(a, b) { return this.turn((out) => this.call.quat_compose(...this.rotations(a, b), out)); }
}

export class Plane extends Dimension {
  constructor(module) {
    super(module, 'gjk2_', '2', 2, [Q30, 0]);
  }

  circle(radius) { return this.shape((out) => this.call.shape_point(integer(radius), out)); }
  capsule(radius, half) { return this.shape((out) => this.call.shape_segment(integer(half), integer(radius), out)); }
  box(x, y, radius = 0) { return this.shape((out) => this.call.shape_box(...[x, y, radius].map((n) => integer(n)), out)); }
  ellipse(x, y, radius = 0) { return this.shape((out) => this.call.shape_ellipse(...[x, y, radius].map((n) => integer(n)), out)); }

  triangle(vertices, radius = 0) {
    integer(vertices.length, 3, 3);
    return this.shape((out, at) => this.call.shape_triangle(at, integer(radius), out), vertices);
  }

  polygon(vertices, radius = 0) {
    return this.shape((out, at, count) => this.call.shape_polygon(at, count, integer(radius), out), vertices);
  }

  // Ground: see ground.js.
  chain(vertices) { return ground.chain(this, vertices); }
  heights(heights, width, shift = 0) { return ground.heights(this, heights, width, shift); }
  tiles(cells, columns, size, forms) { return ground.tiles(this, cells, columns, size, forms); }

  penetration(a, b, out = this.answers.penetration) {
    return done(this.call.penetration(a.record.at, b.record.at, 0, out.at), out);
  }

  signedDistance(a, b, out = this.answers.distance) {
    return done(this.call.signed_distance(a.record.at, b.record.at, 0, out.at), out);
  }

  contacts(a, b, margin = 0, most = 2, out = this.answers.manifold) {
    return done(this.call.contacts(a.record.at, b.record.at, integer(margin), most, 0, out.at), out);
  }

  rotation(angle) { return this.turn((out) => this.call.rotation_from_angle(integer(angle), out)); }
  normalize(r) { return this.turn((out) => this.call.rotation_normalize(this.rotations(r, r)[0], out)); }
  compose(a, b) { return this.turn((out) => this.call.rotation_compose(...this.rotations(a, b), out)); }
}

async function fetchModule() {
  const url = new URL('gjk.wasm', import.meta.url);
  if (url.protocol === 'file:') {
    return (await import('node:fs/promises')).readFile(url);
  }
  return (await fetch(url)).arrayBuffer();
}

// Loads the module: space, with the plane as its field. bytes: of its memory, for all that is made with it. wasm: gjk.wasm as
// bytes or as a WebAssembly.Module; by default the file beside this one. cells: of the workspace for depths and contacts.
export async function load({ bytes = 4 << 20, wasm = null, cells = Constants.GJK_EPA_CURVED_CELLS } = {}) {
  const pages = Math.ceil(bytes / 65536), memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
  const made = await WebAssembly.instantiate(wasm ?? await fetchModule(), { env: { memory } });
  const { exports } = made.instance ?? made;
  const module = {
    exports,
    memory: new Memory(memory.buffer),
    // Aligned to 8, zeroed.
    allocate(size) {
      const at = exports.gjk_port_allocate(Math.max(size, 8));
      if (at === 0) {
        throw new Error(`no ${size} bytes are left: load({ bytes }) says how many there are`);
      }
      module.memory.u8.fill(0, at, at + size);
      return at;
    },
  };
  return new Space(module, cells);
}
