// The depth of overlapping cores by EPA, the expanding polytope algorithm, for the scalar type `real` of the including
// file, which must meet the conditions of solver_loop.h.
//
// 1. Start from a tetrahedron around the origin: the simplex that GJK ended with, or one built from support points.
// 2. Take the face of the hull that is lowest over the origin.
// 3. Find the support point across that face. Stop if it is not farther than the face, to within the limits.
// 4. Otherwise remove all faces that see the point, and join their horizon to it. On from 2.
//
// After van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game Objects", 2001. Departure: step
// 4 looks at all faces, instead of walking from neighbour to neighbour. Rounding may dent the hull, and a dent could
// trap a walk.
#ifndef EPA_H
#define EPA_H

#include "solver_loop.h"

#ifndef EPA_VERTICES_MAX
#define EPA_VERTICES_MAX 256
#endif
#define EPA_FACES_MAX (2 * EPA_VERTICES_MAX)

typedef struct epa_point {
  real w[3], a[3], b[3];
} epa_point;

typedef struct epa_face {
  int corner[3];
  real normal[3];  // unit, outwards
  real height;     // over the origin
} epa_face;

typedef struct epa_hull {
  epa_point point[EPA_VERTICES_MAX];
  epa_face face[EPA_FACES_MAX];
  int horizon[EPA_FACES_MAX][2];
  int points, faces, edges;
  real largest;  // coordinate of any point in size
} epa_hull;

// Lengths in units.
typedef struct epa_result {
  real lower, upper;  // of the depth; upper is that along the normal
  real normal[3];     // unit, from A to B
  real a[3], b[3];
  int iterations;
} epa_result;

// Finds the support point along d and puts it behind the points, without counting it. Pre: there is room.
static const real *epa_probe(epa_hull *p, const solver_shape *a, const solver_shape *b, const real d[3]) {
  epa_point *at = &p->point[p->points];
  const real back[3] = {-d[0], -d[1], -d[2]};
  farthest(a, d, at->a);
  farthest(b, back, at->b);
  real_sub(at->a, at->b, at->w);
  for (int k = 0; k < 3; k++) {
    const real size = real_magnitude(at->w[k]);
    p->largest = size > p->largest ? size : p->largest;
  }
  return at->w;
}

// How large a height of 0 may come out by rounding.
static real epa_noise(const epa_hull *p) {
  return p->largest * (sizeof(real) < sizeof(double) ? (real)1e-6 : (real)1e-14);
}

// Adds the face of three points. False: there is no room, or they lie on one line.
static bool epa_add_face(epa_hull *p, int i, int k, int l) {
  epa_face *f = &p->face[p->faces];
  real e[3], g[3], n[3];
  real_sub(p->point[k].w, p->point[i].w, e);
  real_sub(p->point[l].w, p->point[i].w, g);
  real_cross(e, g, n);
  const real length = real_length(n);
  if (p->faces == EPA_FACES_MAX || length <= 0) {
    return false;
  }
  f->corner[0] = i;
  f->corner[1] = k;
  f->corner[2] = l;
  for (int m = 0; m < 3; m++) {
    f->normal[m] = n[m] / length;
  }
  f->height = real_dot(f->normal, p->point[i].w);
  p->faces++;
  return true;
}

// How far w is from the one point, or from the line through the two points.
static real epa_off(const epa_hull *p, const real w[3]) {
  real e[3], f[3], n[3];
  real_sub(w, p->point[0].w, f);
  if (p->points == 1) {
    return real_length(f);
  }
  real_sub(p->point[1].w, p->point[0].w, e);
  real_cross(e, f, n);
  return real_length(n) / real_length(e);
}

// Step 1: adds a support point that is off the point or line so far. Pre: one or two points. False: there is none.
static bool epa_widen(epa_hull *p, const solver_shape *a, const solver_shape *b) {
  for (int i = 0; i < 6; i++) {
    real d[3] = {0, 0, 0};
    d[i / 2] = i % 2 == 0 ? 1 : -1;
    if (p->points == 2) {
      real e[3], axis[3] = {d[0], d[1], d[2]};
      real_sub(p->point[1].w, p->point[0].w, e);
      real_cross(axis, e, d);
      if (real_length(d) <= real_length(e) / 10) {
        continue;
      }
    }
    if (epa_off(p, epa_probe(p, a, b, d)) > epa_noise(p)) {
      p->points++;
      return true;
    }
  }
  return false;
}

// Step 1: adds the support point farthest from the triangle, on either side, and makes the tetrahedron's faces, normals
// outwards. False: A - B is flat; the depth is 0 along the first face's normal.
static bool epa_raise(epa_hull *p, const solver_shape *a, const solver_shape *b) {
  p->faces = 0;
  if (!epa_add_face(p, 0, 1, 2)) {
    return false;
  }
  const epa_face base = p->face[0];
  real best = 0;
  epa_point apex = p->point[0];
  for (int sign = -1; sign <= 1; sign += 2) {
    const real s = (real)sign, d[3] = {s * base.normal[0], s * base.normal[1], s * base.normal[2]};
    const real above = real_dot(base.normal, epa_probe(p, a, b, d)) - base.height;
    if (real_magnitude(above) > real_magnitude(best)) {
      best = above;
      apex = p->point[3];
    }
  }
  if (real_magnitude(best) <= epa_noise(p)) {
    return false;
  }
  p->point[3] = apex;
  p->points = 4;
  p->faces = 0;
  const int k = best > 0 ? 2 : 1, l = 3 - k;  // the apex is below the base
  return epa_add_face(p, 0, k, l) && epa_add_face(p, 0, l, 3) && epa_add_face(p, l, k, 3) && epa_add_face(p, k, 0, 3);
}

// Step 1: starts from GJK's simplex. False: it is no tetrahedron, or one that is flat to within rounding.
static bool epa_start(epa_hull *p, const solver_simplex *s) {
  real e[3], f[3], g[3], n[3];
  p->points = s->count;
  p->largest = 0;
  p->faces = 0;
  for (int i = 0; i < s->count; i++) {
    for (int k = 0; k < 3; k++) {
      p->point[i].w[k] = s->w[i][k];
      p->point[i].a[k] = s->a[i][k];
      p->point[i].b[k] = s->b[i][k];
      const real size = real_magnitude(s->w[i][k]);
      p->largest = size > p->largest ? size : p->largest;
    }
  }
  if (s->count < 4) {
    return false;
  }
  real_sub(p->point[1].w, p->point[0].w, e);
  real_sub(p->point[2].w, p->point[0].w, f);
  real_sub(p->point[3].w, p->point[0].w, g);
  real_cross(e, f, n);
  const real volume = real_dot(n, g);
  const int k = volume > 0 ? 2 : 1, l = 3 - k;
  return real_magnitude(volume) > epa_noise(p) * real_length(n) && epa_add_face(p, 0, k, l) &&
         epa_add_face(p, 0, l, 3) && epa_add_face(p, l, k, 3) && epa_add_face(p, k, 0, 3);
}

// Adds an edge of a removed face to the horizon, or takes it away if a removed neighbour has added it before.
static void epa_toggle_edge(epa_hull *p, int from, int to) {
  for (int i = 0; i < p->edges; i++) {
    if (p->horizon[i][0] == to && p->horizon[i][1] == from) {
      p->edges--;
      p->horizon[i][0] = p->horizon[p->edges][0];
      p->horizon[i][1] = p->horizon[p->edges][1];
      return;
    }
  }
  if (p->edges < EPA_FACES_MAX) {
    p->horizon[p->edges][0] = from;
    p->horizon[p->edges++][1] = to;
  }
}

// Step 4: makes the probed point a vertex of the hull. A face in whose plane the point lies stays. False: rounding
// leaves no proper hull.
static bool epa_add_vertex(epa_hull *p) {
  const real *w = p->point[p->points].w;
  const real noise = epa_noise(p);
  int kept = 0;
  p->edges = 0;
  for (int i = 0; i < p->faces; i++) {
    const epa_face f = p->face[i];
    if (real_dot(f.normal, w) > f.height + noise) {
      for (int k = 0; k < 3; k++) {
        epa_toggle_edge(p, f.corner[k], f.corner[(k + 1) % 3]);
      }
    } else {
      p->face[kept++] = f;
    }
  }
  p->faces = kept;
  bool proper = p->edges >= 3;
  for (int i = 0; i < p->edges && proper; i++) {
    proper = epa_add_face(p, p->horizon[i][0], p->horizon[i][1], p->points);
  }
  p->points++;
  return proper;
}

// Step 2.
static const epa_face *epa_lowest(const epa_hull *p) {
  const epa_face *lowest = &p->face[0];
  for (int i = 1; i < p->faces; i++) {
    lowest = p->face[i].height < lowest->height ? &p->face[i] : lowest;
  }
  return lowest;
}

static void epa_report(const epa_hull *p, const epa_face *face, epa_result *out) {
  const real *w[3], *a[3], *b[3];
  real triangle[3][3], weight[3];
  for (int i = 0; i < 3; i++) {
    const epa_point *point = &p->point[face->corner[i]];
    for (int k = 0; k < 3; k++) {
      triangle[i][k] = point->w[k] - face->height * face->normal[k];  // the projection of the origin is the origin
    }
    w[i] = triangle[i];
    a[i] = point->a;
    b[i] = point->b;
    out->normal[i] = face->normal[i];
  }
  nearest_on_simplex(w, 3, weight);
  weighted_sum(a, weight, 3, out->a);
  weighted_sum(b, weight, 3, out->b);
}

// Steps 2 to 4, until the limits are met or there is no room.
static void epa_run(epa_hull *p, const solver_shape *a, const solver_shape *b, const solver_limits *limits,
                    epa_result *out) {
  for (bool first = true;; first = false) {
    const epa_face face = *epa_lowest(p);
    out->iterations++;
    const real reached = real_dot(face.normal, epa_probe(p, a, b, face.normal));
    if (first || reached < out->upper) {
      out->upper = reached;
      epa_report(p, &face, out);
    }
    out->lower = face.height > out->lower ? face.height : out->lower;
    const real slack = out->upper * limits->relative;
    if (out->upper - face.height <= (slack > limits->absolute ? slack : limits->absolute) ||
        p->points + 1 == EPA_VERTICES_MAX || out->iterations >= limits->iterations || !epa_add_vertex(p)) {
      return;
    }
  }
}

// Finds the depth of cores that share a point. last: the simplex that solve() ended with.
static void epa_depth(const solver_shape *a, const solver_shape *b, const solver_limits *limits,
                      const solver_simplex *last, epa_hull *p, epa_result *out) {
  out->iterations = 0;
  out->lower = out->upper = 0;
  bool ready = epa_start(p, last);
  if (!ready) {
    p->points = p->points < 3 ? p->points : 3;
    ready = true;
    while (p->points < 3 && ready) {
      ready = epa_widen(p, a, b);
    }
    ready = ready && epa_raise(p, a, b);
  }
  if (ready) {
    epa_run(p, a, b, limits, out);
    return;
  }
  // A - B is flat, so a move across it parts the shapes: the depth is 0.
  for (int k = 0; k < 3; k++) {
    out->normal[k] = p->faces > 0 ? p->face[0].normal[k] : (real)(k == 2);
    out->a[k] = p->point[0].a[k];
    out->b[k] = p->point[0].b[k];
  }
}

#endif
