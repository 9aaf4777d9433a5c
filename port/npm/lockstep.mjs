// Two peers in lockstep: each has a module of its own, plays at once with the input that it guesses of the other, and rolls back
// when the real one comes. Only inputs travel, up to eight ticks late. At the end both have the same bits.
import { BodyKind, load } from 'gjk-exact';

const TICKS = 600, LATE = 8, UNIT = 65536;

class Peer {
  constructor({ plane }, me) {
    const walls = [[0, -5], [0, 5], [-5, 0], [5, 0]].map((at) => at.map((n) => n * UNIT));
    this.me = me;
    this.tick = this.rollbacks = 0;
    this.inputs = [[], []];  // of both, by tick; what is not known yet is as the last that is
    this.saves = [];
    const shapes = [plane.box(5 * UNIT, UNIT / 8), plane.box(UNIT / 8, 5 * UNIT), plane.circle(UNIT / 2)];
    this.scene = plane.scene(shapes, { bodies: 6 });
    walls.forEach((position, i) => this.scene.add(i < 2 ? 0 : 1, { position }));
    this.discs = [-2, 2].map((x) => ({ at: [x * UNIT, 0], step: [0, 0] }));
    this.bodies = this.discs.map(({ at }) => this.scene.add(2, { position: at, kind: BodyKind.DYNAMIC }));
  }

  input(player, tick) {
    const known = this.inputs[player];
    return known[Math.min(tick, known.length - 1)] ?? 0;
  }

  play() {
    const slot = this.saves[this.tick % (LATE + 1)];
    this.saves[this.tick % (LATE + 1)] = { scene: this.scene.save(slot?.scene), discs: structuredClone(this.discs) };
    this.discs.forEach((disc, player) => {
      const push = this.input(player, this.tick) & 3;
      disc.step[push & 1] += push & 2 ? 900 : -900;
      disc.at = disc.at.map((n, axis) => n + disc.step[axis]);
      this.scene.move(this.bodies[player], disc.at);
    });
    this.scene.update(({ a, b }) => {
      for (const body of [a, b]) {  // what touches turns back
        const disc = this.discs[body.slot - 4];
        if (disc) {
          disc.step = disc.step.map((n) => -Math.trunc(n / 2));
        }
      }
    });
    this.tick++;
  }

  // The other's input of a tick has come.
  learn(tick, input) {
    const other = 1 - this.me, wrong = tick < this.tick && this.input(other, tick) !== input, now = this.tick;
    this.inputs[other][tick] = input;
    if (wrong) {
      const { scene, discs } = this.saves[tick % (LATE + 1)];
      this.scene.load(scene);
      this.discs = structuredClone(discs);
      this.rollbacks++;
      for (this.tick = tick; this.tick < now;) {
        this.play();
      }
    }
  }
}

let dice = 1;
const roll = (limit) => (dice = Math.imul(dice, 1103515245) + 12345 >>> 0) % 65536 * limit >>> 16;
const peers = [new Peer(await load(), 0), new Peer(await load(), 1)], wires = [[], []];
for (let tick = 0; tick < TICKS + LATE; tick++) {
  for (const peer of peers) {
    if (tick < TICKS) {
      peer.inputs[peer.me][tick] = tick % 7 === 0 ? roll(4) : peer.inputs[peer.me][tick - 1];
      wires[1 - peer.me].push({ tick, input: peer.inputs[peer.me][tick], arrives: tick + roll(LATE) });
    }
    const wire = wires[peer.me];
    while (wire.length > 0 && wire[0].arrives <= tick) {
      const { tick: sent, input } = wire.shift();
      peer.learn(sent, input);
    }
    if (tick < TICKS) {
      peer.play();
    }
  }
}
const hashes = peers.map((peer) => peer.scene.hash());
console.log(hashes[0] === hashes[1] ? 'the same bits' : 'apart', peers.every((peer) => peer.rollbacks > 50));
