// The third view: any two shapes of space.
'use strict';

// [kind, size, convex radius, vertices]
const SPACE_SHAPES = {
  box: ['box', [60000, 45000, 52000], 0, []],
  sphere: ['point', [], 62000, []],
  capsule: ['segment', [60000], 34000, []],
  cylinder: ['cylinder', [52000, 60000], 0, []],
  cone: ['cone', [62000, 66000], 0, []],
  ellipsoid: ['ellipsoid', [80000, 46000, 56000], 0, []],
  'rounded box': ['box', [46000, 34000, 40000], 16000, []],
  rock: ['hull', [], 0, [[70000, 9000, 12000], [-62000, 22000, -9000], [12000, 69000, 5000], [-9000, -66000, 14000],
    [16000, -12000, 72000], [-11000, 21000, -64000], [46000, 43000, -30000], [-40000, -38000, 42000]]],
  triangle: ['triangle', [], 0, [[-70000, -50000, 0], [80000, -30000, 0], [0, 70000, 20000]]],
};

const SPACE_START = 'case space;A box 60000 45000 52000;A at -75000 0 0;A turn 0 0 277904834 1037154959;' +
  'B hull 8;70000 9000 12000;-62000 22000 -9000;12000 69000 5000;-9000 -66000 14000;16000 -12000 72000;-11000 21000 -64000;46000 43000 -30000;-40000 -38000 42000;' +
  'B at 95000 20000 20000';

class SpaceView {
  constructor() {
    this.camera = new SpaceCamera();
    this.chosen = 'B';
    this.meshes = {};
    this.build();
    this.listen();
  }

  build() {
    this.canvas = element('canvas', { 'aria-label': 'The shapes in space', role: 'img', tabindex: 0 });
    this.caption = element('div', { class: 'caption' }, 'Drag a shape to move it, drag beside it to look around');
    this.questions = choiceOf('Question', [['distance', 'Distance'], ['penetration', 'Depth'], ['contacts', 'Contacts'],
      ['cast', 'Cast']], (value) => this.turnTo(value));
    this.kinds = ['A', 'B'].map((name) => element('select', { 'aria-label': 'Kind of ' + name, onchange: (event) => this.changeKind(name, event.target.value) },
      ...['', ...Object.keys(SPACE_SHAPES)].map((kind) => element('option', { value: kind }, kind || 'own shape'))));
    this.names = choiceOf('Shape', [['A', 'A'], ['B', 'B']], (value) => {
      this.chosen = value;
      this.draw();
    });
    this.turns = [0, 1, 2].map((axis) => element('button', { type: 'button', title: 'Turn about ' + 'xyz'[axis],
      onclick: () => this.turn(axis, Math.PI / 12) }, '↻ ' + 'xyz'[axis]));
    this.say = element('p', { class: 'sentence', 'aria-live': 'polite' });
    this.rows = element('dl', { class: 'integers numbers' });
    this.element = element('section', { class: 'view', id: 'space', 'aria-label': 'In space' },
      element('div', { class: 'say' }, element('h2', {}, 'Any two shapes in space'),
        element('p', {}, 'The same search with one dimension more: nearest points, depth, contacts and casts, and what they cost a small core.')),
      element('div', { class: 'stage' }, element('div', { class: 'pane' }, this.canvas, this.caption)),
      this.say, this.rows,
      element('div', { class: 'row' }, this.questions, element('span', { class: 'rule' }),
        element('label', {}, 'A', this.kinds[0]), element('label', {}, 'B', this.kinds[1]), this.names,
        element('div', { class: 'group' }, ...this.turns)));
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('pointerdown', (event) => this.grab(event));
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    canvas.addEventListener('pointerup', () => { this.held = undefined; });
    canvas.addEventListener('pointercancel', () => { this.held = undefined; });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.camera.reach *= 1.0015 ** event.deltaY;
      this.draw();
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => this.key(event));
    redrawWhenResized(this);
  }

  load(values) {
    const found = parseCase(address.unpack(values.get('case') ?? SPACE_START));
    this.shown = found !== null && !found.plane ? found : parseCase(address.unpack(SPACE_START));
    this.question = askedOf(values);
    this.giveWay();
    this.camera.yaw = values.has('yaw') ? Number(values.get('yaw')) / 1000 : 0.6 - Math.PI / 2;
    this.camera.pitch = values.has('pitch') ? Number(values.get('pitch')) / 1000 : 0.42;
    this.meshes = {};
    this.fit();
    this.update();
  }

  save() {
    return { ask: this.question, yaw: Math.round(this.camera.yaw * 1000), pitch: Math.round(this.camera.pitch * 1000),
      case: address.pack(writeCase(this.shown)) };
  }

  caseText() {
    return writeCase(this.shown);
  }

  mesh(name) {
    const { kind, size, round, vertices } = this.shown[name], key = JSON.stringify([kind, size, round, vertices]);
    if (this.meshes[name]?.key !== key) {
      this.meshes[name] = { key, ...meshOf(this.shown[name]) };
    }
    return this.meshes[name];
  }

  // The faces of a shape in the world.
  posed(name, at = this.shown[name].at) {
    const { turn } = this.shown[name];
    return this.mesh(name).faces.map((face) => face.map((p) => vec.plus(turned(turn, p), at)));
  }

  fit() {
    const { B } = this.shown;
    const all = [...this.posed('A'), ...this.posed('B'), ...(B.to === null ? [] : this.posed('B', B.to))].flat();
    const low = [0, 1, 2].map((k) => Math.min(...all.map((p) => p[k]))), high = [0, 1, 2].map((k) => Math.max(...all.map((p) => p[k])));
    this.camera.middle = low.map((x, k) => (x + high[k]) / 2);
    this.camera.reach = Math.max(40, 0.46 * Math.hypot(...vec.minus(high, low)));
  }

  turnTo(question) {
    this.question = question;
    this.giveWay();
    this.update();
  }

  giveWay() {
    if (giveWay(this.shown, this.question)) {
      this.fit();
    }
  }

  changeKind(name, kind) {
    if (SPACE_SHAPES[kind] !== undefined) {
      const [word, size, round, vertices] = SPACE_SHAPES[kind];
      Object.assign(this.shown[name], { kind: word, size: [...size], round, vertices: vertices.map((p) => [...p]), faces: [] });
      this.chosen = name;
      this.update();
    }
  }

  turn(axis, angle) {
    const shape = this.shown[this.chosen];
    shape.turn = turnedBy(shape.turn, [0, 1, 2].map((k) => (k === axis ? 1 : 0)), angle);
    this.update();
  }

  update() {
    this.answer = ask(writeCase(this.shown), this.question, this.question === 'contacts' ? 4096 : 0, PROOF);
    this.draw();
    page.save();
  }

  // What is told.

  sentence() {
    const { answer } = this, rounds = answer.iterations;
    const found = `${rounds} ${rounds === 1 ? 'round' : 'rounds'} of GJK`;
    switch (answer.word) {
      case 'separated':
        return this.question === 'contacts' && answer.contacts.length > 0
          ? `Within the margin they share ${answer.contacts.length} contact points; ${found}.`
          : `${units(answer.distance)} units apart, found in ${found}.`;
      case 'intersecting':
        return answer.depth === undefined ? `They share a point, found in ${found}.`
          : answer.contacts.length > 0 ? `${answer.contacts.length} contact points, ${units(answer.depth)} units deep.`
            : `${units(answer.depth)} units deep: moved so far along the normal, B is out. ${rounds} rounds.`;
      case 'hit': return `B touches A after ${(answer.fraction / UNIT * 100).toFixed(3)} % of its way; ${rounds} rounds.`;
      case 'miss': return `B misses A; ${rounds} rounds.`;
      default: return 'The library refuses this pair.';
    }
  }

  // The README's figure for such a pair, if it has one.
  cost() {
    const { A, B } = this.shown, boxes = A.kind === 'box' && B.kind === 'box';
    const hulls = [A, B].every(({ kind }) => kind === 'box' || kind === 'hull' || kind === 'triangle');
    if (!hulls || A.round > 0 || B.round > 0 || this.answer.word === 'error') {
      return null;
    }
    const kind = boxes ? 'boxes' : '8-point hulls';
    const asked = { distance: 'apart: distance', contacts: 'face to face: contacts', penetration: 'overlapping: depth' }[this.question];
    const name = this.question === 'penetration' && this.answer.word === 'separated' ? `${kind} apart: distance` : `${kind} ${asked}`;
    return README_COSTS[name] === undefined ? null : [name, README_COSTS[name]];
  }

  tell() {
    const cost = this.cost(), rows = this.answer.word === 'error' ? [['answer', this.answer.line]] : answerRows(this.answer);
    rows.splice(1, 0, ['on a Cortex-M3', cost === null ? 'no figure in the README for such a pair'
      : `${cost[0]}: ${cost[1].replace(/ \((.*)\)/, ' instructions in the mean, $1 in the worst of 50 pairs')}`]);
    this.say.textContent = this.sentence();
    this.rows.replaceChildren(...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]));
  }

  // What is drawn.

  repaint() {
    this.draw();
  }

  draw() {
    this.questions.set(this.question);
    this.names.set(this.chosen);
    ['A', 'B'].forEach((name, i) => {
      const { kind, size, round, vertices } = this.shown[name];
      const known = Object.entries(SPACE_SHAPES).find(([, of]) => JSON.stringify(of) === JSON.stringify([kind, size, round, vertices]));
      this.kinds[i].value = known?.[0] ?? '';
    });
    this.tell();
    this.paint();
  }

  paint() {
    const { canvas, answer } = this, { clientWidth: width, clientHeight: height } = canvas, ratio = devicePixelRatio;
    const style = getComputedStyle(document.documentElement);
    this.colour = (name) => style.getPropertyValue('--' + name).trim();
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    context.lineJoin = 'round';
    this.context = context;
    this.view = this.camera.frame(width, height);
    this.ground();
    const bodies = [['A', this.shown.A.at, 1], ['B', this.shown.B.at, 1]];
    const casting = this.question === 'cast' && this.shown.B.to !== null;
    if (casting) {
      this.body('B', this.shown.B.to, 0.25);
      if (answer.at !== undefined) {
        bodies.push(['B', answer.at, 0.75]);
      }
    }
    // Of two convex bodies that are apart, the one on the eye's side of a plane between them hides the other.
    const toEye = answer.normal === undefined ? this.view.project(this.shown.B.at)[2] - this.view.project(this.shown.A.at)[2]
      : vec.dot(answer.normal, this.view.eye);
    bodies.sort((p, q) => (toEye > 0 ? 1 : -1) * ((p[0] === 'B') - (q[0] === 'B')));
    for (const [name, at, strength] of bodies) {
      this.body(name, at, strength);
    }
    if (casting) {
      this.line(this.shown.B.at, this.shown.B.to, 'ink', 1.6);
      this.dot(this.shown.B.to, 'b', 6);
    }
    this.witnesses();
  }

  ground() {
    const { middle, reach } = this.camera, step = 2 ** Math.round(Math.log2(reach / 4));
    const low = Math.min(...['A', 'B'].flatMap((name) => this.posed(name).flat().map((p) => p[2]))) - step / 2;
    const from = [0, 1].map((k) => Math.round(middle[k] / step) * step);
    for (let i = -6; i <= 6; i++) {
      this.line([from[0] + i * step, from[1] - 6 * step, low], [from[0] + i * step, from[1] + 6 * step, low], 'grid', 1);
      this.line([from[0] - 6 * step, from[1] + i * step, low], [from[0] + 6 * step, from[1] + i * step, low], 'grid', 1);
    }
  }

  body(name, at, strength) {
    const { context, view } = this, { flat } = this.mesh(name), letter = name.toLowerCase();
    const faces = this.posed(name, at).map((face) => ({ face, seen: face.map(view.project) }));
    const outline = hullOf(faces.flatMap(({ seen }) => seen));
    this.outlines = { ...this.outlines, [name]: strength === 1 ? outline : this.outlines?.[name] };
    context.globalAlpha = strength * 0.9;
    this.trace(outline);
    context.fillStyle = this.colour(letter + '-fill');
    context.fill();
    const light = [0.3, -0.4, 0.87];
    for (const { face, seen } of faces) {
      const normal = faceNormal(face), shade = vec.dot(normal, light);
      if (vec.dot(normal, view.eye) <= 0 && face.length > 2 && faces.length > 1) {
        continue;
      }
      this.trace(seen);
      context.fillStyle = shade > 0 ? '#ffffff' : '#000000';
      context.globalAlpha = strength * Math.abs(shade) * (shade > 0 ? 0.22 : 0.16);
      context.fill();
      if (flat) {
        context.globalAlpha = strength;
        context.strokeStyle = this.colour(letter);
        context.lineWidth = 1.3;
        context.stroke();
      }
    }
    context.globalAlpha = strength;
    this.trace(outline);
    context.strokeStyle = this.colour(letter);
    context.lineWidth = name === this.chosen && strength === 1 ? 2.4 : 1.5;
    context.stroke();
    context.globalAlpha = 1;
  }

  trace(points) {
    const { context } = this;
    context.beginPath();
    points.forEach(([x, y], i) => (i > 0 ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.closePath();
  }

  line(p, q, colour, wide) {
    const { context } = this, [from, to] = [p, q].map(this.view.project);
    context.beginPath();
    context.moveTo(from[0], from[1]);
    context.lineTo(to[0], to[1]);
    context.strokeStyle = this.colour(colour);
    context.lineWidth = wide;
    context.stroke();
  }

  dot(p, colour, radius) {
    const { context } = this, [x, y] = this.view.project(p);
    context.beginPath();
    context.arc(x, y, radius, 0, 7);
    context.fillStyle = this.colour(colour);
    context.fill();
    context.strokeStyle = this.colour('sheet');
    context.lineWidth = 1.5;
    context.stroke();
  }

  witnesses() {
    const { answer } = this;
    if (answer.a !== undefined && answer.contacts.length === 0) {
      this.line(answer.a, answer.b, 'accent', 3);
      this.dot(answer.a, 'accent', 5);
      this.dot(answer.b, 'accent', 5);
      const length = answer.distance === undefined ? 22 / this.view.scale : 0;
      if (length > 0) {
        this.line(answer.b, vec.plus(answer.b, answer.normal, length / UNIT), 'ink', 2);
      }
    }
    for (const contact of answer.contacts) {
      this.line(contact.a, contact.b, 'good', 3);
      this.dot(contact.a, 'good', 6);
    }
  }

  // Dragging and keys.

  inside(points, [x, y]) {
    return points !== undefined && points.length > 2 && points.every((p, i) => {
      const q = points[(i + 1) % points.length];
      return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) >= 0;
    });
  }

  grab(event) {
    const box = this.canvas.getBoundingClientRect(), at = [event.clientX - box.left, event.clientY - box.top];
    const end = this.question === 'cast' && this.shown.B.to !== null ? this.view.project(this.shown.B.to) : null;
    this.held = { x: event.clientX, y: event.clientY, yaw: this.camera.yaw, pitch: this.camera.pitch };
    if (end !== null && Math.hypot(end[0] - at[0], end[1] - at[1]) < 16) {
      this.held.from = [...this.shown.B.to];
      this.held.part = 'to';
    } else {
      const found = ['B', 'A'].find((name) => this.inside(this.outlines?.[name], at));
      if (found !== undefined) {
        this.chosen = found;
        this.held.from = [...this.shown[found].at];
        this.held.part = 'at';
      }
    }
    this.canvas.setPointerCapture(event.pointerId);
    this.draw();
  }

  drag(event) {
    if (this.held === undefined) {
      return;
    }
    const { x, y, from, part, yaw, pitch } = this.held, dx = event.clientX - x, dy = event.clientY - y;
    if (part === undefined) {
      this.camera.yaw = yaw - dx * 0.008;
      this.camera.pitch = Math.max(-1.5, Math.min(1.5, pitch + dy * 0.008));
      this.draw();
      page.save();
      return;
    }
    const { right, up, scale } = this.view;
    const shape = part === 'to' ? this.shown.B : this.shown[this.chosen];
    shape[part] = from.map((c, k) => Math.round(c + (right[k] * dx - up[k] * dy) / scale));
    this.update();
  }

  key(event) {
    const by = event.shiftKey ? 1 : Math.max(1, 2 ** Math.round(Math.log2(8 / this.view.scale)));
    const way = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1],
      PageUp: [0, 1, 0], PageDown: [0, -1, 0] }[event.key];
    const look = { j: [0.1, 0], l: [-0.1, 0], i: [0, 0.1], k: [0, -0.1] }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    if (way !== undefined) {
      this.shown[this.chosen].at = this.shown[this.chosen].at.map((c, m) => c + way[m] * by);
    } else if (look !== undefined) {
      this.camera.yaw += look[0];
      this.camera.pitch = Math.max(-1.5, Math.min(1.5, this.camera.pitch + look[1]));
    } else if (event.key === '[' || event.key === ']') {
      this.turn(2, (event.key === '[' ? 1 : -1) * Math.PI / 36);
    } else if (event.key === 'a' || event.key === 'b') {
      this.chosen = event.key.toUpperCase();
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    this.update();
  }
}

// By Newell: of a quad too whose corners lie partly on each other.
function faceNormal(face) {
  let sum = [0, 0, 0];
  face.forEach((p, i) => {
    sum = vec.plus(sum, vec.cross(vec.minus(p, face[0]), vec.minus(face[(i + 1) % face.length], face[0])));
  });
  const length = Math.hypot(...sum);
  return length > 0 ? sum.map((c) => c / length) : sum;
}

VIEWS.push({ name: 'space', title: 'In space', make: () => new SpaceView() });
