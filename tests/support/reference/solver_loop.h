// GJK in floating point, for the scalar type `real` of the including file.
//
// The including file defines first: `real`, `static real real_sqrt(real)`, a type solver_shape with a `real centre[3]`,
// and `static void farthest(const solver_shape *, const real d[3], real out[3])`, which finds the shape's support point
// along d. Lengths are in units, so that squares do not overflow a float.
#ifndef SOLVER_LOOP_H
#define SOLVER_LOOP_H

#include "signed_volumes.h"

// Larger than any distance.
#define SOLVER_ANY ((real)1e30)

typedef struct solver_limits {
  real relative;   // stop when the bounds differ by less than this share of the distance
  real absolute;   // or by less than this, units
  real enclosing;  // a squared distance below this share of the largest squared vertex counts as 0
  real apart;      // stop once the distance is proven to be above it, units; the points are of no use then
  int iterations;
} solver_limits;

// What is found of two cores.
typedef struct solver_result {
  bool enclosing;
  real lower, upper;  // bounds of the distance, units; the lower one may be negative
  real a[3], b[3];    // points of the cores that are upper apart, units
  real normal[3];     // from A to B, not set when enclosing
  int iterations;
} solver_result;

// How far apart the cores are along a unit vector; negative when they overlap along it.
static inline real separation(const solver_shape *a, const solver_shape *b, const real n[3]) {
  real back[3] = {-n[0], -n[1], -n[2]}, pa[3], pb[3], gap[3];
  farthest(a, n, pa);
  farthest(b, back, pb);
  real_sub(pb, pa, gap);
  return real_dot(gap, n);
}

typedef struct solver_simplex {
  int count;
  real w[4][3], a[4][3], b[4][3], weight[4];
} solver_simplex;

static bool contains(const solver_simplex *s, const real w[3]) {
  for (int i = 0; i < s->count; i++) {
    if (s->w[i][0] == w[0] && s->w[i][1] == w[1] && s->w[i][2] == w[2]) {
      return true;
    }
  }
  return false;
}

static void add_farthest(solver_simplex *s, const solver_shape *a, const solver_shape *b, const real d[3]) {
  real back[3] = {-d[0], -d[1], -d[2]};
  farthest(a, d, s->a[s->count]);
  farthest(b, back, s->b[s->count]);
  real_sub(s->a[s->count], s->b[s->count], s->w[s->count]);
}

// Drops the vertices whose weight is 0, sets v to the point nearest to the origin, and returns the largest |vertex|^2.
static real reduce(solver_simplex *s, real v[3]) {
  const real *points[4];
  real weight[4], largest = 0;
  int kept = 0;
  for (int i = 0; i < s->count; i++) {
    points[i] = s->w[i];
  }
  nearest_on_simplex(points, s->count, weight);
  for (int i = 0; i < s->count; i++) {
    if (weight[i] > 0) {
      for (int k = 0; k < 3; k++) {
        s->w[kept][k] = s->w[i][k];
        s->a[kept][k] = s->a[i][k];
        s->b[kept][k] = s->b[i][k];
      }
      s->weight[kept++] = weight[i];
      real squared = real_dot(s->w[kept - 1], s->w[kept - 1]);
      largest = squared > largest ? squared : largest;
    }
  }
  s->count = kept;
  for (int i = 0; i < kept; i++) {
    points[i] = s->w[i];
  }
  weighted_sum(points, s->weight, kept, v);
  return largest;
}

static void report_simplex(const solver_simplex *s, solver_result *out) {
  const real *a[4] = {s->a[0], s->a[1], s->a[2], s->a[3]}, *b[4] = {s->b[0], s->b[1], s->b[2], s->b[3]};
  weighted_sum(a, s->weight, s->count, out->a);
  weighted_sum(b, s->weight, s->count, out->b);
}

// Finds the distance of two cores. Stops when the bounds meet limits, the simplex encloses the origin, or rounding ends
// the progress. last: the simplex at the end.
static void solve(const solver_shape *a, const solver_shape *b, const solver_limits *limits, solver_simplex *last,
                  solver_result *out) {
  real v[3], d[3];
  real_sub(b->centre, a->centre, d);
  out->enclosing = false;
  out->iterations = 1;
  last->count = 0;
  add_farthest(last, a, b, d);
  last->count = 1;
  real largest = reduce(last, v);
  out->upper = real_length(v);
  out->lower = -out->upper;
  if (limits->apart < SOLVER_ANY && -real_dot(v, d) > limits->apart * real_length(d)) {
    return;
  }
  while (out->upper * out->upper > limits->enclosing * largest) {
    for (int k = 0; k < 3; k++) {
      out->normal[k] = -v[k] / out->upper;
    }
    out->iterations++;
    add_farthest(last, a, b, out->normal);
    real bound = -real_dot(last->w[last->count], out->normal);
    out->lower = bound > out->lower ? bound : out->lower;
    real slack = out->upper * limits->relative;
    if (out->upper - out->lower <= (slack > limits->absolute ? slack : limits->absolute) ||
        out->lower > limits->apart || contains(last, last->w[last->count]) || out->iterations >= limits->iterations) {
      report_simplex(last, out);
      return;
    }
    last->count++;
    largest = reduce(last, v);
    if (last->count == 4) {
      break;
    }
    real length = real_length(v);
    if (length >= out->upper) {
      report_simplex(last, out);
      return;
    }
    out->upper = length;
  }
  out->enclosing = true;
  out->upper = 0;
}

#endif
