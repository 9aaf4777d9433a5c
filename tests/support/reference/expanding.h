// The depth of overlapping cores by an expanding polytope, for the scalar type `real` of the including file; after
// solver_loop.h, and with its conditions.
//
// After van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game Objects", 2001. Departure: all
// faces are searched for those that a vertex sees, so that what rounding has made of the polytope can't trap a walk.
#ifndef EXPANDING_H
#define EXPANDING_H

#include "solver_loop.h"

#ifndef EXPANDING_VERTICES_MAX
#define EXPANDING_VERTICES_MAX 256
#endif
#define EXPANDING_FACES_MAX (2 * EXPANDING_VERTICES_MAX)

typedef struct expanding_point {
  real w[3], a[3], b[3];
} expanding_point;

typedef struct expanding_face {
  int corner[3];
  real normal[3];  // unit, outwards
  real height;     // over the origin
} expanding_face;

typedef struct expanding_polytope {
  expanding_point point[EXPANDING_VERTICES_MAX];
  expanding_face face[EXPANDING_FACES_MAX];
  int horizon[EXPANDING_FACES_MAX][2];
  int points, faces, edges;
  real largest;  // coordinate
} expanding_polytope;

// Units.
typedef struct expanding_result {
  real lower, upper;  // of the depth; upper is that along the normal
  real normal[3];     // unit, from A to B
  real a[3], b[3];
  int iterations;
} expanding_result;

// The farthest point along d, not yet counted among the points. Pre: there is room.
static const real *expanding_probe(expanding_polytope *p, const solver_shape *a, const solver_shape *b,
                                   const real d[3]) {
  expanding_point *at = &p->point[p->points];
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

// What rounding may have made of a height that is 0.
static real expanding_noise(const expanding_polytope *p) {
  return p->largest * (sizeof(real) < sizeof(double) ? (real)1e-6 : (real)1e-14);
}

// False: the three are in one line.
static bool expanding_add_face(expanding_polytope *p, int i, int k, int l) {
  expanding_face *f = &p->face[p->faces];
  real e[3], g[3], n[3];
  real_sub(p->point[k].w, p->point[i].w, e);
  real_sub(p->point[l].w, p->point[i].w, g);
  real_cross(e, g, n);
  const real length = real_length(n);
  if (p->faces == EXPANDING_FACES_MAX || length <= 0) {
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

// How far the last probe is from what the points span, by their number; sets d to where that is.
static real expanding_off(const expanding_polytope *p, const real w[3]) {
  real e[3], f[3], n[3];
  real_sub(w, p->point[0].w, f);
  if (p->points == 1) {
    return real_length(f);
  }
  real_sub(p->point[1].w, p->point[0].w, e);
  real_cross(e, f, n);
  return real_length(n) / real_length(e);
}

// Takes the farthest of both directions that is off the line or point so far. Pre: one or two points.
static bool expanding_widen(expanding_polytope *p, const solver_shape *a, const solver_shape *b) {
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
    if (expanding_off(p, expanding_probe(p, a, b, d)) > expanding_noise(p)) {
      p->points++;
      return true;
    }
  }
  return false;
}

// The fourth vertex, beyond the triangle on either side; faces outwards. False: flat, the first face is the depth.
static bool expanding_raise(expanding_polytope *p, const solver_shape *a, const solver_shape *b) {
  p->faces = 0;
  if (!expanding_add_face(p, 0, 1, 2)) {
    return false;
  }
  const expanding_face base = p->face[0];
  real best = 0;
  expanding_point apex = p->point[0];
  for (int sign = -1; sign <= 1; sign += 2) {
    const real s = (real)sign, d[3] = {s * base.normal[0], s * base.normal[1], s * base.normal[2]};
    const real above = real_dot(base.normal, expanding_probe(p, a, b, d)) - base.height;
    if (real_magnitude(above) > real_magnitude(best)) {
      best = above;
      apex = p->point[3];
    }
  }
  if (real_magnitude(best) <= expanding_noise(p)) {
    return false;
  }
  p->point[3] = apex;
  p->points = 4;
  p->faces = 0;
  const int k = best > 0 ? 2 : 1, l = 3 - k;  // the apex is below the base
  return expanding_add_face(p, 0, k, l) && expanding_add_face(p, 0, l, 3) && expanding_add_face(p, l, k, 3) &&
         expanding_add_face(p, k, 0, 3);
}

// Is the tetrahedron of these four worth starting with, the origin in it?
static bool expanding_start(expanding_polytope *p, const solver_simplex *s) {
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
  return real_magnitude(volume) > expanding_noise(p) * real_length(n) && expanding_add_face(p, 0, k, l) &&
         expanding_add_face(p, 0, l, 3) && expanding_add_face(p, l, k, 3) && expanding_add_face(p, k, 0, 3);
}

// The border of the removed faces: an edge that two of them share is none of it.
static void expanding_toggle(expanding_polytope *p, int from, int to) {
  for (int i = 0; i < p->edges; i++) {
    if (p->horizon[i][0] == to && p->horizon[i][1] == from) {
      p->edges--;
      p->horizon[i][0] = p->horizon[p->edges][0];
      p->horizon[i][1] = p->horizon[p->edges][1];
      return;
    }
  }
  if (p->edges < EXPANDING_FACES_MAX) {
    p->horizon[p->edges][0] = from;
    p->horizon[p->edges++][1] = to;
  }
}

// Puts the probe on the polytope: replaces the faces that it sees, but for those in whose plane it lies. False when
// rounding leaves no proper one.
static bool expanding_expand(expanding_polytope *p) {
  const real *w = p->point[p->points].w;
  const real noise = expanding_noise(p);
  int kept = 0;
  p->edges = 0;
  for (int i = 0; i < p->faces; i++) {
    const expanding_face f = p->face[i];
    if (real_dot(f.normal, w) > f.height + noise) {
      for (int k = 0; k < 3; k++) {
        expanding_toggle(p, f.corner[k], f.corner[(k + 1) % 3]);
      }
    } else {
      p->face[kept++] = f;
    }
  }
  p->faces = kept;
  bool proper = p->edges >= 3;
  for (int i = 0; i < p->edges && proper; i++) {
    proper = expanding_add_face(p, p->horizon[i][0], p->horizon[i][1], p->points);
  }
  p->points++;
  return proper;
}

static const expanding_face *expanding_lowest(const expanding_polytope *p) {
  const expanding_face *lowest = &p->face[0];
  for (int i = 1; i < p->faces; i++) {
    lowest = p->face[i].height < lowest->height ? &p->face[i] : lowest;
  }
  return lowest;
}

static void expanding_report(const expanding_polytope *p, const expanding_face *face, expanding_result *out) {
  const real *w[3], *a[3], *b[3];
  real triangle[3][3], weight[3];
  for (int i = 0; i < 3; i++) {
    const expanding_point *point = &p->point[face->corner[i]];
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

static void expanding_run(expanding_polytope *p, const solver_shape *a, const solver_shape *b,
                          const solver_limits *limits, expanding_result *out) {
  for (bool first = true;; first = false) {
    const expanding_face face = *expanding_lowest(p);
    out->iterations++;
    const real reached = real_dot(face.normal, expanding_probe(p, a, b, face.normal));
    if (first || reached < out->upper) {
      out->upper = reached;
      expanding_report(p, &face, out);
    }
    out->lower = face.height > out->lower ? face.height : out->lower;
    const real slack = out->upper * limits->relative;
    if (out->upper - face.height <= (slack > limits->absolute ? slack : limits->absolute) ||
        p->points + 1 == EXPANDING_VERTICES_MAX || out->iterations >= limits->iterations || !expanding_expand(p)) {
      return;
    }
  }
}

// The depth of cores that solve() has found to share a point, with the simplex it ended with.
static void expand(const solver_shape *a, const solver_shape *b, const solver_limits *limits,
                   const solver_simplex *last, expanding_polytope *p, expanding_result *out) {
  out->iterations = 0;
  out->lower = out->upper = 0;
  bool ready = expanding_start(p, last);
  if (!ready) {
    p->points = p->points < 3 ? p->points : 3;
    ready = true;
    while (p->points < 3 && ready) {
      ready = expanding_widen(p, a, b);
    }
    ready = ready && expanding_raise(p, a, b);
  }
  if (ready) {
    expanding_run(p, a, b, limits, out);
    return;
  }
  // Flat: across it, nothing is in the way.
  for (int k = 0; k < 3; k++) {
    out->normal[k] = p->faces > 0 ? p->face[0].normal[k] : (real)(k == 2);
    out->a[k] = p->point[0].a[k];
    out->b[k] = p->point[0].b[k];
  }
}

#endif
