// The fourth view: two sides that exchange only inputs compute the same pile.
'use strict';

const PILE = { ticks: 3600, every: 60, delay: 3, width: 14, height: 9, top: 38 };

// The roles of gjk_draw_role that are drawn, in this order, each with its colour, its width and what the key calls it.
const SEEN = [
  { role: 4, name: 'box', colour: 'faint', wide: 0.7, title: 'bounding boxes' },
  { role: 5, name: 'pair', colour: 'd', wide: 1.2, title: 'pairs that are near' },
  { role: 7, name: 'normal', colour: 'good', wide: 2, title: 'normals' },
  { role: 6, name: 'contact', colour: 'ink', wide: 2, title: 'contacts' },
];

// One side: its world stands in the module, its past in snapshots of that memory.
class PileSide {
  constructor(number) {
    this.number = number;
  }

  start(bodies) {
    this.bodies = bodies;
    this.tick = 0;
    this.hashes = [];
    this.snapshots = [];
    gjk.exports.page_pile_start(this.number, bodies);
    this.keep();
  }

  memory() {
    const at = gjk.exports.page_pile_state(this.number);
    return gjk.bytes().subarray(at, at + gjk.exports.page_pile_bytes());
  }

  keep() {
    this.snapshots[this.tick / PILE.every] = this.memory().slice();
  }

  // inputs: [x, y] of each push of this tick, from either side.
  step(inputs, flip) {
    for (const [x, y] of inputs) {
      gjk.exports.page_pile_push(this.number, x, y);
    }
    if (flip !== null && flip.tick === this.tick) {
      gjk.exports.page_pile_flip(this.number, flip.body);
    }
    const hash = BigInt.asUintN(64, gjk.exports.page_pile_tick(this.number));
    this.hashes[this.tick++] = hash;
    if (this.tick % PILE.every === 0) {
      this.keep();
    }
  }

  // Back to the last snapshot at or before a tick.
  rollBack(tick) {
    const last = Math.min(Math.floor(tick / PILE.every), this.snapshots.length - 1);
    this.memory().set(this.snapshots[last]);
    this.tick = last * PILE.every;
    this.snapshots.length = last + 1;
    this.hashes.length = this.tick;
  }

  places() {
    const at = gjk.exports.page_pile_bodies(this.number) / 4;
    return gjk.words().slice(at, at + 7 * this.bodies);
  }

  // What a scene of the library sees now: [role, x, y, x, y] of each line, and of each point with both ends alike.
  seen() {
    const count = gjk.exports.page_seen_look(this.number), at = gjk.exports.page_seen_records() / 4;
    return gjk.words().slice(at, at + 5 * count);
  }
}

class LockstepView {
  constructor() {
    this.sides = [new PileSide(0), new PileSide(1)];
    this.canvases = ['Left', 'Right'].map((name, number) => {
      const canvas = element('canvas', { 'aria-label': name + ' side', role: 'img', tabindex: 0 });
      canvas.addEventListener('pointerdown', (event) => this.push(event, canvas));
      canvas.addEventListener('keydown', (event) => this.key(event, number));
      return canvas;
    });
    this.captions = this.canvases.map(() => element('div', { class: 'caption numbers' }));
    this.build();
  }

  build() {
    this.run = element('button', { type: 'button', class: 'run', onclick: () => this.toggle() }, 'Pause');
    this.flipper = element('button', { type: 'button', onclick: () => this.flipBit() }, 'Flip one bit on the right');
    this.again = element('button', { type: 'button', onclick: () => this.restart() }, 'Start again');
    this.counts = choiceOf('Bodies', [['60', '60'], ['120', '120'], ['200', '200']], (value) => {
      this.bodies = Number(value);
      this.restart();
    });
    this.slider = element('input', { type: 'range', min: 0, max: 1, value: 0, 'aria-label': 'Tick', id: 'lockstep-tick',
      oninput: () => this.goTo(Number(this.slider.value)) });
    this.count = element('output', { class: 'count' });
    this.look = element('input', { type: 'checkbox', id: 'lockstep-look', onchange: () => this.changeLook() });
    this.keys = element('span', { class: 'legend row' }, ...SEEN.map(({ name, title }) =>
      element('span', { class: 'key ' + name }, title)));
    this.verdict = element('p', { class: 'sentence', 'aria-live': 'polite' });
    this.tells = element('p', { class: 'aside' });
    this.element = element('section', { class: 'view', id: 'lockstep', 'aria-label': 'Lockstep' },
      element('div', { class: 'say' }, element('h2', {}, 'Two machines that exchange only inputs'),
        element('p', {}, 'Tap a pile to push it: the other side hears where and when, nothing else. The same bits follow, tick by tick.')),
      element('div', { class: 'stage' }, ...this.canvases.map((canvas, i) => element('div', { class: 'pane' }, canvas, this.captions[i]))),
      this.verdict, this.tells,
      element('div', { class: 'row steps' }, this.run, this.slider, this.count),
      element('div', { class: 'row' }, this.flipper, this.again, element('label', {}, 'bodies', this.counts)),
      element('div', { class: 'row' }, element('label', {}, this.look, 'Show what the scene sees'), this.keys));
    redrawWhenResized(this);
  }

  load(values) {
    const number = (name, otherwise) => (values.has(name) ? Math.trunc(Number(values.get(name))) || 0 : otherwise);
    const tick = Math.max(0, Math.min(PILE.ticks, number('tick', -1)));
    this.bodies = [60, 120, 200].includes(number('bodies', 200)) ? number('bodies', 200) : 200;
    this.restart();
    if (values.has('flip')) {
      this.flip = { tick: number('flip', 0), body: this.flippedBody() };
    }
    for (const text of (values.get('pushes') ?? '').split('_').filter((part) => part !== '')) {
      const [at, x, y] = text.split(',').map(Number);
      (this.pushes[at] ??= []).push([x, y]);
    }
    this.look.checked = values.get('look') === 'scene';
    this.target = values.has('tick') ? tick : null;
    this.running = !values.has('tick');
    this.schedule();
  }

  // The pushes of people, and the ticks at which they count; those of the players on both sides follow from the tick.
  save() {
    const pushes = Object.entries(this.pushes).flatMap(([tick, list]) => list.map((p) => [tick, ...p].join(',')));
    return { bodies: this.bodies, tick: this.target ?? this.sides[0].tick, flip: this.flip?.tick, pushes: pushes.join('_'),
      look: this.look.checked ? 'scene' : '' };
  }

  hide() {
    this.running = false;
    this.target = null;
  }

  caseText() {
    return '# This view has no pair. A link to it has every input: copy the address.\n';
  }

  restart() {
    this.pushes = {};
    this.flip = null;
    this.target = null;
    this.running = true;
    for (const side of this.sides) {
      side.start(this.bodies);
    }
    this.parted = null;
    this.furthest = 0;
    this.schedule();
    this.draw();
  }

  // What both players do at a tick: now and then one of them pushes somewhere.
  inputs(tick) {
    const mine = this.pushes[tick] ?? [];
    const turn = Math.floor(tick / 75);
    return tick % 75 === 74 ? [...mine, [(turn * 5 + 2) % PILE.width * ONE, (turn * 3 % 4) * ONE / 2]] : mine;
  }

  step() {
    const { tick } = this.sides[0], inputs = this.inputs(tick);
    this.sides[0].step(inputs, null);
    this.sides[1].step(inputs, this.flip);
    if (this.parted === null && this.sides[0].hashes[tick] !== this.sides[1].hashes[tick]) {
      this.parted = tick;
    }
  }

  schedule() {
    if (this.frame === undefined) {
      this.due = performance.now();
      this.frame = requestAnimationFrame((now) => this.tickFrame(now));
    }
  }

  // Keeps to 60 ticks a second whatever the screen does; a replay goes as fast as it can.
  tickFrame(now) {
    this.frame = undefined;
    if (page.current !== this) {
      return;
    }
    const end = performance.now() + 12;
    if (this.target !== null) {
      while (this.sides[0].tick < this.target && performance.now() < end) {
        this.step();
      }
      this.target = this.sides[0].tick >= this.target ? null : this.target;
    } else if (this.running) {
      const wanted = Math.min(3, Math.floor((now - this.due) * 60 / 1000));
      for (let i = 0; i < wanted && this.sides[0].tick < PILE.ticks; i++) {
        this.step();
      }
      this.due = wanted === 3 ? now : this.due + wanted * 1000 / 60;
      if (this.sides[0].tick >= PILE.ticks) {
        this.running = false;
      }
    }
    this.draw();
    if (this.running || this.target !== null) {
      this.frame = requestAnimationFrame((time) => this.tickFrame(time));
      if (this.sides[0].tick % 60 === 0 && this.target === null) {
        page.save();
      }
    } else {
      page.save();
    }
  }

  changeLook() {
    this.draw();
    page.save();
  }

  toggle() {
    this.running = !this.running;
    this.schedule();
    this.draw();
  }

  // Rolls both sides back, or on, to a tick: the same inputs again.
  goTo(tick) {
    this.running = false;
    this.target = tick;
    if (tick < this.sides[0].tick) {
      for (const side of this.sides) {
        side.rollBack(tick);
      }
      if (this.parted !== null && this.sides[0].tick <= this.parted) {
        this.parted = null;
      }
    }
    this.furthest = Math.max(this.furthest, tick);
    this.schedule();
  }

  flippedBody() {
    return this.bodies >> 1;
  }

  flipBit() {
    this.flip = { tick: this.sides[1].tick, body: this.flippedBody() };
    this.running = true;
    this.target = null;
    this.schedule();
  }

  // A push counts some ticks later, when the other side has heard of it.
  addPush(x, y) {
    const tick = this.sides[0].tick + PILE.delay;
    (this.pushes[tick] ??= []).push([x, y]);
    this.running = true;
    this.target = null;
    this.schedule();
  }

  push(event, canvas) {
    const box = canvas.getBoundingClientRect(), { scale, left, floor } = this.frameOf(canvas);
    this.addPush(Math.round((event.clientX - box.left - left) / scale * ONE),
      Math.round((floor - event.clientY + box.top) / scale * ONE));
  }

  key(event, number) {
    if (event.key === ' ') {
      this.toggle();
    } else if (event.key === 'Enter') {
      this.addPush((number === 0 ? 4 : 10) * ONE, ONE / 2);
    } else {
      return;
    }
    event.preventDefault();
  }

  frameOf(canvas) {
    const { clientWidth: width, clientHeight: height } = canvas;
    const scale = Math.min((width - 24) / PILE.width, (height - 60) / (PILE.height - 2));
    return { scale, left: (width - scale * PILE.width) / 2, floor: height - 14, width, height };
  }

  repaint() {
    this.draw();
  }

  draw() {
    const places = this.sides.map((side) => side.places());
    const differ = Array.from({ length: this.bodies }, (_, i) =>
      [3, 4, 5, 6].some((k) => places[0][7 * i + k] !== places[1][7 * i + k]));
    const { tick } = this.sides[0], other = differ.filter((x) => x).length;
    this.canvases.forEach((canvas, i) => this.paint(canvas, places[i], i === 1 ? differ : []));
    this.seen = this.look.checked ? this.sides.map((side) => side.seen()) : [];
    this.seen.forEach((records, i) => this.paintSeen(this.canvases[i], records));
    this.keys.hidden = !this.look.checked;
    this.sides.forEach((side, i) => {
      this.captions[i].textContent = `${['left', 'right'][i]}  ${(side.hashes.at(-1) ?? 0n).toString(16).padStart(16, '0')}`;
      this.captions[i].classList.toggle('bad', i === 1 && this.parted !== null);
    });
    this.furthest = Math.max(tick, this.target ?? 0, this.furthest);
    this.slider.max = Math.max(1, this.furthest);
    this.slider.value = this.target ?? tick;
    this.count.textContent = `tick ${tick}`;
    this.counts.set(String(this.bodies));
    this.run.textContent = this.running ? 'Pause' : 'Go on';
    this.run.disabled = tick >= PILE.ticks;
    this.flipper.disabled = tick >= PILE.ticks;
    const pushes = Object.values(this.pushes).reduce((sum, list) => sum + list.length, 0) + Math.floor((tick + 1) / 75);
    this.verdict.textContent = this.parted === null
      ? `${tick} ticks, and after each the same hash on both sides.`
      : `They part at tick ${this.parted}, by one bit of body ${this.flip.body}: now ${other} of ${this.bodies} bodies differ.`;
    this.verdict.classList.toggle('bad', this.parted !== null);
    this.tells.textContent = `Inputs sent: ${pushes}, 12 bytes each, and no position ever. Pull the slider back: both roll back and replay.`;
  }

  paint(canvas, places, differ) {
    const { scale, left, floor, width, height } = this.frameOf(canvas), ratio = devicePixelRatio;
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue('--' + name);
    const [a, aFill, b, bFill, bad, badFill, line, page] = ['a', 'a-fill', 'b', 'b-fill', 'bad', 'bad-fill', 'faint', 'page'].map(colour);
    const context = canvas.getContext('2d');
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.globalAlpha = 1;
    context.clearRect(0, 0, width, height);
    context.fillStyle = page;
    context.fillRect(0, floor, width, height - floor);
    context.strokeStyle = line;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(left, PILE.top);
    context.lineTo(left, floor);
    context.lineTo(left + PILE.width * scale, floor);
    context.lineTo(left + PILE.width * scale, PILE.top);
    context.stroke();
    context.lineWidth = 1.2;
    context.globalAlpha = this.look.checked ? 0.5 : 1;
    for (let i = 0; i < this.bodies; i++) {
      const [ball, halfX, halfY, x, y, c, s] = places.subarray(7 * i, 7 * i + 7);
      const size = scale / ONE;
      context.setTransform(ratio * c / UNIT, -ratio * s / UNIT, ratio * s / UNIT, ratio * c / UNIT,
        ratio * (left + x * size), ratio * (floor - y * size));
      context.fillStyle = differ[i] ? badFill : ball ? bFill : aFill;
      context.strokeStyle = differ[i] ? bad : ball ? b : a;
      context.beginPath();
      if (ball) {
        context.arc(0, 0, halfX * size, 0, 7);
        context.moveTo(0, 0);
        context.lineTo(halfX * size, 0);
      } else {
        context.rect(-halfX * size, -halfY * size, 2 * halfX * size, 2 * halfY * size);
      }
      context.fill();
      context.stroke();
    }
  }

  // Over the bodies, below the caption. Squares, and a path for each line, cost far less than one path of all. Lines too
  // short to be seen are left out.
  paintSeen(canvas, records) {
    const { scale, left, floor, width, height } = this.frameOf(canvas), ratio = devicePixelRatio, size = scale / ONE;
    const style = getComputedStyle(document.documentElement), context = canvas.getContext('2d');
    const thin = Math.max(0.5, Math.min(1, scale / 40)), dot = Math.round(4 * thin);
    context.save();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.beginPath();
    context.rect(0, PILE.top, width, height);
    context.clip();
    context.globalAlpha = 1;
    for (const { role, colour, wide } of SEEN) {
      context.strokeStyle = context.fillStyle = style.getPropertyValue('--' + colour);
      context.lineWidth = wide * thin;
      for (let i = 0; i < records.length; i += 5) {
        if (records[i] === role) {
          const x0 = left + records[i + 1] * size, y0 = floor - records[i + 2] * size;
          const x1 = left + records[i + 3] * size, y1 = floor - records[i + 4] * size;
          if (x0 === x1 && y0 === y1) {
            context.fillRect(Math.round(x0 - dot / 2), Math.round(y0 - dot / 2), dot, dot);
          } else if (Math.abs(x1 - x0) + Math.abs(y1 - y0) > 0.5) {
            context.beginPath();
            context.moveTo(x0, y0);
            context.lineTo(x1, y1);
            context.stroke();
          }
        }
      }
    }
    context.restore();
  }
}

VIEWS.push({ name: 'lockstep', title: 'Lockstep', make: () => new LockstepView() });
