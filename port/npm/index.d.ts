// Exact collision queries in Q16.16. Lengths are integers, 65536 to a unit; unit vectors and rotations have 2^30.
import {
  Aabb, Aabb2, BodyState, BodyState2, Cache, Cache2, CastResult, CastResult2, ChainContact2, Decision, Decision2, DistanceResult,
  DistanceResult2, ImpactResult, ImpactResult2, Manifold, Manifold2, PenetrationResult, PenetrationResult2, Record, Report, Report2,
  SceneHit, SceneStats, WithinResult, WithinResult2,
} from './records.js';

export * from './records.js';

export const Q16: number;
export const Q30: number;
export const BodyKind: Readonly<{ STATIC: 0; KINEMATIC: 1; DYNAMIC: 2 }>;
export const Detail: Readonly<{ TOUCH: 0; DISTANCE: 1; DEPTH: 2; CONTACTS: 3; SENSOR: 4 }>;
export const Event: Readonly<{ BEGIN: 1; PERSIST: 2; END: 3; IMPACT: 4 }>;
export const BodyMotion: Readonly<{ NOT_KEPT: 0; KEPT: 1; FAST: 2 }>;

/** Two or three integers; a rotation has four, of 2^30, or in the plane cosine and sine. */
export type Vector = ArrayLike<number>;

/** A status that is not OK. partial: what the call has written. */
export class GjkError extends Error {
  readonly status: number;
  readonly partial: Record | null;
}

export interface Pose {
  position: Vector;
  rotation?: Vector;
}

export interface Motion {
  from: Pose;
  to?: Pose;
  /** Angle times axis over the whole way, Q16.16 radians; in the plane the angle. */
  spin?: Vector | number;
}

export interface BodyName {
  readonly slot: number;
  readonly generation: number;
}

export interface Filter {
  category?: number;
  mask?: number;
  ignore?: BodyName;
}

export interface SceneOptions {
  bodies: number;
  parts?: number;
  ownPoses?: number;
  pairs?: number;
  boxMargin?: number;
  detail?: number;
  persist?: boolean;
  retestAll?: boolean;
  pairWords?: number;
  workspaceCells?: number;
  motions?: number;
}

export interface BodyOptions {
  position?: Vector;
  rotation?: Vector;
  kind?: number;
  detail?: number;
  category?: number;
  mask?: number;
  user?: number;
  margin?: number;
  slot?: number;
}

export type PartOptions = number | { shape: number; position: Vector; rotation?: Vector };

/** What space and the plane name differently. */
export interface InSpace {
  aabb: Aabb; cache: Cache; cast: CastResult; decision: Decision; distance: DistanceResult; impact: ImpactResult;
  manifold: Manifold; penetration: PenetrationResult; report: Report; state: BodyState; within: WithinResult;
}
export interface InPlane {
  aabb: Aabb2; cache: Cache2; cast: CastResult2; decision: Decision2; distance: DistanceResult2; impact: ImpactResult2;
  manifold: Manifold2; penetration: PenetrationResult2; report: Report2; state: BodyState2; within: WithinResult2;
}
type Names = InSpace | InPlane;

export interface Shape<D extends Names> {
  readonly record: Record;
  /** Once no collider and no scene has it. */
  dispose(): void;
  readonly dimension?: D;
}

export interface Collider<D extends Names> {
  readonly shape: Shape<D>;
  readonly position: Int32Array;
  pose(position: Vector, rotation?: Vector): void;
  move(position: Vector): void;
  dispose(): void;
}

export interface Scene<D extends Names> {
  /** All that the scene is, in the module's memory. */
  readonly view: Uint8Array;
  readonly bytes: number;
  add(parts: PartOptions | PartOptions[], options?: BodyOptions): BodyName;
  remove(body: BodyName): void;
  move(body: BodyName, position: Vector, rotation?: Vector): void;
  teleport(body: BodyName, position: Vector, rotation?: Vector): void;
  sleep(body: BodyName): void;
  wake(body: BodyName): void;
  setMotion(body: BodyName, motion: number): void;
  setUser(body: BodyName, user: number): void;
  refilter(body: BodyName): void;
  setFilter(body: BodyName, category: number, mask: number): void;
  setShape(body: BodyName, part: number, shape: number): void;
  get(body: BodyName): D['state'];
  update(each: (report: D['report'], manifold: D['manifold'] | null, words: Uint32Array | null) => void): void;
  castRay(from: Vector, to: Vector, filter?: Filter): { hit: SceneHit; result: D['cast'] } | null;
  cast(collider: Collider<D>, to: Vector, margin?: number, filter?: Filter): { hit: SceneHit; result: D['cast'] } | null;
  within(collider: Collider<D>, reach: number, filter?: Filter): { body: BodyName; part: number; user: number }[];
  stats(): SceneStats;
  hash(): bigint;
  save(into?: ArrayBuffer): ArrayBuffer;
  load(save: ArrayBuffer): void;
  seal(): void;
  open(save: ArrayBuffer): void;
  dispose(): void;
}

export interface Dimension<D extends Names> {
  collider(shape: Shape<D>, position?: Vector, rotation?: Vector, baked?: boolean): Collider<D>;
  create(name: string): Record;
  release(record: Record): void;
  aabb(a: Collider<D>): D['aabb'];
  intersect(a: Collider<D>, b: Collider<D>, out?: D['decision'], cache?: D['cache'] | null): D['decision'];
  within(a: Collider<D>, b: Collider<D>, most: number, out?: D['decision'], cache?: D['cache'] | null): D['decision'];
  withinUntil(a: Collider<D>, b: Collider<D>, most: number, iterations: number, out?: D['within']): D['within'];
  distance(a: Collider<D>, b: Collider<D>, out?: D['distance'], cache?: D['cache'] | null): D['distance'];
  distanceUntil(a: Collider<D>, b: Collider<D>, iterations: number, error: number, out?: D['distance']): D['distance'];
  penetration(a: Collider<D>, b: Collider<D>, out?: D['penetration']): D['penetration'];
  signedDistance(a: Collider<D>, b: Collider<D>, out?: D['distance']): D['distance'];
  contacts(a: Collider<D>, b: Collider<D>, margin?: number, most?: number, out?: D['manifold']): D['manifold'];
  cast(a: Collider<D>, b: Collider<D>, toA: Vector | null, toB: Vector | null, margin?: number, out?: D['cast']): D['cast'];
  castRay(a: Collider<D>, from: Vector, to: Vector, out?: D['cast']): D['cast'];
  timeOfImpact(a: Collider<D>, motionA: Motion, b: Collider<D>, motionB: Motion,
    setup?: { margin?: number; tolerance?: number; iterations?: number }, out?: D['impact']): D['impact'];
  check(a: Collider<D>, b: Collider<D>, answer: D['distance'] | D['penetration'] | D['decision'], most?: number): void;
  checkCast(a: Collider<D>, b: Collider<D>, toA: Vector | null, toB: Vector | null, margin: number, answer: D['cast']): void;
  scene(shapes: Shape<D>[], config: SceneOptions): Scene<D>;
  normalize(rotation: Vector): Int32Array;
  compose(a: Vector, b: Vector): Int32Array;
  /** The functions of C that are in the module, by their names without gjk_ or gjk2_. */
  readonly call: { readonly [name: string]: (...numbers: number[]) => number };
}

export interface TileForm {
  left: number;
  right: number;
  turns?: number;
  oneWay?: boolean;
}

/** Ground of the plane, whose shape is for scenes. Queries are of ground at a pose. */
export interface Ground {
  readonly shape: Shape<InPlane>;
  /** Of a grid of tiles; after a write scene.refilter(body). */
  readonly cells?: Uint8Array;
  within(body: Collider<InPlane>, distance?: number, position?: Vector, rotation?: Vector): boolean;
  distance(body: Collider<InPlane>, position?: Vector, rotation?: Vector): { segment: number; result: DistanceResult2 } | null;
  contacts(body: Collider<InPlane>, margin?: number, position?: Vector, rotation?: Vector): ChainContact2[];
  cast(body: Collider<InPlane>, to: Vector, margin?: number, position?: Vector, rotation?: Vector): { segment: number; result: CastResult2 } | null;
  castRay(from: Vector, to: Vector, position?: Vector, rotation?: Vector): { segment: number; result: CastResult2 } | null;
  dispose(): void;
}

export interface Plane extends Dimension<InPlane> {
  circle(radius: number): Shape<InPlane>;
  capsule(radius: number, half: number): Shape<InPlane>;
  box(x: number, y: number, radius?: number): Shape<InPlane>;
  ellipse(x: number, y: number, radius?: number): Shape<InPlane>;
  triangle(vertices: Vector[], radius?: number): Shape<InPlane>;
  polygon(vertices: Vector[], radius?: number): Shape<InPlane>;
  chain(vertices: Vector[]): Ground;
  heights(heights: (number | null)[], width: number, shift?: number): Ground;
  tiles(cells: string | ArrayLike<number>, columns: number, size: number, forms: { [key: string]: TileForm }): Ground;
  rotation(angle: number): Int32Array;
}

export interface Space extends Dimension<InSpace> {
  readonly plane: Plane;
  penetration(a: Collider<InSpace>, b: Collider<InSpace>, out?: PenetrationResult, cache?: Cache | null): PenetrationResult;
  sphere(radius: number): Shape<InSpace>;
  capsule(radius: number, half: number): Shape<InSpace>;
  box(x: number, y: number, z: number, radius?: number): Shape<InSpace>;
  triangle(vertices: Vector[], radius?: number): Shape<InSpace>;
  hull(vertices: Vector[], radius?: number): Shape<InSpace>;
  hullOf(points: Vector[], radius?: number): Shape<InSpace>;
  cylinder(baseRadius: number, half: number, radius?: number): Shape<InSpace>;
  cone(baseRadius: number, half: number, radius?: number): Shape<InSpace>;
  ellipsoid(x: number, y: number, z: number, radius?: number): Shape<InSpace>;
  axisAngle(axis: Vector, angle: number): Int32Array;
}

export function load(options?: { bytes?: number; wasm?: BufferSource | WebAssembly.Module; cells?: number }): Promise<Space>;
