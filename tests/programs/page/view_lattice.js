// The second view: B at each point of a lattice, as the library, double and float see it.
'use strict';

// u, v: the steps from dot to dot; else along two axes, by a step of so many LSB.
const LATTICE_PAIRS = {
  determinants: {
    title: 'Two hulls of 2,000 units', u: [4074, 557, 158], v: [8287, -1096, 173],
    tells: 'From column to column the determinant that decides grows by 1. Double loses its sign, island by island.',
    text: 'case determinants;A hull 5;89677824 68059136 7192576;46096384 -86016000 -4358144;-46096384 86016000 4358144;-89677824 -68059136 -7192576;0 0 -67108864;B hull 4;0 0 0;44739242 0 67108864;-44739242 33554432 67108864;0 -44739242 67108864;B at 10977700 5377200 683800',
  },
  crates: {
    title: 'Two crates', u: null, v: null,
    tells: 'Ordinary crates, an LSB from dot to dot. Double is right here; float is not.',
    text: 'case crates;A box 32768 32768 32768;A turn 98149375 196298749 294448124 1008987269;B box 24576 24576 40960;B at 61000 47000 21000;B turn -471054074 235527037 235527037 905584669',
  },
  needle: {
    title: 'A long hull and a needle', u: null, v: null,
    tells: 'Some 40 units long, an LSB from dot to dot. The larger the tolerance, the more contacts double invents.',
    text: 'case needle;A hull 13;428888 -76329 294014;-65737 23951 -178591;-485736 115726 879504;265075 306028 -1210524;-610640 -3281 -1051138;-310858 -359995 43285;311853 -363302 1388204;142749 68954 -286792;-89007 -196462 82992;63708 197664 886986;245918 288115 580606;-384602 124406 1028876;495023 -139799 -950539;A at 91684638 12377080 80078606;A turn 722951558 -347108623 -645390329 -305367773;B segment 627518;B at 91189256 12588467 80752101;B turn -204601207 -793233777 205970935 -662884605',
  },
};

const LATTICE_METHODS = [['gjk', 1, 'the library, exact'], ['double', 2, 'double'], ['float', 4, 'float']];

class LatticeView {
  constructor() {
    this.panes = LATTICE_METHODS.map(([name, bit]) => this.pane(name, bit));
    this.build();
  }

  pane(name, bit) {
    const canvas = element('canvas', { 'aria-label': 'What ' + name + ' answers', role: 'img', tabindex: 0 });
    const caption = element('div', { class: 'caption' });
    const made = { name, bit, canvas, caption, element: element('div', { class: 'pane dots' }, canvas, caption) };
    canvas.addEventListener('pointerdown', (event) => this.grab(event, canvas));
    canvas.addEventListener('pointermove', (event) => this.point(event, canvas));
    canvas.addEventListener('pointerup', () => this.drop());
    canvas.addEventListener('pointercancel', () => this.drop());
    canvas.addEventListener('keydown', (event) => this.key(event));
    return made;
  }

  build() {
    this.pairs = element('select', { 'aria-label': 'Pair', onchange: () => this.choosePair() },
      ...Object.entries(LATTICE_PAIRS).map(([name, { title }]) => element('option', { value: name }, title)));
    this.tolerance = element('input', { type: 'range', min: -36, max: -8, step: 1, 'aria-label': 'Tolerance of double, a power of ten',
      oninput: () => this.set({ tolerance: Number(this.tolerance.value) }) });
    this.best = element('button', { type: 'button', onclick: () => this.set({ tolerance: -30 }) }, 'Its best');
    this.toleranceText = element('output', { class: 'tolerance' });
    this.steps = choiceOf('LSB from dot to dot', [['1', '1'], ['16', '16'], ['256', '256']], (value) => this.set({ step: Number(value) }));
    this.tells = element('p', {});
    this.verdict = element('p', { class: 'sentence', 'aria-live': 'polite' });
    this.rows = element('dl', { class: 'integers numbers' });
    this.element = element('section', { class: 'view', id: 'lattice', 'aria-label': 'Almost touching' },
      element('div', { class: 'say' }, element('h2', {}, 'Almost touching: every dot is a place of B'), this.tells),
      element('div', { class: 'stage three' }, ...this.panes.map((pane) => pane.element)),
      element('div', { class: 'row legend' },
        element('span', { class: 'key touching' }, 'touching'), element('span', { class: 'key apart' }, 'apart'),
        element('span', { class: 'key wrong' }, 'wrongly touching'), element('span', { class: 'key missed' }, 'wrongly apart')),
      this.verdict, this.rows,
      element('div', { class: 'row' }, this.pairs,
        element('label', { class: 'wide' }, 'tolerance', this.tolerance, this.toleranceText), this.best,
        element('label', {}, 'LSB a dot', this.steps)));
    redrawWhenResized(this);
  }

  load(values) {
    this.chosen = LATTICE_PAIRS[values.get('pair')] === undefined ? 'determinants' : values.get('pair');
    const number = (name, otherwise) => (values.has(name) ? Math.trunc(Number(values.get(name))) || 0 : otherwise);
    this.count = innerWidth < 760 ? 37 : 45;
    this.tolerance10 = Math.max(-36, Math.min(-8, number('tolerance', -30)));
    this.step = [1, 16, 256].includes(number('step', 1)) ? number('step', 1) : 1;
    this.middle = [number('x', 0), number('y', 0)].map((m) => Math.max(-2000, Math.min(2000, m)));
    this.cursor = this.inside([number('i', 4), number('k', 0)]);
    this.open();
    this.compute();
  }

  save() {
    return { pair: this.chosen, tolerance: this.tolerance10, step: this.step, x: this.middle[0], y: this.middle[1],
      i: this.cursor[0], k: this.cursor[1] };
  }

  // The pair, B moved to where it touches but for the rounding of a step, and the steps of the lattice.
  open() {
    const pair = LATTICE_PAIRS[this.chosen];
    this.shown = parseCase(address.unpack(pair.text));
    this.u = pair.u;
    this.v = pair.v;
    if (this.u === null) {
      const found = ask(writeCase(this.shown), 'penetration'), length = found.distance ?? -found.depth;
      this.shown.B.at = this.shown.B.at.map((x, k) => Math.round(x - found.normal[k] / UNIT * length));
      // The axes along which least is seen of the border are left out.
      const order = [0, 1, 2].sort((p, q) => Math.abs(found.normal[q]) - Math.abs(found.normal[p])).slice(0, 2).sort();
      [this.u, this.v] = order.map((axis) => [0, 1, 2].map((k) => (k === axis ? 1 : 0)));
    }
  }

  // Where B is at a point of the lattice, as an offset.
  offset(i, k) {
    const by = LATTICE_PAIRS[this.chosen].u === null ? this.step : 1;
    return [0, 1, 2].map((m) => by * ((this.middle[0] + i) * this.u[m] + (this.middle[1] + k) * this.v[m]));
  }

  caseAt([i, k]) {
    const offset = this.offset(i, k);
    return writeCase({ ...this.shown, id: this.chosen, B: { ...this.shown.B, at: this.shown.B.at.map((x, m) => x + offset[m]) } });
  }

  caseText() {
    return this.caseAt(this.cursor);
  }

  choosePair() {
    this.chosen = this.pairs.value;
    this.middle = [0, 0];
    this.cursor = [4, 0];
    this.open();
    this.compute();
  }

  set(changes) {
    this.tolerance10 = changes.tolerance ?? this.tolerance10;
    this.step = changes.step ?? this.step;
    this.compute();
  }

  compute() {
    const half = (this.count - 1) / 2, at = gjk.putText(writeCase(this.shown)), { exports } = gjk;
    exports.page_lattice_open(at);
    exports.gjk_port_release(at);
    const steps = exports.gjk_port_allocate(36), by = LATTICE_PAIRS[this.chosen].u === null ? this.step : 1;
    gjk.words().set([...this.offset(-half, -half), ...this.u.map((x) => by * x), ...this.v.map((x) => by * x)], steps / 4);
    const cells = exports.page_lattice(steps, this.count, 10 ** this.tolerance10);
    this.cells = gjk.bytes().slice(cells, cells + this.count ** 2);
    exports.gjk_port_release(steps);
    this.draw();
    page.save();
  }

  cell([i, k]) {
    const half = (this.count - 1) / 2;
    return this.cells[(k + half) * this.count + i + half];
  }

  repaint() {
    this.draw();
  }

  draw() {
    const fixed = LATTICE_PAIRS[this.chosen].u !== null;
    this.pairs.value = this.chosen;
    this.tells.textContent = LATTICE_PAIRS[this.chosen].tells;
    this.tolerance.value = this.tolerance10;
    this.toleranceText.textContent = '10' + superscript(this.tolerance10);
    this.steps.set(String(this.step));
    for (const button of this.steps.children) {
      button.disabled = fixed;
    }
    for (const pane of this.panes) {
      this.paint(pane);
    }
    this.tell();
  }

  // The pitch of the dots, and where the middle one is, in pixels.
  frame(canvas) {
    const { clientWidth: width, clientHeight: height } = canvas;
    return { width, height, pitch: Math.min(width - 8, height - 40) / this.count, x: width / 2, y: height / 2 + 15 };
  }

  paint({ bit, canvas, caption, name }) {
    const { width, height, pitch, x, y } = this.frame(canvas), half = (this.count - 1) / 2;
    const ratio = devicePixelRatio, style = getComputedStyle(document.documentElement);
    const colour = (value) => style.getPropertyValue('--' + value);
    const [touching, apart, bad, ink] = ['a', 'line', 'bad', 'ink'].map(colour);
    const context = canvas.getContext('2d');
    let wrong = 0;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    context.scale(ratio, ratio);
    for (let k = -half; k <= half; k++) {
      for (let i = -half; i <= half; i++) {
        const cell = this.cell([i, k]), says = (cell & bit) !== 0, right = says === ((cell & 1) !== 0);
        const size = right ? pitch * (says ? 0.3 : 0.17) : pitch * 0.42;
        context.beginPath();
        context.arc(x + i * pitch, y - k * pitch, right || says ? size : pitch * 0.34, 0, 7);
        context.fillStyle = right ? (says ? touching : apart) : bad;
        context.strokeStyle = bad;
        context.lineWidth = Math.max(1, pitch * 0.16);
        if (right || says) {
          context.fill();
        } else {
          context.stroke();
        }
        wrong += right ? 0 : 1;
      }
    }
    const [i, k] = this.cursor;
    context.strokeStyle = ink;
    context.lineWidth = 2;
    context.strokeRect(x + (i - 0.75) * pitch, y - (k + 0.75) * pitch, 1.5 * pitch, 1.5 * pitch);
    const all = this.cells.length, proven = this.cells.filter((cell) => (cell & 8) !== 0).length;
    caption.textContent = bit === 1 ? `gjk: ${proven.toLocaleString('en')} of ${all.toLocaleString('en')} proven` : `${name}: ${wrong.toLocaleString('en')} of ${all.toLocaleString('en')} wrong`;
    caption.classList.toggle('bad', wrong > 0);
  }

  // The certificate of the point under the cursor.
  tell() {
    const cell = this.cell(this.cursor), answer = ask(this.caseAt(this.cursor), 'intersect', 0, PROOF | POSED);
    const says = (bit) => ((cell & bit) !== 0 ? 'touching' : 'apart');
    const others = LATTICE_METHODS.slice(1).map(([name, bit]) => `${name} says ${says(bit)}${says(bit) === says(1) ? '' : ', wrong'}`);
    this.verdict.textContent = `At the square they are ${says(1) === 'apart' ? 'apart' : 'touching'}; ${others.join('; ')}.`;
    const rows = [['B at', this.offset(...this.cursor).map((x, m) => exact(x + this.shown.B.at[m])).join(', ')],
      ...proofRows(answer)];
    this.rows.replaceChildren(...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]));
  }

  // Pointing, dragging, keys.

  at(event, canvas) {
    const box = canvas.getBoundingClientRect(), { pitch, x, y } = this.frame(canvas);
    return [Math.round((event.clientX - box.left - x) / pitch), Math.round((y - event.clientY + box.top) / pitch)];
  }

  inside(cursor) {
    const half = (this.count - 1) / 2;
    return cursor.map((c) => Math.max(-half, Math.min(half, c)));
  }

  move(cursor) {
    const held = this.inside(cursor);
    if (held[0] !== this.cursor[0] || held[1] !== this.cursor[1]) {
      this.cursor = held;
      this.draw();
      page.save();
    }
  }

  grab(event, canvas) {
    this.held = { at: this.at(event, canvas), middle: [...this.middle] };
    canvas.setPointerCapture(event.pointerId);
    this.move(this.held.at);
  }

  point(event, canvas) {
    const now = this.at(event, canvas);
    if (this.held === undefined) {
      if (event.pointerType === 'mouse') {
        this.move(now);
      }
      return;
    }
    const middle = this.held.middle.map((m, k) => m + this.held.at[k] - now[k]);
    if (middle[0] !== this.middle[0] || middle[1] !== this.middle[1]) {
      this.middle = middle.map((m) => Math.max(-2000, Math.min(2000, m)));
      this.compute();
    }
  }

  drop() {
    this.held = undefined;
  }

  key(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (way === undefined || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    event.preventDefault();
    if (event.shiftKey) {
      this.middle = this.middle.map((m, k) => Math.max(-2000, Math.min(2000, m + 5 * way[k])));
      this.compute();
    } else {
      this.move(this.cursor.map((c, k) => c + way[k]));
    }
  }
}

function superscript(number) {
  return String(number).replace(/./g, (c) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);
}

// A certificate of a decision in space as rows of exact integers that a reader can check.
function proofRows({ proof, posed }) {
  const dot = (p, d) => p.reduce((sum, x, k) => sum + BigInt(x) * d[k], 0n);
  if (proof.name === 'direction') {
    const d = proof.direction.map(BigInt);
    const reach = posed.A.map((p) => dot(p, d)).reduce((m, x) => (x > m ? x : m));
    const start = posed.B.map((p) => dot(p, d)).reduce((m, x) => (x < m ? x : m));
    return [['direction d', proof.direction.map(exact).join(', ')], ['A reaches', exact(reach) + ' along d'],
      ['B begins', exact(start) + ' along d'], ['gap', exact(start - reach) + (proof.proven ? ' > 0: proven apart' : '')]];
  }
  if (proof.pairs === undefined) {
    return [['certificate', proof.name + (proof.proven ? ': proven' : '')]];
  }
  const w = proof.pairs.map((name) => {
    const [a, b] = name.split('-').map((text) => Number(text.slice(1)));
    return posed.A[a].map((x, k) => BigInt(x) - BigInt(posed.B[b][k]));
  });
  const rows = [['vertices', proof.pairs.map((name) => name.replace('-', '−')).join(', ') + ' hold the origin']];
  const det = (p, q, r) => p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  if (w.length === 4) {
    const [p, q, r, s] = w, signs = [det(p, q, r), -det(p, q, s), det(p, r, s), -det(q, r, s)];
    rows.push(['determinants', signs.map(exact).join(',  ')], ['of one sign', proof.proven ? 'proven touching' : '']);
  } else if (w.length === 3) {
    rows.push(['determinant', exact(det(...w)) + (proof.proven ? ': proven touching' : '')]);
  } else {
    rows.push(['differences', w.map((p) => p.map(exact).join(', ')).join('; ') + (proof.proven ? ': proven touching' : '')]);
  }
  return rows;
}

VIEWS.push({ name: 'lattice', title: 'Almost touching', make: () => new LatticeView() });
