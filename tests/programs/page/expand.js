// The expanding polytope of the plane, in exact integers: how the depth of two polygons is found, edge by edge.
'use strict';

// pointsA, pointsB: posed vertices, LSB. start: the [a, b] numbers of the simplex that GJK ended with.
// Returns steps {edge: [p, q], polygon, found, done} whose points are {a, b, w: [x, y]} with BigInt; none if A - B is flat.
function expandPolygon(pointsA, pointsB, start) {
  const big = (points) => points.map(([x, y]) => [BigInt(x), BigInt(y)]);
  const as = big(pointsA), bs = big(pointsB);
  const dot = (p, q) => p[0] * q[0] + p[1] * q[1], turn = (p, q) => p[0] * q[1] - p[1] * q[0];
  const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
  const point = (a, b) => ({ a, b, w: minus(as[a], bs[b]) });
  const best = (points, d) => points.reduce((k, p, i) => (dot(p, d) > dot(points[k], d) ? i : k), 0);
  const farthest = (d) => point(best(as, d), best(bs, [-d[0], -d[1]]));
  const polygon = start.map(([a, b]) => point(a, b));
  // The simplex may be a point or an edge with the origin on it: make it a triangle.
  for (const d of [[1n, 0n], [0n, 1n], [-1n, 0n], [0n, -1n]]) {
    const edge = polygon.length === 2 ? minus(polygon[1].w, polygon[0].w) : [0n, 0n];
    const across = polygon.length === 2 ? [[edge[1], -edge[0]], [-edge[1], edge[0]]] : [d];
    for (const found of across.map(farthest)) {
      const off = polygon.length === 1 ? minus(found.w, polygon[0].w) : [0n, 0n];
      if (polygon.length === 1 ? dot(off, off) > 0n
        : polygon.length === 2 && turn(edge, minus(found.w, polygon[0].w)) !== 0n) {
        polygon.push(found);
      }
    }
  }
  if (polygon.length < 3) {
    return [];
  }
  if (turn(minus(polygon[1].w, polygon[0].w), minus(polygon[2].w, polygon[0].w)) < 0n) {
    polygon.reverse();
  }
  const steps = [];
  for (let round = 0; round < as.length + bs.length + 3; round++) {
    // The edge with the least height, p x q / |q - p|; squares compare it exactly.
    const edges = polygon.map((p, i) => {
      const q = polygon[(i + 1) % polygon.length], e = minus(q.w, p.w);
      return { p, q, at: i, height: turn(p.w, q.w), square: dot(e, e), normal: [e[1], -e[0]] };
    });
    const low = edges.reduce((k, e) => (e.height ** 2n * k.square < k.height ** 2n * e.square ? e : k));
    const found = farthest(low.normal);
    const beyond = dot(low.normal, found.w) - low.height;
    steps.push({ edge: low, polygon: [...polygon], found, done: beyond <= 0n });
    if (beyond <= 0n) {
      break;
    }
    polygon.splice(low.at + 1, 0, found);
  }
  return steps;
}

// ceil(height / sqrt(square)), exactly: the depth that the library reports for an edge.
function depthOf({ height, square }) {
  const wanted = height * height;
  let low = 0n, high = 1n << 34n;
  while (low < high) {
    const middle = (low + high) / 2n;
    if (middle * middle * square >= wanted) {
      high = middle;
    } else {
      low = middle + 1n;
    }
  }
  return low;
}
