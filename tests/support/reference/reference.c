// The reference: GJK on cases and colliders in double, or in the scalar type of the file that includes this one.
#include "reference.h"

#include <math.h>

#ifndef REFERENCE_REAL
#define REFERENCE_REAL double
#define REFERENCE_NAME(name) reference_##name
#endif

// A squared distance below this share of the largest squared vertex counts as 0.
#ifndef REFERENCE_ENCLOSING
#define REFERENCE_ENCLOSING 1e-30
#endif

typedef REFERENCE_REAL reference_real;

#define real reference_real

static real real_sqrt(real x) {
  return (real)sqrt((double)x);
}

#include "solver.h"

#include "epa.h"

// The search ends when a step gains less than 1e-10 of the distance. Of all powers of ten, 1e-30 decides best as the share
// that counts as 0 (tests/check/unit/test_reference.c, 1e-15 to 1e-36). A float gets what its 24 bits leave.
static solver_limits limits(void) {
  solver_limits chosen = {
      .relative = (real)1e-10, .enclosing = (real)REFERENCE_ENCLOSING, .apart = SOLVER_ANY, .iterations = 200};
  if (sizeof(real) < sizeof(double)) {
    chosen.relative = (real)1e-5;
    chosen.enclosing = (real)1e-11;
  }
  return chosen;
}

static void to_world(const real point[3], const real n[3], real along, gjk_vec3 origin, double out[3]) {
  const double base[3] = {origin.x, origin.y, origin.z};
  for (int k = 0; k < 3; k++) {
    out[k] = base[k] + (double)((point[k] + along * n[k]) / SOLVER_LSB);
  }
}

// Reports the points of the cores, moved out by the convex radii. gap: the distance, or minus the depth.
static void report_points(const solver_shape *a, const solver_shape *b, const real core_a[3], const real core_b[3],
                          const real n[3], real gap, gjk_vec3 origin, reference_result *out) {
  out->distance = (double)(gap / SOLVER_LSB);
  to_world(core_a, n, a->convex_radius, origin, out->a);
  to_world(core_b, n, -b->convex_radius, origin, out->b);
  for (int k = 0; k < 3; k++) {
    out->normal[k] = (double)n[k];
  }
}

static void query(const solver_shape *a, const solver_shape *b, gjk_vec3 origin, bool deep, reference_result *out) {
  static epa_hull hull;
  solver_simplex last;
  solver_result core;
  epa_result inside;
  const solver_limits chosen = limits();
  solve(a, b, &chosen, &last, &core);
  const real radius = a->convex_radius + b->convex_radius, gap = core.upper - radius;
  out->iterations = core.iterations;
  out->intersecting = core.enclosing || gap <= 0;
  out->distance = 0;
  if (!core.enclosing && (deep || !out->intersecting)) {
    report_points(a, b, core.a, core.b, core.normal, gap, origin, out);
  } else if (deep) {
    epa_depth(a, b, &chosen, &last, &hull, &inside);
    report_points(a, b, inside.a, inside.b, inside.normal, -inside.upper - radius, origin, out);
    out->iterations += inside.iterations;
  }
}

static void query_posed(const case_pair *pair, const case_collider *a, const case_collider *b, bool deep,
                        reference_result *out) {
  gjk_vec3 origin = a->collider.centre;
  solver_shape shape_a, shape_b;
  solver_from_collider(&shape_a, a, pair->a.kind, origin);
  solver_from_collider(&shape_b, b, pair->b.kind, origin);
  query(&shape_a, &shape_b, origin, deep, out);
}

void REFERENCE_NAME(query_posed)(const case_pair *pair, const case_collider *a, const case_collider *b,
                                 reference_result *out) {
  query_posed(pair, a, b, false, out);
}

void REFERENCE_NAME(signed_posed)(const case_pair *pair, const case_collider *a, const case_collider *b,
                                  reference_result *out) {
  query_posed(pair, a, b, true, out);
}

// A gap below this counts as none, in units: 2^-20 LSB in double, which large shapes far apart do not reach.
static real cast_tolerance(real size) {
  const real share = sizeof(real) < sizeof(double) ? (real)1e-6 : (real)1e-14, least = SOLVER_LSB / 1048576;
  return size * share > least ? size * share : least;
}

void REFERENCE_NAME(cast_posed)(const case_pair *pair, const case_collider *a, const case_collider *b,
                                const double way[3], double margin, reference_cast_result *out) {
  const gjk_vec3 origin = a->collider.centre;
  const solver_limits chosen = limits();
  solver_shape shape_a, shape_b;
  solver_from_collider(&shape_a, a, pair->a.kind, origin);
  solver_from_collider(&shape_b, b, pair->b.kind, origin);
  const real radius = shape_a.convex_radius + shape_b.convex_radius + (real)margin * SOLVER_LSB;
  real fraction = 0, start[3], t[3];
  for (int k = 0; k < 3; k++) {
    start[k] = shape_b.centre[k];
    t[k] = (real)way[k] * SOLVER_LSB;
  }
  out->hit = false;
  out->iterations = 0;
  for (out->rounds = 1; out->rounds <= 100; out->rounds++) {
    solver_simplex last;
    solver_result core;
    for (int k = 0; k < 3; k++) {
      shape_b.centre[k] = start[k] + fraction * t[k];
    }
    solve(&shape_a, &shape_b, &chosen, &last, &core);
    const real gap = (core.enclosing ? 0 : core.upper) - radius;
    const real rate = core.enclosing ? 0 : -real_dot(core.normal, t);
    out->iterations += core.iterations;
    out->fraction = (double)fraction;
    out->gap = (double)(gap / SOLVER_LSB);
    for (int k = 0; k < 3; k++) {
      out->normal[k] = core.enclosing ? 0 : (double)core.normal[k];
    }
    const real next = rate > 0 ? fraction + gap / rate : 2;
    if (gap <= cast_tolerance(real_length(shape_b.centre)) || core.enclosing || next <= fraction) {
      out->hit = true;
      return;
    }
    if (next > 1) {
      return;
    }
    fraction = next;
  }
}
