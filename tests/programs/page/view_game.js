// The fifth view: the platform game of the examples, on a level of tiles.
'use strict';

const GAME = { width: 40, height: 10, ticks: 3600 };

// The roles of game.h's records: colour, width.
const GAME_ROLES = { 0: ['line', 1], 1: ['a', 1.5], 2: ['faint', 1], 100: ['accent', 2.5], 101: ['ink', 2.5] };

class GameView {
  constructor() {
    this.canvas = element('canvas', { 'aria-label': 'The game', role: 'img', tabindex: 0 });
    this.canvas.addEventListener('pointerdown', () => this.jump());
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    this.caption = element('div', { class: 'caption numbers' });
    this.run = element('button', { type: 'button', class: 'run', onclick: () => this.toggle() }, 'Pause');
    this.again = element('button', { type: 'button', onclick: () => this.restart() }, 'Start again');
    this.count = element('output', { class: 'count' });
    this.verdict = element('p', { class: 'sentence', 'aria-live': 'polite' });
    this.element = element('section', { class: 'view', id: 'game', 'aria-label': 'Game' },
      element('div', { class: 'say' }, element('h2', {}, 'A platform game on tiles'),
        element('p', {}, 'The level is 120 bytes, a lift and 80 crates fall on it, and the runner slides over every joint. Tap to jump. ' +
          'The same C runs on a Cortex-M3.')),
      element('div', { class: 'stage' }, element('div', { class: 'pane' }, this.canvas, this.caption)),
      this.verdict, element('div', { class: 'row' }, this.run, this.again, this.count));
    redrawWhenResized(this);
  }

  // jumps: the ticks at which the runner was told to.
  load(values) {
    const tick = Math.max(0, Math.min(GAME.ticks, Math.trunc(Number(values.get('tick') ?? 0)) || 0));
    this.restart();
    this.jumps = (values.get('jumps') ?? '').split('_').filter((text) => /^\d+$/.test(text)).map(Number);
    while (values.has('tick') && this.tick < tick && this.fine) {
      this.step();
    }
    this.running = !values.has('tick');
    this.draw();
  }

  save() {
    return { tick: this.tick, jumps: this.jumps.join('_') };
  }

  hide() {
    this.running = false;
  }

  caseText() {
    return '# This view has no pair. A link to it has every input: copy the address.\n';
  }

  restart() {
    this.tick = 0;
    this.jumps = [];
    this.fine = gjk.exports.page_game_start() === 1;
    this.running = true;
    this.schedule();
    this.draw();
  }

  step() {
    if (this.jumps.includes(this.tick)) {
      gjk.exports.page_game_jump();
    }
    this.fine = gjk.exports.page_game_tick() === 1;
    this.tick++;
  }

  schedule() {
    if (this.frame === undefined) {
      this.due = performance.now();
      this.frame = requestAnimationFrame((now) => this.tickFrame(now));
    }
  }

  // Keeps to 60 ticks a second whatever the screen does.
  tickFrame(now) {
    this.frame = undefined;
    if (page.current !== this || !this.running) {
      return;
    }
    const wanted = Math.max(0, Math.min(3, Math.floor((now - this.due) * 60 / 1000)));
    for (let i = 0; i < wanted && this.tick < GAME.ticks && this.fine; i++) {
      this.step();
    }
    this.due = wanted === 3 ? now : this.due + wanted * 1000 / 60;
    this.running = this.tick < GAME.ticks && this.fine;
    this.draw();
    this.frame = requestAnimationFrame((time) => this.tickFrame(time));
    if (wanted > 0 && this.tick % 60 === 0) {
      page.save();
    }
  }

  toggle() {
    this.running = !this.running && this.tick < GAME.ticks;
    this.schedule();
    this.draw();
    page.save();
  }

  jump() {
    this.jumps.push(this.tick);
    this.running = this.tick < GAME.ticks;
    this.schedule();
  }

  key(event) {
    if (event.key === ' ') {
      this.jump();
    } else if (event.key === 'Enter') {
      this.toggle();
    } else {
      return;
    }
    event.preventDefault();
  }

  repaint() {
    this.draw();
  }

  draw() {
    const count = gjk.exports.page_game_look(), at = gjk.exports.page_game_records() / 4;
    this.paint(gjk.words().slice(at, at + 5 * count));
    this.caption.textContent = BigInt.asUintN(64, gjk.exports.page_game_hash()).toString(16).padStart(16, '0');
    this.count.textContent = `tick ${this.tick}`;
    this.run.textContent = this.running ? 'Pause' : 'Go on';
    this.run.disabled = this.tick >= GAME.ticks;
    this.verdict.textContent = this.fine ? 'No normal but the ground’s: tiles side by side are one outline.' : 'A call has failed.';
    this.verdict.classList.toggle('bad', !this.fine);
  }

  paint(records) {
    const { clientWidth: width, clientHeight: height } = this.canvas, ratio = devicePixelRatio;
    const scale = Math.max(1, Math.min((width - 24) / GAME.width, (height - 50) / GAME.height));
    const left = (width - scale * GAME.width) / 2, floor = (height + scale * GAME.height) / 2, size = scale / ONE;
    const style = getComputedStyle(document.documentElement), context = this.canvas.getContext('2d');
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (let i = 0; i < records.length; i += 5) {
      const [colour, wide] = GAME_ROLES[records[i]] ?? ['faint', 1];
      context.strokeStyle = style.getPropertyValue('--' + colour);
      context.lineWidth = wide;
      context.beginPath();
      context.moveTo(left + records[i + 1] * size, floor - records[i + 2] * size);
      context.lineTo(left + records[i + 3] * size, floor - records[i + 4] * size);
      context.stroke();
    }
  }
}

VIEWS.push({ name: 'game', title: 'Game', make: () => new GameView() });
