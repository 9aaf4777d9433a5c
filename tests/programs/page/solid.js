// Shapes of space as meshes, and a parallel view of them.
'use strict';

const vec = {
  dot: (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2],
  minus: (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]],
  plus: (p, q, by = 1) => [p[0] + by * q[0], p[1] + by * q[1], p[2] + by * q[2]],
  cross: (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]],
};

function turned([x, y, z, w], p) {
  const q = [x / UNIT, y / UNIT, z / UNIT], t = vec.cross(q, p).map((c) => 2 * c), s = vec.cross(q, t);
  return p.map((c, k) => c + w / UNIT * t[k] + s[k]);
}

// The quaternion of an angle about an axis, after another one; Q2.30, rounded from a unit.
function turnedBy(q, axis, angle) {
  const s = Math.sin(angle / 2), [x, y, z] = axis.map((c) => c * s), w = Math.cos(angle / 2);
  const [a, b, c, d] = q.map((v) => v / UNIT);
  const product = [w * a + x * d + y * c - z * b, w * b - x * c + y * d + z * a, w * c + x * b - y * a + z * d, w * d - x * a - y * b - z * c];
  const length = Math.hypot(...product);
  return product.map((v) => Math.round(v / length * UNIT));
}

// The corners of a core in its own frame; null of a curved one.
function cornersOf({ kind, size, vertices }) {
  switch (kind) {
    case 'point': return [[0, 0, 0]];
    case 'segment': return [[0, 0, -size[0]], [0, 0, size[0]]];
    case 'box': return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => size.map((x, k) => (i >> k & 1 ? x : -x)));
    case 'triangle': case 'hull': return vertices;
    default: return null;
  }
}

// The farthest point of a core along a direction, in its own frame.
function supportOf(shape, corners, d) {
  if (corners !== null) {
    return corners.reduce((best, p) => (vec.dot(p, d) > vec.dot(best, d) ? p : best));
  }
  const [x, y, z] = shape.size, across = Math.hypot(d[0], d[1]);
  const rim = (r) => (across > 1e-6 ? [r * d[0] / across, r * d[1] / across] : [0, 0]);
  if (shape.kind === 'ellipsoid') {
    const length = Math.hypot(x * d[0], y * d[1], z * d[2]) || 1;
    return [x * x * d[0] / length, y * y * d[1] / length, z * z * d[2] / length];
  }
  if (shape.kind === 'cylinder') {
    return [...rim(x), d[2] < 0 ? -y : y];
  }
  return d[2] * 2 * y > x * across ? [0, 0, y] : [...rim(x), -y];
}

// The faces of a hull with few corners: each plane of three that has all others behind it.
function facesOf(corners) {
  const faces = new Map(), n = corners.length, size = Math.max(1, ...corners.flat().map(Math.abs));
  for (let i = 0; i < n; i++) {
    for (let j = i + 1; j < n; j++) {
      for (let k = j + 1; k < n; k++) {
        const normal = vec.cross(vec.minus(corners[j], corners[i]), vec.minus(corners[k], corners[i]));
        const length = Math.hypot(...normal);
        if (length < 1e-6 * size * size) {
          continue;
        }
        const off = corners.map((p) => vec.dot(vec.minus(p, corners[i]), normal) / length);
        for (const side of [1, -1]) {
          if (off.every((h) => side * h < 1e-6 * size)) {
            const on = off.flatMap((h, m) => (Math.abs(h) < 1e-6 * size ? [m] : []));
            const out = normal.map((c) => side * c / length);
            faces.set(on.join(), sortAround(on.map((m) => corners[m]), out));
          }
        }
      }
    }
  }
  return [...faces.values()];
}

function sortAround(points, normal) {
  const middle = [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  const first = vec.minus(points[0], middle), second = vec.cross(normal, first);
  const angle = (p) => Math.atan2(vec.dot(vec.minus(p, middle), second), vec.dot(vec.minus(p, middle), first));
  return [...points].sort((p, q) => angle(p) - angle(q));
}

// The surface of a shape in its own frame: flat faces, or where it is round or large a net over all directions.
function meshOf(shape) {
  const corners = cornersOf(shape);
  if (corners !== null && shape.round === 0 && corners.length <= 24) {
    const faces = facesOf(corners);
    return { faces: faces.length > 0 ? faces : [corners], flat: true };
  }
  const rows = 18, columns = 36, faces = [];
  const at = (i, k) => {
    const up = Math.PI * (i / rows - 0.5), around = 2 * Math.PI * k / columns;
    const d = [Math.cos(up) * Math.cos(around), Math.cos(up) * Math.sin(around), Math.sin(up)].map((c) => (Math.abs(c) < 1e-9 ? 0 : c));
    return vec.plus(supportOf(shape, corners, d), d, shape.round);
  };
  const net = Array.from({ length: rows + 1 }, (_, i) => Array.from({ length: columns }, (__, k) => at(i, k)));
  for (let i = 0; i < rows; i++) {
    for (let k = 0; k < columns; k++) {
      const next = (k + 1) % columns;
      faces.push([net[i][k], net[i][next], net[i + 1][next], net[i + 1][k]]);
    }
  }
  return { faces, flat: false };
}

// A view along a direction: screen = project(point), with the depth towards the eye as third coordinate.
class SpaceCamera {
  constructor() {
    this.yaw = 0.6;
    this.pitch = 0.42;
    this.middle = [0, 0, 0];
    this.reach = 4 * ONE;
  }

  get axes() {
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    return { right: [-sy, cy, 0], up: [-sp * cy, -sp * sy, cp], eye: [cp * cy, cp * sy, sp] };
  }

  frame(width, height) {
    const { right, up, eye } = this.axes, scale = Math.min(width, height) / 2 / this.reach;
    return {
      scale, right, up, eye,
      project: (p) => {
        const q = vec.minus(p, this.middle);
        return [width / 2 + vec.dot(q, right) * scale, height / 2 - vec.dot(q, up) * scale, vec.dot(q, eye)];
      },
    };
  }
}
