// The first view: two shapes of the plane, their Minkowski difference, and GJK's steps on it.
'use strict';

const IDEA_EXAMPLES = {
  'Apart': 'case2 apart;A polygon 5;-98000 -52000;20000 -90000;78000 -20000;40000 72000;-60000 60000;A at -130000 20000;' +
    'B polygon 4;-60000 -70000;66000 -50000;52000 60000;-40000 52000;B at 130000 -10000;B turn 1008987269 367241333',
  'Overlapping': 'case2 overlapping;A polygon 5;-98000 -52000;20000 -90000;78000 -20000;40000 72000;-60000 60000;A at -40000 10000;' +
    'B polygon 4;-60000 -70000;66000 -50000;52000 60000;-40000 52000;B at 52000 4000;B turn 1008987269 367241333',
  'One LSB apart': 'case2 one-lsb;A box 100000 60000;A at -100000 0;B box 70000 90000;B at 70001 20000',
  'Round': 'case2 round;A ellipse 100000 60000;A at -120000 0;A turn 929887697 536870912;B segment 70000;B round 30000;B at 110000 20000;B turn 759250125 759250125',
  'Crate on crate': 'case2 crates;A box 110000 60000;A at 0 -60000;B box 60000 60000;B at 40000 59000',
};

class IdeaView {
  constructor() {
    this.left = new PlanePane('The shapes A and B', 'The shapes');
    this.right = new PlanePane('Their Minkowski difference A − B', 'The difference A − B');
    this.question = 'distance';
    this.step = Infinity;
    this.chosen = 'B';
    this.build();
    this.listen();
  }

  build() {
    this.questions = choiceOf('Question', [['distance', 'Distance'], ['penetration', 'Depth'], ['contacts', 'Contacts'],
      ['cast', 'Cast']], (value) => this.turnTo(value));
    this.examples = element('select', { 'aria-label': 'Example', onchange: () => this.showExample() },
      ...['Examples …', ...Object.keys(IDEA_EXAMPLES)].map((name) => element('option', { value: name }, name)));
    this.kinds = element('select', { 'aria-label': 'Kind of the chosen shape', onchange: () => this.changeKind() },
      ...['polygon', 'box', 'segment', 'point', 'ellipse'].map((name) => element('option', { value: name }, name)));
    this.round = element('input', { type: 'range', min: 0, max: 65536, step: 256, 'aria-label': 'Convex radius',
      oninput: () => this.changeRound() });
    this.more = element('button', { type: 'button', onclick: () => this.changeCorners(1) }, 'Add corner');
    this.less = element('button', { type: 'button', onclick: () => this.changeCorners(-1) }, 'Remove corner');
    this.names = choiceOf('Shape', [['A', 'A'], ['B', 'B']], (value) => this.choose(value));
    this.slider = element('input', { type: 'range', min: 0, max: 1, value: 1, 'aria-label': 'Step', id: 'idea-step',
      oninput: () => this.goTo(Number(this.slider.value)) });
    this.back = element('button', { type: 'button', 'aria-label': 'Step back', onclick: () => this.goTo(this.shownStep() - 1) }, '◀');
    this.on = element('button', { type: 'button', 'aria-label': 'Step on', onclick: () => this.goTo(this.shownStep() + 1) }, '▶');
    this.count = element('output', { class: 'count' });
    this.say = element('p', { class: 'sentence', 'aria-live': 'polite' });
    this.rows = element('dl', { class: 'integers numbers' });
    this.element = element('section', { class: 'view', id: 'idea', 'aria-label': 'The idea' },
      element('div', { class: 'say' }, element('h2', {}, 'Two shapes are one question about a point'),
        element('p', {}, 'Drag the shapes, their corners, their handles. Every number is an integer, 65,536 to a unit, and every sign is exact.')),
      element('div', { class: 'stage' }, this.left.element, this.right.element),
      element('div', { class: 'row steps' }, this.back, this.slider, this.on, this.count),
      this.say, this.rows,
      element('div', { class: 'row' }, this.questions, this.examples, element('span', { class: 'rule' }), this.names, this.kinds,
        element('label', {}, 'round', this.round), this.more, this.less));
  }

  listen() {
    const surface = this.left.svg;
    surface.setAttribute('tabindex', 0);
    surface.addEventListener('pointerdown', (event) => this.grab(event));
    surface.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel']) {
      surface.addEventListener(end, () => this.drop());
    }
    surface.addEventListener('keydown', (event) => this.key(event));
    redrawWhenResized(this);
  }

  load(values) {
    const found = parseCase(address.unpack(values.get('case') ?? IDEA_EXAMPLES.Apart));
    this.shown = found?.plane ? found : parseCase(address.unpack(IDEA_EXAMPLES.Apart));
    this.question = askedOf(values);
    giveWay(this.shown, this.question);
    this.step = values.has('step') ? Number(values.get('step')) : Infinity;
    this.fit();
    this.update();
  }

  save() {
    return { ask: this.question, step: this.step === Infinity ? '' : this.step, case: address.pack(writeCase(this.shown)) };
  }

  caseText() {
    return writeCase(this.shown);
  }

  showExample() {
    const text = IDEA_EXAMPLES[this.examples.value];
    this.examples.selectedIndex = 0;
    if (text !== undefined) {
      this.shown = parseCase(address.unpack(text));
      this.step = Infinity;
      this.fit();
      this.update();
    }
  }

  turnTo(question) {
    this.question = question;
    this.step = Infinity;
    if (giveWay(this.shown, question)) {
      this.fit();
    }
    this.update();
  }

  // Both panes show all that there is.
  fit() {
    const { A, B } = this.shown;
    const around = (shape, at) => outlineOf(shape, at).flatMap(([x, y]) =>
      [[x - shape.round, y - shape.round], [x + shape.round, y + shape.round]]);
    this.left.fit([...around(A), ...around(B), ...(B.to === null || this.question !== 'cast' ? [] : around(B, B.to))]);
    this.fitDifference();
  }

  fitDifference() {
    const { A, B } = this.shown, cast = this.question === 'cast' && B.to !== null;
    this.right.fit([...differenceOf(outlineOf(A), outlineOf(B)), [0, 0], ...(cast ? [B.to.map((x, k) => x - B.at[k])] : [])]);
  }

  // Asks the library again, and draws.
  update() {
    const text = writeCase(this.shown), margin = this.question === 'contacts' ? 4096 : 0;
    this.answer = ask(text, this.question, margin, TRACE | PROOF | POSED);
    this.steps = stepsOf(this.question, this.answer);
    this.draw();
    page.save();
  }

  shownStep() {
    return Math.max(0, Math.min(this.step, this.steps.length - 1));
  }

  goTo(step) {
    this.step = step >= this.steps.length - 1 ? Infinity : Math.max(0, step);
    this.draw();
    page.save();
  }

  choose(name) {
    this.chosen = name;
    this.draw();
  }

  changeKind() {
    const shape = this.shown[this.chosen], corners = outlineOf({ ...shape, turn: [UNIT, 0] }, [0, 0]);
    shape.kind = this.kinds.value;
    shape.vertices = [];
    shape.size = { box: [72000, 52000], segment: [72000], ellipse: [80000, 52000] }[shape.kind] ?? [];
    if (shape.kind === 'point' || shape.kind === 'segment') {
      shape.round = shape.round || 26624;
    } else if (shape.kind === 'polygon') {
      shape.vertices = corners.length > 2 && corners.length < 9 ? corners.map((p) => p.map(Math.round))
        : [[-60000, -50000], [70000, -40000], [0, 70000]];
    }
    this.update();
  }

  changeRound() {
    this.shown[this.chosen].round = Number(this.round.value);
    this.update();
  }

  // A corner more in the middle of the longest side, a little outside; or the last one less.
  changeCorners(by) {
    const { vertices } = this.shown[this.chosen];
    if (by < 0) {
      vertices.pop();
    } else {
      const length = (i) => Math.hypot(...[0, 1].map((k) => vertices[(i + 1) % vertices.length][k] - vertices[i][k]));
      const at = vertices.reduce((best, _, i) => (length(i) > length(best) ? i : best), 0);
      const p = vertices[at], q = vertices[(at + 1) % vertices.length];
      vertices.splice(at + 1, 0, [0, 1].map((k) => Math.round((p[k] + q[k]) / 2 + (k === 0 ? q[1] - p[1] : p[0] - q[0]) / 8)));
    }
    this.update();
  }

  // What is drawn.

  draw() {
    const step = this.steps[this.shownStep()], chosen = this.shown[this.chosen];
    this.questions.set(this.question);
    this.names.set(this.chosen);
    this.kinds.value = ['triangle', 'polygon'].includes(chosen.kind) ? 'polygon' : chosen.kind;
    this.round.value = chosen.round;
    this.more.disabled = chosen.kind !== 'polygon' || chosen.vertices.length >= 12;
    this.less.disabled = chosen.kind !== 'polygon' || chosen.vertices.length <= 1;
    this.slider.max = this.steps.length - 1;
    this.slider.value = this.shownStep();
    this.slider.disabled = this.steps.length < 2;
    this.back.disabled = this.shownStep() === 0;
    this.on.disabled = this.shownStep() === this.steps.length - 1;
    this.count.textContent = `${this.shownStep()} of ${this.steps.length - 1}`;
    this.say.textContent = step.say;
    this.rows.replaceChildren(...step.numbers.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]));
    this.drawShapes(step);
    this.drawDifference(step);
  }

  drawShapes(step) {
    const pane = this.left, { A, B } = this.shown, answer = this.answer;
    pane.clear();
    pane.reserve(0, 0, 150, 30);
    if (this.question === 'cast' && B.to !== null) {
      pane.body(outlineOf(B, B.to), B.round, 'b ghost', { 'data-part': 'to' });
      if (answer.at !== undefined && step.answer) {
        pane.body(outlineOf(B, answer.at), B.round, 'b rest');
      }
    }
    for (const [name, shape] of [['A', A], ['B', B]]) {
      pane.body(outlineOf(shape), shape.round, name.toLowerCase(), { 'data-part': name });
    }
    if (this.question === 'cast' && B.to !== null) {
      pane.arrow(B.at, B.to, 'way');
    }
    this.drawHandles(this.chosen, this.shown[this.chosen]);
    if (step.answer && answer.a !== undefined && answer.contacts.length === 0) {
      pane.line([answer.a, answer.b], 'gap');
      for (const p of [answer.a, answer.b]) {
        pane.dot(p, 'witness');
      }
      const length = answer.distance ?? answer.depth;
      if (length !== undefined) {
        pane.label(answer.a.map((x, k) => (x + answer.b[k]) / 2), units(length), 'measure');
      }
    }
    for (const contact of step.answer ? answer.contacts : []) {
      pane.dot(contact.a, 'contact', 6);
      pane.dot(contact.b, 'contact', 6);
    }
    for (const [letter, points] of Object.entries(answer.posed)) {
      const at = this.shown[letter].at;
      points.slice(0, points.length <= 9 ? 9 : 0).forEach((p, i) => {
        pane.label(p, letter + i, 'name ' + letter.toLowerCase(), at);
      });
    }
    if (step.support !== undefined) {
      pane.dot(step.support.a, 'support a', 6);
      pane.dot(step.support.b, 'support b', 6);
    }
  }

  // Corners, and a handle to turn by, of the chosen shape.
  drawHandles(name, shape) {
    const pane = this.left, [c, s] = shape.turn.map((x) => x / UNIT);
    shape.vertices.forEach(([x, y], i) => {
      const p = [shape.at[0] + c * x - s * y, shape.at[1] + s * x + c * y];
      pane.dot(p, 'grip ' + name.toLowerCase(), 6).dataset.part = name + i;
    });
    const far = this.handleReach(shape);
    const end = [shape.at[0] + c * far, shape.at[1] + s * far];
    pane.line([shape.at, end], 'stick');
    pane.dot(end, 'turn ' + name.toLowerCase(), 7).dataset.part = 'turn';
  }

  handleReach(shape) {
    return Math.max(0, ...outlineOf({ ...shape, turn: [UNIT, 0] }, [0, 0]).map(([x]) => x)) + shape.round + 24 / this.left.scale;
  }

  drawDifference(step) {
    const pane = this.right, { A, B } = this.shown;
    const difference = differenceOf(outlineOf(A), outlineOf(B)), radius = A.round + B.round;
    pane.clear();
    pane.reserve(0, 0, 190, 30);
    pane.body(difference, 0, 'd');
    if (radius > 0) {
      pane.dot([0, 0], 'radius', radius * pane.scale);
    }
    if (this.question === 'cast' && B.to !== null) {
      pane.arrow([0, 0], B.to.map((x, k) => x - B.at[k]), 'way');
    }
    if (step.polygon !== undefined) {
      pane.line(step.polygon, 'expanding', true);
      pane.line(step.edge, 'lowest');
      pane.dot(step.foundAt, 'found');
    }
    this.drawSearch(step, middleOf(difference));
    this.drawOrigin();
  }

  drawSearch(step, middle) {
    const pane = this.right, spanned = step.simplex.map((name) => step.w[name] ?? this.named(name));
    if (spanned.length > 0 && step.polygon === undefined) {
      pane.line(spanned, 'simplex', true);
    }
    for (const [name, at] of Object.entries(step.w)) {
      pane.dot(at, step.simplex.includes(name) ? 'vertex' : 'vertex left-out');
      pane.label(at, name, 'name d', middle);
    }
    if (step.found !== undefined) {
      const from = step.before.length > 0 ? nearestToOrigin(step.before) : middle;
      const length = Math.hypot(...step.direction) || 1, long = 54 / pane.scale;
      pane.across(step.w[step.found], step.direction, 'bound');
      pane.arrow(from, from.map((x, k) => x + step.direction[k] / length * long), 'direction');
      pane.dot(step.w[step.found], 'found');
    }
    if (step.answer && this.answer.distance > 0 && spanned.length > 0) {
      pane.line([[0, 0], nearestToOrigin(spanned)], 'gap');
    }
  }

  // A vertex that no iteration found, 'A1-B2'.
  named(name) {
    const [a, b] = name.split('-').map((text) => Number(text.slice(1)));
    return this.answer.posed.A[a].map((x, k) => x - this.answer.posed.B[b][k]);
  }

  drawOrigin() {
    const pane = this.right, [x, y] = pane.to([0, 0]);
    pane.svg.append(svg('path', { class: 'origin', d: `M${x - 8} ${y}h16M${x} ${y - 8}v16` }));
    pane.label([0, 0], 'O', 'name origin-name');
  }

  // Dragging and keys.

  grab(event) {
    const part = event.target.closest('[data-part]')?.dataset.part;
    this.left.svg.focus({ preventScroll: true });
    if (part === undefined) {
      return;
    }
    if (/^[AB]/.test(part)) {
      this.chosen = part[0];
    }
    const shape = this.shown[this.chosen];
    this.held = { part, start: this.left.at(event), at: [...shape.at], to: shape.to && [...shape.to] };
    this.left.svg.setPointerCapture(event.pointerId);
    this.draw();
  }

  drag(event) {
    if (this.held === undefined) {
      return;
    }
    const { part, start, at, to } = this.held, now = this.left.at(event), shape = this.shown[this.chosen];
    if (part === 'turn') {
      const angle = Math.atan2(now[1] - shape.at[1], now[0] - shape.at[0]);
      shape.turn = [Math.round(Math.cos(angle) * UNIT), Math.round(Math.sin(angle) * UNIT)];
    } else if (part === 'to') {
      this.shown.B.to = (to ?? at).map((x, k) => Math.round(x + now[k] - start[k]));
    } else if (part.length === 1) {
      shape.at = at.map((x, k) => Math.round(x + now[k] - start[k]));
    } else {
      const [c, s] = shape.turn.map((x) => x / UNIT), x = now[0] - shape.at[0], y = now[1] - shape.at[1];
      shape.vertices[Number(part.slice(1))] = [Math.round(c * x + s * y), Math.round(c * y - s * x)];
    }
    this.update();
  }

  // The difference keeps its place while something is dragged.
  drop() {
    if (this.held === undefined) {
      return;
    }
    this.held = undefined;
    if (!this.right.holds([...differenceOf(outlineOf(this.shown.A), outlineOf(this.shown.B)), [0, 0]])) {
      this.fitDifference();
      this.draw();
    }
  }

  key(event) {
    const shape = this.shown[this.chosen], by = event.shiftKey ? 1 : Math.max(1, 2 ** Math.round(Math.log2(8 / this.left.scale)));
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    if (way !== undefined) {
      shape.at = shape.at.map((x, k) => x + way[k] * by);
    } else if (event.key === '[' || event.key === ']') {
      const angle = Math.atan2(shape.turn[1], shape.turn[0]) + (event.key === ']' ? -1 : 1) * Math.PI / 36;
      shape.turn = [Math.round(Math.cos(angle) * UNIT), Math.round(Math.sin(angle) * UNIT)];
    } else if (event.key === 'a' || event.key === 'b') {
      this.chosen = event.key.toUpperCase();
    } else if (event.key === ',' || event.key === '.') {
      this.goTo(this.shownStep() + (event.key === '.' ? 1 : -1));
      event.preventDefault();
      return;
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    this.update();
  }
}

// The point of a polygon's border, an edge or a point that is nearest to the origin; inside: the origin.
function nearestToOrigin(points) {
  if (points.length > 2) {
    const sides = points.map((p, i) => cross(p, points[(i + 1) % points.length], [0, 0]));
    if (sides.every((x) => x >= 0) || sides.every((x) => x <= 0)) {
      return [0, 0];
    }
  }
  let best = points[0];
  points.forEach((p, i) => {
    const q = points[(i + 1) % points.length], e = [q[0] - p[0], q[1] - p[1]], square = e[0] ** 2 + e[1] ** 2;
    const t = square > 0 ? Math.max(0, Math.min(1, -(p[0] * e[0] + p[1] * e[1]) / square)) : 0;
    const near = [p[0] + t * e[0], p[1] + t * e[1]];
    best = Math.hypot(...near) < Math.hypot(...best) ? near : best;
  });
  return best;
}

VIEWS.push({ name: 'idea', title: 'The idea', make: () => new IdeaView() });
