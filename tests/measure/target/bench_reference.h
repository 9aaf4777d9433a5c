// The reference as the benchmark on emulated cores runs it: posed shapes, in the scalar type `real` of the including
// file. That file also defines BENCH_SOLVER and the tolerances.
//
// The conversion to `real` is not measured: a program that uses floats would have its vertices in them. Depths are
// answered only if BENCH_REFERENCE_DEPTH is defined, since an EPA hull in double does not fit on the smallest board.
#ifndef BENCH_REFERENCE_H
#define BENCH_REFERENCE_H

#include "bench.h"
#include "soft_root.h"

#define BENCH_LSB ((real)1 / (real)65536)

typedef struct solver_shape {
  uint16_t count;  // of vertices; 0: a box
  real vertices[BENCH_VERTICES][3];
  real axes[3][3];
  real centre[3];
  real radius;
} solver_shape;

static real real_sqrt(real x);
static void farthest(const solver_shape *shape, const real d[3], real out[3]);

#include "reference/solver_loop.h"

#ifdef BENCH_REFERENCE_DEPTH
#define EPA_VERTICES_MAX 48
#include "reference/epa.h"
#endif

static void farthest(const solver_shape *shape, const real d[3], real out[3]) {
  if (shape->count > 0) {
    const real *best = shape->vertices[0];
    real most = real_dot(best, d);
    for (unsigned i = 1; i < shape->count; i++) {
      const real along = real_dot(shape->vertices[i], d);
      if (along > most) {
        most = along;
        best = shape->vertices[i];
      }
    }
    for (int k = 0; k < 3; k++) {
      out[k] = best[k];
    }
    return;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = shape->centre[k];
  }
  for (int i = 0; i < 3; i++) {
    const bool minus = real_dot(shape->axes[i], d) < 0;
    for (int k = 0; k < 3; k++) {
      out[k] = minus ? out[k] - shape->axes[i][k] : out[k] + shape->axes[i][k];
    }
  }
}

static void set_vector(gjk_vec3 v, const real centre[3], real out[3]) {
  out[0] = centre[0] + (real)v.x * BENCH_LSB;
  out[1] = centre[1] + (real)v.y * BENCH_LSB;
  out[2] = centre[2] + (real)v.z * BENCH_LSB;
}

static solver_shape reference_shapes[2];

// Sets a shape relative to A's centre.
static void set_shape(solver_shape *shape, const gjk_collider *collider, const gjk_collider *a) {
  static const real zero[3] = {0, 0, 0};
  const gjk_vec3 centre = {collider->centre.x - a->centre.x, collider->centre.y - a->centre.y,
                           collider->centre.z - a->centre.z};
  set_vector(centre, zero, shape->centre);
  shape->radius = (real)collider->radius * BENCH_LSB;
  shape->count = collider->buffer == NULL ? 0 : collider->count;
  for (unsigned i = 0; i < shape->count; i++) {
    set_vector(collider->buffer[i], shape->centre, shape->vertices[i]);
  }
  for (int i = 0; i < 3; i++) {
    set_vector(collider->frame[i], zero, shape->axes[i]);
  }
}

static void reference_pose(const gjk_collider *a, const gjk_collider *b) {
  set_shape(&reference_shapes[0], a, a);
  set_shape(&reference_shapes[1], b, a);
}

static bool spheres_apart(const solver_shape *a, const solver_shape *b) {
  const real radii = a->radius + b->radius;
  real delta[3];
  real_sub(a->centre, b->centre, delta);
  return real_dot(delta, delta) > radii * radii;
}

static const solver_limits exact = {.relative = BENCH_RELATIVE,
                                    .enclosing = BENCH_ENCLOSING,
                                    .apart = SOLVER_ANY,
                                    .iterations = 100},
                           decide = {.relative = BENCH_RELATIVE, .enclosing = BENCH_ENCLOSING, .iterations = 100};

#ifdef BENCH_REFERENCE_DEPTH
#define BENCH_REFERENCE_LAST BENCH_DEPTH

// Not inlined, so that its stack does not count for the other queries.
__attribute__((noinline)) static void reference_depth(const solver_shape *a, const solver_shape *b,
                                                      const solver_simplex *last, bench_answer *out) {
  static epa_hull hull;
  static epa_result depth;
  epa_depth(a, b, &exact, last, &hull, &depth);
  out->iterations += (unsigned)depth.iterations;
  out->distance = -(gjk_q16)(depth.upper / BENCH_LSB + (real)0.5);
}
#else
#define BENCH_REFERENCE_LAST BENCH_INTERSECT
#endif

// As in the library, a yes-or-no question looks at the bounding spheres first, and stops at a separating direction.
static void reference_run(bench_query query, bench_answer *out) {
  static solver_simplex last;
  static solver_result result;
  const solver_shape *a = &reference_shapes[0], *b = &reference_shapes[1];
  out->iterations = 0;
  out->intersecting = false;
  if (query == BENCH_DISTANCE || !spheres_apart(a, b)) {
    solve(a, b, query == BENCH_DISTANCE ? &exact : &decide, &last, &result);
    out->iterations = (unsigned)result.iterations;
    out->intersecting = result.enclosing;
    out->distance = result.enclosing ? 0 : (gjk_q16)(result.upper / BENCH_LSB + (real)0.5);
#ifdef BENCH_REFERENCE_DEPTH
    if (query == BENCH_DEPTH && result.enclosing) {
      reference_depth(a, b, &last, out);
    }
#endif
  }
}

const bench_solver BENCH_SOLVER = {
    .name = BENCH_SOLVER_NAME, .last = BENCH_REFERENCE_LAST, .pose = reference_pose, .run = reference_run};

#endif
