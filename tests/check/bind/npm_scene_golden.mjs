// The matches of tests/support/scene through the npm package, with rollbacks: npm_scene_golden.mjs TICKS HASH [plane]. Exits with
// 0 if the hash over so many ticks is HASH, in hexadecimal digits.
import { BodyKind, Detail, Event, load } from 'gjk-exact';
import { Random } from './npm_common.mjs';

const BODIES = 24, PRIME = 0x100000001B3n, MASK = (1n << 64n) - 1n;
const DETAILS = [Detail.DISTANCE, Detail.TOUCH, Detail.TOUCH, Detail.DISTANCE, Detail.DEPTH, Detail.CONTACTS];
const q16 = (units) => Math.round(units * 65536);
const flat = process.argv[4] === 'plane';
const AXES = flat ? 2 : 3, WALL = flat ? 6 : 5, REACH = q16(flat ? 4 : 3);
const space = await load(), gjk = flat ? space.plane : space;

function shapes() {
  if (flat) {
    return [gjk.box(q16(0.5), q16(0.5)), gjk.circle(q16(0.5)), gjk.capsule(q16(0.25), q16(0.4)),
      gjk.polygon([[30000, 2000], [9000, 29000], [-25000, 20000], [-28000, -9000], [-3000, -30000], [19000, -18000]]),
      gjk.ellipse(q16(0.5), q16(0.375)), gjk.triangle([[-40000, -9000], [41000, 0], [3000, 52000]]),
      gjk.box(q16(6), q16(0.25))];
  }
  return [gjk.box(q16(0.5), q16(0.5), q16(0.5)), gjk.sphere(q16(0.5)), gjk.capsule(q16(0.25), q16(0.4)),
    gjk.hull([[30000, 2000, 1000], [-28000, 9000, -3000], [5000, 31000, 2000], [-3000, -30000, 4000], [1000, 2000, 33000],
      [-2000, 900, -31000], [20000, 20000, 12000], [-19000, -18000, -9000]]),
    gjk.cylinder(q16(0.5), q16(0.375)), gjk.box(q16(6), q16(6), q16(0.25))];
}

function scramble(x) {
  x = Math.imul(x ^ x >>> 16, 0x7FEB352D);
  x = Math.imul(x ^ x >>> 15, 0x846CA68B);
  return (x ^ x >>> 16) >>> 0;
}

const dice = (a, b, c, limit) => scramble(scramble(scramble(a) ^ b) ^ c) % (2 * limit + 1) - limit;
const bounce = (at, step) => ((at > REACH && step > 0) || (at < -REACH && step < 0) ? -step : step);
const axes = (make) => Array.from({ length: AXES }, (_, axis) => make(axis));
const up = (height) => axes((axis) => (axis === AXES - 1 ? height : 0));

function sumOf(m) {
  const divisors = [5, 7, 11];
  let sum = m.normal.reduce((all, n, i) => all + n % divisors[i], 0) + m.featureA + m.featureB;
  for (const c of m.contact.slice(0, m.count)) {
    sum += c.pointA[0] % 5 + c.pointA[1] % 7 + c.pointB[flat ? 0 : 2] % 11 + c.distance % 13 + c.id;
  }
  return sum;
}

class Match {
  constructor() {
    this.scene = gjk.scene(shapes(), { bodies: BODIES, parts: 2 * BODIES, ownPoses: BODIES, pairs: 160, boxMargin: q16(0.1),
      persist: true, workspaceCells: 400 });
    this.tick = 0;
    this.movers = [];
    for (let slot = 0; slot < BODIES; slot++) {
      this.add(slot);
    }
  }

  add(slot) {
    const roll = (c, limit) => dice(slot, this.tick, c, limit), fixed = slot === BODIES - 1;
    const parts = [fixed ? WALL : slot % WALL];
    if (slot % 6 === 5 && !fixed) {
      parts.push({ shape: 1, position: up(q16(0.75)) });
    }
    const id = this.scene.add(parts, { slot, position: fixed ? up(-REACH) : axes((axis) => roll(1 + axis, REACH)),
      kind: fixed ? BodyKind.STATIC : slot < 2 ? BodyKind.KINEMATIC : BodyKind.DYNAMIC, detail: DETAILS[slot % 6], user: slot,
      margin: slot % 4 === 0 ? q16(0.125) : 0 });
    const turn = flat ? [30000, roll(4, 500)] : [roll(4, 300), roll(5, 300), roll(6, 300), 30000];
    this.movers[slot] = { id, step: axes((axis) => (slot < 2 ? 0 : roll(7 + axis, 3000))), turn: gjk.normalize(turn) };
  }

  move(slot, input) {
    const mover = this.movers[slot], state = this.scene.get(mover.id);
    if (state.kind === BodyKind.STATIC || state.asleep) {
      return;
    }
    const push = input & 8 ? -2000 : 2000, { position, rotation } = state.pose;
    for (let axis = 0; axis < AXES; axis++) {
      mover.step[axis] = bounce(position[axis], input & 1 << axis ? push : mover.step[axis]);
      position[axis] += mover.step[axis];
    }
    this.scene.move(mover.id, position, slot >= 2 || input & 16 ? gjk.compose(mover.turn, rotation) : rotation);
  }

  act(input) {
    const slot = 2 + this.tick % (BODIES - 3);
    if (input & 32 && this.tick % 5 === 0) {
      this.scene.setShape(this.movers[slot].id, 0, this.tick % WALL);
    }
    if (input & 64 && this.tick % 7 === 0) {
      this.scene.remove(this.movers[slot].id);
      this.add(slot);
    }
    if (input & 128 && this.tick % 3 === 0) {
      const { id } = this.movers[slot];
      this.scene[this.scene.get(id).asleep ? 'wake' : 'sleep'](id);
    }
  }

  react(report, manifold) {
    const [a, b] = [report.a, report.b].map(({ slot }) => this.movers[slot]);
    if (a.id.generation !== report.a.generation || b.id.generation !== report.b.generation) {
      return;
    }
    if (report.event === Event.BEGIN) {
      [a.step, b.step] = [b.step, a.step];
    } else if (report.event === Event.PERSIST) {
      b.step[0] += (manifold !== null ? sumOf(manifold) : report.distance) % 7 - 3;
    } else {
      b.step[1] += report.partB + 1;
    }
    const [x, y] = b.step;
    b.step[0] = x > 4000 ? 3000 : x < -4000 ? -3000 : x;
    b.step[1] = y > 4000 ? -3000 : y;
  }

  play(inputs) {
    for (let slot = 0; slot < BODIES; slot++) {
      this.move(slot, slot < 2 ? inputs[slot] : 0);
    }
    inputs.forEach((input) => this.act(input));
    this.scene.update((report, manifold) => this.react(report, manifold));
    this.tick++;
  }

  hash() {
    let value = this.scene.hash();
    for (const { step, id } of this.movers) {
      for (const word of [...step, id.generation]) {
        value = (value ^ BigInt(word >>> 0)) * PRIME & MASK;
      }
    }
    return value;
  }

  save(into) {
    return { scene: this.scene.save(into), tick: this.tick, movers: this.movers.map((m) => ({ ...m, step: [...m.step] })) };
  }

  load({ scene, tick, movers }) {
    this.scene.load(scene);
    this.tick = tick;
    this.movers = movers.map((m) => ({ ...m, step: [...m.step] }));
  }
}

function inputOf(tick, player) {
  const any = new Random(BigInt(2 * tick + player)).u32();
  return any & any >>> 8 & 0xFF;
}

const match = new Match(), random = new Random(3n);
let sum = 0xCBF29CE484222325n, rollbacks = 0, saved = match.save(), savedSum = sum;
for (let i = 0; i < +process.argv[2]; i++) {
  const what = random.below(100);
  if (what < 3 || i - saved.tick > 30) {
    saved = match.save(saved.scene);
    savedSum = sum;
  } else if (what < 5) {
    match.load(saved);
    sum = savedSum;
    i = match.tick;
    rollbacks++;
  }
  match.play([inputOf(i, 0), inputOf(i, 1)]);
  sum = (sum ^ match.hash()) * PRIME & MASK;
}
const text = sum.toString(16).padStart(16, '0');
console.log(text);
process.exitCode = rollbacks > 0 && text === process.argv[3] ? 0 : 1;
