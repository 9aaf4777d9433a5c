// The match of tests/support/scene/match.c through gjk.js, with saves and rollbacks.
//
// scene_golden.js GJK.WASM TICKS HASH: exits with 0 if the hash over so many ticks is HASH.
'use strict';

const fs = require('fs');
const path = require('path');
const { gjkLoad } = require(path.resolve('port/wasm/gjk.js'));
const { Random } = require('./random.js');

const Q16 = 65536, BODIES = 24, WALL = 5, REACH = 3 * Q16, PRIME = 0x100000001B3n;
const CORNERS = [[30000, 2000, 1000], [-28000, 9000, -3000], [5000, 31000, 2000], [-3000, -30000, 4000],
  [1000, 2000, 33000], [-2000, 900, -31000], [20000, 20000, 12000], [-19000, -18000, -9000]];
const DETAILS = ['distance', 'touch', 'touch', 'distance', 'depth', 'contacts'];

function scramble(x) {
  x = Math.imul(x ^ x >>> 16, 0x7FEB352D);
  x = Math.imul(x ^ x >>> 15, 0x846CA68B);
  return (x ^ x >>> 16) >>> 0;
}

function dice(a, b, c, limit) {
  return scramble(scramble(scramble(a) ^ b) ^ c) % (2 * limit + 1) - limit;
}

function bounce(at, step) {
  return (at > REACH && step > 0) || (at < -REACH && step < 0) ? -step : step;
}

// The remainder of JavaScript is that of C.
function sumOf(contacts) {
  const { normal, features } = contacts;
  let sum = normal[0] % 5 + normal[1] % 7 + normal[2] % 11 + features[0] + features[1];
  for (const c of contacts.points) {
    sum += c.pointA[0] % 5 + c.pointA[1] % 7 + c.pointB[2] % 11 + c.distance % 13 + c.id;
  }
  return sum;
}

class Match {
  constructor(gjk) {
    const half = Q16 / 2, round = (units) => Math.round(units * Q16);
    this.gjk = gjk;
    const shapes = [gjk.box(half, half, half), gjk.sphere(half), gjk.capsule(round(0.25), round(0.4)),
      gjk.hull(CORNERS), gjk.cylinder(half, round(0.375)), gjk.box(6 * Q16, 6 * Q16, round(0.25))];
    this.scene = gjk.scene(shapes, { bodies: BODIES, parts: 2 * BODIES, ownPoses: BODIES, pairs: 160,
      boxMargin: round(0.1), persist: true, workspaceCells: 400 });
    shapes.forEach((shape) => gjk.release(shape));
    this.tick = 0;
    this.bodies = [];
    for (let slot = 0; slot < BODIES; slot++) {
      this.add(slot);
    }
  }

  // A quaternion by a function of the library that gjk.js has no name for.
  turn(name, ...quaternions) {
    return this.gjk.lend([...quaternions, [0, 0, 0, 0]], (...at) => {
      this.gjk.check(this.gjk.exports[name](...at));
      const out = at[at.length - 1] / 4;
      return Array.from(this.gjk.words().subarray(out, out + 4));
    });
  }

  add(slot) {
    const roll = (c, limit) => dice(slot, this.tick, c, limit);
    const fixed = slot === BODIES - 1, parts = [fixed ? WALL : slot % WALL];
    if (slot % 6 === 5 && !fixed) {
      parts.push({ shape: 1, position: [0, 0, 0.75 * Q16] });
    }
    const id = this.scene.add(parts, {
      position: fixed ? [0, 0, -REACH] : [1, 2, 3].map((c) => roll(c, REACH)),
      kind: fixed ? 'static' : slot < 2 ? 'kinematic' : 'dynamic',
      detail: DETAILS[slot % 6], user: slot, margin: slot % 4 === 0 ? Q16 / 8 : 0, slot,
    });
    this.bodies[slot] = { id, step: slot < 2 ? [0, 0, 0] : [7, 8, 9].map((c) => roll(c, 3000)),
      turn: this.turn('gjk_quat_normalize', [roll(4, 300), roll(5, 300), roll(6, 300), 30000]) };
  }

  move(slot, input) {
    const body = this.bodies[slot], state = this.scene.get(body.id);
    if (state.kind === 'static' || state.asleep) {
      return;
    }
    const push = (input & 8) !== 0 ? -2000 : 2000;
    body.step = body.step.map((step, i) => bounce(state.position[i], (input >> i & 1) !== 0 ? push : step));
    this.scene.move(body.id, state.position.map((at, i) => at + body.step[i]), slot >= 2 || (input & 16) !== 0
      ? this.turn('gjk_quat_compose', body.turn, state.quaternion) : state.quaternion);
  }

  act(input) {
    const slot = 2 + this.tick % (BODIES - 3);
    if ((input & 32) !== 0 && this.tick % 5 === 0) {
      this.scene.setShape(this.bodies[slot].id, 0, this.tick % WALL);
    }
    if ((input & 64) !== 0 && this.tick % 7 === 0) {
      this.scene.remove(this.bodies[slot].id);
      this.add(slot);
    }
    if ((input & 128) !== 0 && this.tick % 3 === 0) {
      const id = this.bodies[slot].id;
      this.scene[this.scene.get(id).asleep ? 'wake' : 'sleep'](id);
    }
  }

  react(report) {
    const a = this.bodies[report.a.slot], b = this.bodies[report.b.slot];
    if (a.id.generation !== report.a.generation || b.id.generation !== report.b.generation) {
      return;
    }
    if (report.event === 'begin') {
      [a.step, b.step] = [b.step, a.step];
    } else if (report.event === 'persist') {
      const bend = report.detail === 'contacts' ? sumOf(report.contacts) : report.distance;
      b.step[0] += bend % 7 - 3;
    } else {
      b.step[1] += report.partB + 1;
    }
    b.step[0] = b.step[0] > 4000 ? 3000 : b.step[0] < -4000 ? -3000 : b.step[0];
    b.step[1] = b.step[1] > 4000 ? -3000 : b.step[1];
  }

  play(inputs) {
    for (let slot = 0; slot < BODIES; slot++) {
      this.move(slot, slot < 2 ? inputs[slot] : 0);
    }
    inputs.forEach((input) => this.act(input));
    this.scene.update().forEach((report) => this.react(report));
    this.tick++;
  }

  hash() {
    let value = this.scene.hash();
    for (const body of this.bodies) {
      for (const word of [...body.step, body.id.generation]) {
        value = BigInt.asUintN(64, (value ^ BigInt(word >>> 0)) * PRIME);
      }
    }
    return value;
  }

  // What the game keeps besides is copied as text.
  save() { return { scene: this.scene.save(), rest: JSON.stringify([this.tick, this.bodies]) }; }

  load(save) {
    this.scene.load(save.scene);
    [this.tick, this.bodies] = JSON.parse(save.rest);
  }
}

function inputOf(tick, player) {
  const any = Number(new Random(2 * tick + player).u32());
  return any & any >>> 8 & 0xFF;
}

async function main(file, ticks, expected) {
  const match = new Match(await gjkLoad(fs.readFileSync(file))), random = new Random(3);
  let sum = 0xCBF29CE484222325n, saved = { ...match.save(), sum, tick: 0 }, rollbacks = 0;
  for (let i = 0; i < ticks; i++) {
    const what = random.below(100);
    if (what < 3 || i - saved.tick > 30) {
      saved = { ...match.save(), sum, tick: i };
    } else if (what < 5) {
      match.load(saved);
      sum = saved.sum;
      i = saved.tick;
      rollbacks++;
    }
    match.play([inputOf(i, 0), inputOf(i, 1)]);
    sum = BigInt.asUintN(64, (sum ^ match.hash()) * PRIME);
  }
  console.log(sum.toString(16).padStart(16, '0') + ' after ' + rollbacks + ' rollbacks');
  process.exitCode = sum === BigInt('0x' + expected) && rollbacks > 0 ? 0 : 1;
}

main(process.argv[2], Number(process.argv[3]), process.argv[4]);
