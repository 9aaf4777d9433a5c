// Ground of the plane: chains, height profiles and grids of tiles, as gjk2/ground.h has them.
import { done, integer, write } from './core.js';
import * as records from './records.js';

const { Constants } = records;
const ROOM = 16;  // contacts of one call

// Ground, in its own frame. shape is for scenes. Queries are of ground at a pose; the body is a collider. Answers stand until
// the same ground is asked again.
export class Ground {
  // more: bytes of its data, which lay(at) writes and whose call of C it returns.
  constructor(home, more, lay) {
    const { of, memory } = home, sizes = [of.Ground.bytes, of.Pose.bytes, of.CastResult.bytes, of.DistanceResult.bytes, 8,
      ROOM * of.ChainContact.bytes];
    this.home = home;
    this.shape = home.shape((out, at) => {
      const places = sizes.map((bytes) => { const place = at; at += bytes; return place; });
      const [ground, pose, cast, distance, words, contacts] = places;
      this.at = ground;
      this.pose = new of.Pose(memory, pose);
      this.ofCast = new of.CastResult(memory, cast);
      this.ofDistance = new of.DistanceResult(memory, distance);
      this.words = words;
      this.room = Array.from({ length: ROOM }, (_, i) => new of.ChainContact(memory, contacts + of.ChainContact.bytes * i));
      const [call, data] = lay(at);
      return call(data.at, ground, out);
    }, Array(Math.ceil((sizes.reduce((a, b) => a + b) + more) / 8)).fill([0, 0]));
  }

  place(position = [0, 0], rotation = this.home.upright) {
    write(this.pose.position, position);
    write(this.pose.rotation, rotation);
    return this.pose.at;
  }

  found(status, result, found) {
    done(status);
    return found ? { segment: this.home.memory.u32[this.words / 4], result } : null;
  }

  // Is a segment that counts at most so far away?
  within(body, distance = 0, position, rotation) {
    const { call, memory } = this.home;
    done(call.ground_within(this.at, this.place(position, rotation), body.record.at, integer(distance), this.words));
    return memory.u8[this.words] !== 0;
  }

  // { segment, result } of the nearest segment that counts; null: there is none.
  distance(body, position, rotation) {
    const { call, memory } = this.home, { words, ofDistance } = this, pose = this.place(position, rotation);
    const status = call.ground_distance(this.at, pose, body.record.at, ofDistance.at, words, words + 4);
    return this.found(status, ofDistance, memory.u8[words + 4] !== 0);
  }

  // { segment, manifold } of each segment and joint. After CAPACITY partial has the deepest of them.
  contacts(body, margin = 0, position, rotation) {
    const { call, memory } = this.home, { words } = this, pose = this.place(position, rotation);
    const status = call.ground_contacts(this.at, pose, body.record.at, integer(margin), this.room[0].at, ROOM, words);
    const partial = status === 0 || status === Constants.GJK_ERROR_CAPACITY;
    return done(status, partial ? this.room.slice(0, memory.u16[words / 2]) : null);
  }

  // Which segment a body meets first on a straight way: { segment, result }, or null.
  cast(body, to, margin = 0, position, rotation) {
    const pose = this.place(position, rotation), { call } = this.home, path = this.home.setPath(null, to, margin);
    return this.found(call.ground_cast(this.at, pose, body.record.at, path, this.ofCast.at, this.words), this.ofCast,
      this.ofCast.hit);
  }

  // Where a ray enters from the outside.
  castRay(from, to, position, rotation) {
    const { call, scratch } = this.home, pose = this.place(position, rotation);
    const start = this.home.vector(from, scratch[0]), end = this.home.vector(to, scratch[1]);
    return this.found(call.ground_cast_ray(this.at, pose, start, end, this.ofCast.at, this.words), this.ofCast, this.ofCast.hit);
  }

  dispose() {
    this.shape.dispose();
  }
}

// Segments from each vertex to the next, the outside to their right: ground runs from right to left.
export function chain(home, vertices) {
  const { of, memory, call } = home, count = integer(vertices.length, 0, 65535), boxes = Math.floor(count / 3) + 8;
  const head = of.Polyline.bytes + of.Index.bytes;
  return new Ground(home, head + 8 * (count + boxes), (at) => {
    const data = new of.Polyline(memory, at), first = at + head;
    vertices.forEach((vertex, i) => write(memory.i32.subarray(first / 4 + 2 * i, first / 4 + 2 * i + 2), vertex));
    Object.assign(data, { vertices: first, count });
    done(call.index_build(at, first + 8 * count, boxes, at + of.Polyline.bytes));
    data.index = at + of.Polyline.bytes;
    return [call.ground_of_chain, data];
  });
}

// A profile of columns of that width: vertex i is heights[i] 2^shift high; null: a hole.
export function heights(home, heights, width, shift = 0) {
  const { of, memory, call } = home, count = integer(heights.length, 0, 65535), hole = Constants.GJK2_HOLE;
  return new Ground(home, of.Heights.bytes + 2 * count, (at) => {
    const data = new of.Heights(memory, at), first = at + of.Heights.bytes;
    heights.forEach((height, i) => { memory.i16[first / 2 + i] = height === null ? hole : integer(height, hole, -1 - hole); });
    Object.assign(data, { heights: first, count, width: integer(width), shift: integer(shift, 0, 255) });
    return [call.ground_of_heights, data];
  });
}

// A grid of square tiles, the bottom row first, as a text or numbers. forms: an object that has { left, right, turns, oneWay }
// for some characters or numbers, heights in quarters; others are empty. The cells of the ground are an array of bytes, which
// may be written; then scene.refilter(body) tells a scene of it.
export function tiles(home, cells, columns, size, forms) {
  const { of, memory, call } = home, code = typeof cells === 'string' ? (cell) => cell.codePointAt(0) : Number;
  const codes = Array.from(cells, (cell) => integer(code(cell), 0, 255));
  const rows = integer(codes.length / integer(columns, 1, 65535), 0, 65535);
  const table = Object.entries(forms).map(([key, form]) => [integer(code(key), 0, 254), form]);
  const count = 1 + Math.max(-1, ...table.map(([number]) => number));
  const first = of.Tiles.bytes, head = first + of.Tile.bytes * count;
  let view;
  const ground = new Ground(home, head + codes.length, (at) => {
    const data = new of.Tiles(memory, at);
    for (const [number, { left, right, turns = 0, oneWay = false }] of table) {
      Object.assign(new of.Tile(memory, at + first + of.Tile.bytes * number), { left: integer(left, 0, 255),
        right: integer(right, 0, 255), turns: integer(turns, 0, 255), oneWay });
    }
    view = memory.u8.subarray(at + head, at + head + codes.length);
    view.set(codes);
    Object.assign(data, { cells: at + head, columns, rows, size: integer(size), formCount: count, forms: at + first });
    return [call.ground_of_tiles, data];
  });
  ground.cells = view;
  return ground;
}
