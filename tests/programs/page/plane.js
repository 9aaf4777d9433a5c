// Drawing in the plane: outlines of shapes, hulls, and a pane whose points are LSB.
'use strict';

// The core of a shape as posed, in LSB, with corners between which lines run.
function outlineOf(shape, at = shape.at) {
  const [c, s] = shape.turn.map((x) => x / UNIT), [x, y] = shape.size;
  let points = shape.vertices;
  if (shape.kind === 'box') {
    points = [[-x, -y], [x, -y], [x, y], [-x, y]];
  } else if (shape.kind === 'segment') {
    points = [[-x, 0], [x, 0]];
  } else if (shape.kind === 'point') {
    points = [[0, 0]];
  } else if (shape.kind === 'ellipse') {
    points = Array.from({ length: 96 }, (_, i) => [x * Math.cos(i * Math.PI / 48), y * Math.sin(i * Math.PI / 48)]);
  }
  return hullOf(points.map(([px, py]) => [at[0] + c * px - s * py, at[1] + s * px + c * py]));
}

function cross(o, p, q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

// Corners of the convex hull, counterclockwise.
function hullOf(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (list) => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1 && cross(chain.at(-2), chain.at(-1), p) <= 0) {
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  const hull = sorted.length > 1 ? [...half(sorted), ...half(sorted.reverse())] : sorted;
  return hull.length > 0 ? hull : [points[0]];
}

function differenceOf(a, b) {
  return hullOf(a.flatMap((p) => b.map((q) => [p[0] - q[0], p[1] - q[1]])));
}

function middleOf(points) {
  return [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
}

// A drawing whose points are LSB of the plane, y upwards.
class PlanePane {
  constructor(label, title) {
    this.svg = svg('svg', { role: 'img', 'aria-label': label });
    this.element = element('div', { class: 'pane' }, this.svg, element('div', { class: 'caption' }, title));
    this.middle = [0, 0];
    this.reach = 4 * ONE;  // LSB from the middle to the nearer border
  }

  get size() {
    return [this.element.clientWidth || 400, this.element.clientHeight || 300];
  }

  get scale() {
    return Math.min(...this.size) / 2 / this.reach;
  }

  // Shows these points, and keeps a border free.
  fit(points) {
    const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...points.map((p) => p[k])));
    const [w, h] = this.size, least = Math.min(w, h);
    this.middle = [0, 1].map((k) => (low[k] + high[k]) / 2);
    this.reach = Math.max(20, 0.7 * Math.max((high[0] - low[0]) * least / w, (high[1] - low[1]) * least / h));
  }

  holds(points, border = 26) {
    const [w, h] = this.size;
    return points.map((p) => this.to(p)).every(([x, y]) => x > border && y > border && x < w - border && y < h - border);
  }

  to([x, y]) {
    const [w, h] = this.size;
    return [w / 2 + (x - this.middle[0]) * this.scale, h / 2 - (y - this.middle[1]) * this.scale];
  }

  from([x, y]) {
    const [w, h] = this.size;
    return [this.middle[0] + (x - w / 2) / this.scale, this.middle[1] - (y - h / 2) / this.scale];
  }

  // Where a pointer is, in LSB.
  at(event) {
    const box = this.element.getBoundingClientRect();
    return this.from([event.clientX - box.left, event.clientY - box.top]);
  }

  clear() {
    this.svg.replaceChildren();
    this.taken = [];
    this.grid();
  }

  grid() {
    const step = 2 ** Math.ceil(Math.log2(28 / this.scale)), [w, h] = this.size;
    const [x0, y1] = this.from([0, 0]), [x1, y0] = this.from([w, h]);
    let path = '';
    for (let x = Math.ceil(x0 / step) * step; x < x1; x += step) {
      path += `M${this.to([x, 0])[0].toFixed(1)} 0V${h}`;
    }
    for (let y = Math.ceil(y0 / step) * step; y < y1; y += step) {
      path += `M0 ${this.to([0, y])[1].toFixed(1)}H${w}`;
    }
    this.svg.append(svg('path', { class: 'grid', d: path }));
  }

  path(points, closed = true) {
    return points.map((p, i) => (i > 0 ? 'L' : 'M') + this.to(p).map((x) => x.toFixed(2)).join(' ')).join('') +
      (closed && points.length > 1 ? 'Z' : points.length === 1 ? 'h0' : '');
  }

  // A core with its convex radius: a wide line around it, with round joins, over a wider one.
  body(points, radius, name, more = {}) {
    const wide = 2 * radius * this.scale;
    const group = svg('g', { class: 'body ' + name, ...more },
      svg('path', { class: 'edge', d: this.path(points), 'stroke-width': wide + 3 }),
      svg('path', { class: 'inside', d: this.path(points), 'stroke-width': wide }));
    this.svg.append(group);
    return group;
  }

  line(points, name, closed = false) {
    this.svg.append(svg('path', { class: name, d: this.path(points, closed) }));
  }

  dot(p, name, radius = 4.5) {
    const [cx, cy] = this.to(p);
    const made = svg('circle', { class: name, cx: cx.toFixed(2), cy: cy.toFixed(2), r: radius });
    this.svg.append(made);
    return made;
  }

  // A line to its end with a head, by pixels so that the head keeps its size.
  arrow(from, to, name) {
    const [x0, y0] = this.to(from), [x1, y1] = this.to(to), length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 1) {
      return;
    }
    const u = [(x1 - x0) / length, (y1 - y0) / length], head = Math.min(9, length);
    const side = (k) => `${(x1 - u[0] * head + k * u[1] * head / 2).toFixed(1)} ${(y1 - u[1] * head - k * u[0] * head / 2).toFixed(1)}`;
    this.svg.append(svg('path', { class: name, d: `M${x0.toFixed(1)} ${y0.toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}` +
      `M${side(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}L${side(-1)}` }));
  }

  // A line across a direction through a point, over the whole pane.
  across(p, d, name) {
    const length = Math.hypot(...d) || 1, far = 4 * this.reach * Math.max(...this.size) / Math.min(...this.size);
    const along = [-d[1] / length * far, d[0] / length * far];
    this.line([[p[0] + along[0], p[1] + along[1]], [p[0] - along[0], p[1] - along[1]]], name);
  }

  // A label beside a point, away from another one, where no label stands yet; left out where there is no room.
  label(p, text, name, away) {
    const [x, y] = this.to(p), [ax, ay] = away === undefined ? [x, y + 1] : this.to(away), [w, h] = this.size;
    const first = Math.atan2(y - ay, x - ax), wide = 8 * text.length + 4, high = 17;
    for (const turn of [0, 0.6, -0.6, 1.2, -1.2, 1.9, -1.9, 2.6, -2.6]) {
      for (const far of [16, 26]) {
        const cx = x + Math.cos(first + turn) * (far + wide / 2 - 8), cy = y + Math.sin(first + turn) * far;
        const box = [cx - wide / 2, cy - high / 2, cx + wide / 2, cy + high / 2];
        if (box[0] > 2 && box[1] > 2 && box[2] < w - 2 && box[3] < h - 2 &&
            !this.taken.some((t) => box[0] < t[2] && t[0] < box[2] && box[1] < t[3] && t[1] < box[3])) {
          this.taken.push(box);
          this.svg.append(svg('text', { class: name, x: cx.toFixed(1), y: (cy + 4.5).toFixed(1), 'text-anchor': 'middle' }, text));
          return;
        }
      }
    }
  }

  // Keeps labels off the caption.
  reserve(...box) {
    this.taken.push(box);
  }
}
