// The accurate oracle: the GJK of the reference in 128-bit floating point, run until its bounds meet.
#include "accurate.h"

#include <math.h>

// With the 64 bits of long double on x86, one pair in 200 stalls before the bounds meet. Elsewhere long double is
// wider.
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 accurate_real;
#else
typedef long double accurate_real;
#endif

#define real accurate_real

// One step of Newton doubles the digits that long double has.
static real real_sqrt(real x) {
  real root = (real)sqrtl((long double)x);
  return root > 0 ? (root + x / root) / 2 : 0;
}

#include "solver.h"

#include "epa.h"

static real hypotenuse(real x, real y) {
  return real_sqrt(x * x + y * y);
}

static void make_shape(solver_shape *out, const case_shape *shape, const case_collider *posed, gjk_vec3 origin) {
  if (shape->kind > CASE_HULL) {
    solver_from_case(out, shape, origin);
  } else {
    solver_from_collider(out, posed, shape->kind, origin);
  }
}

static void find(const case_pair *pair, const case_collider *a, const case_collider *b, const long double moved[3],
                 bool deep, accurate_result *out) {
  static epa_hull hull;
  static const solver_limits deep_limits = {.absolute = SOLVER_LSB / 16, .apart = SOLVER_ANY, .iterations = 3000};
  // The bounds are to meet within 2^-12 LSB. A core distance below 2^-40 of the largest vertex, at most 2^-10 LSB,
  // counts as 0.
  static const solver_limits limits = {
      .absolute = SOLVER_LSB / 4096, .enclosing = 0x1p-80L, .apart = SOLVER_ANY, .iterations = 3000};
  solver_shape shape_a, shape_b;
  solver_simplex last;
  solver_result core;
  make_shape(&shape_a, &pair->a, a, a->collider.centre);
  make_shape(&shape_b, &pair->b, b, a->collider.centre);
  for (int k = 0; k < 3; k++) {
    shape_b.centre[k] += (real)moved[k] * SOLVER_LSB;
  }
  solve(&shape_a, &shape_b, &limits, &last, &core);
  real radius = shape_a.convex_radius + shape_b.convex_radius;
  out->enclosing = core.enclosing;
  out->lower = (long double)((core.lower - radius) / SOLVER_LSB);
  out->upper = (long double)((core.upper - radius) / SOLVER_LSB);
  out->iterations = core.iterations;
  for (int k = 0; k < 3; k++) {
    out->normal[k] = core.enclosing ? 0 : (long double)core.normal[k];
  }
  if (deep && core.enclosing) {
    epa_result inside;
    epa_depth(&shape_a, &shape_b, &deep_limits, &last, &hull, &inside);
    out->lower = (long double)((-inside.upper - radius) / SOLVER_LSB);
    out->upper = (long double)((-inside.lower - radius) / SOLVER_LSB);
    out->iterations += inside.iterations;
    for (int k = 0; k < 3; k++) {
      out->normal[k] = (long double)inside.normal[k];
    }
  }
}

static const long double still[3] = {0, 0, 0};

void accurate_distance(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out) {
  find(pair, a, b, still, false, out);
}

void accurate_distance_moved(const case_pair *pair, const case_collider *a, const case_collider *b,
                             const long double moved[3], accurate_result *out) {
  find(pair, a, b, moved, false, out);
}

void accurate_signed(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out) {
  find(pair, a, b, still, true, out);
}

long double accurate_separation(const case_pair *pair, const case_collider *a, const case_collider *b,
                                const gjk_unit3 *direction) {
  solver_shape shape_a, shape_b;
  make_shape(&shape_a, &pair->a, a, a->collider.centre);
  make_shape(&shape_b, &pair->b, b, a->collider.centre);
  real n[3] = {direction->x, direction->y, direction->z};
  real length = real_length(n);
  for (int k = 0; k < 3; k++) {
    n[k] /= length;
  }
  return (long double)((separation(&shape_a, &shape_b, n) - shape_a.convex_radius - shape_b.convex_radius) /
                       SOLVER_LSB);
}

// The point in the frame of the shape, LSB.
static void to_local(const case_shape *shape, gjk_vec3 point, real out[3]) {
  solver_shape posed;
  real offset[3];
  solver_from_case(&posed, shape, point);
  for (int k = 0; k < 3; k++) {
    offset[k] = -posed.centre[k] / SOLVER_LSB;
  }
  for (int i = 0; i < 3; i++) {
    out[i] = real_dot(posed.axes[i], offset) / SOLVER_LSB;
  }
}

// The distance from a box of two or three dimensions about the origin.
static real box_distance(const real p[], const real half[], int dimensions) {
  real outside = 0, inside = 0;
  for (int k = 0; k < dimensions; k++) {
    real beyond = real_magnitude(p[k]) - half[k];
    outside += beyond > 0 ? beyond * beyond : 0;
    inside = k == 0 || beyond > inside ? beyond : inside;
  }
  return outside > 0 ? real_sqrt(outside) : inside;
}

static real segment_distance(real x, real z, real x0, real z0, real x1, real z1) {
  real ex = x1 - x0, ez = z1 - z0, length = ex * ex + ez * ez;
  real t = length > 0 ? ((x - x0) * ex + (z - z0) * ez) / length : 0;
  t = t < 0 ? 0 : (t > 1 ? 1 : t);
  return hypotenuse(x - x0 - t * ex, z - z0 - t * ez);
}

// In the half plane through the axis: the triangle of apex (0, h), rim (r, -h) and centre of the base (0, -h).
static real cone_distance(real x, real z, real r, real h) {
  real side = segment_distance(x, z, r, -h, 0, h), base = segment_distance(x, z, 0, -h, r, -h);
  real nearest = side < base ? side : base;
  bool inside = h > 0 && z >= -h && z <= h && 2 * h * x + r * z <= r * h;
  return inside ? -nearest : nearest;
}

// The nearest point of an ellipsoid is s^2 p / (s^2 + t) in each component, for the t at which it lies on the surface.
// The sum below falls with t, and t > 0 outside; inside that holds up to the smallest radius of curvature.
static real ellipsoid_distance(const real p[3], const real s[3]) {
  real low = -s[0] * s[0], high = 0, squared = 0;
  for (int k = 0; k < 3; k++) {
    low = -s[k] * s[k] > low ? -s[k] * s[k] : low;
    high += s[k] * real_magnitude(p[k]);
  }
  for (int i = 0; i < 300; i++) {
    real t = low + (high - low) / 2, sum = 0;
    for (int k = 0; k < 3; k++) {
      real part = p[k] == 0 ? 0 : s[k] * p[k] / (s[k] * s[k] + t);
      sum += part * part;
    }
    *(sum > 1 ? &low : &high) = t;
  }
  for (int k = 0; k < 3; k++) {
    real gap = s[k] == 0 ? p[k] : (p[k] == 0 ? 0 : high * p[k] / (s[k] * s[k] + high));
    squared += gap * gap;
  }
  return high < 0 ? -real_sqrt(squared) : real_sqrt(squared);
}

static real core_distance(case_kind kind, const real p[3], const real half[3]) {
  real from_axis[2] = {hypotenuse(p[0], p[1]), p[2]}, profile[2] = {half[0], half[2]};
  switch (kind) {
    case CASE_CYLINDER: return box_distance(from_axis, profile, 2);
    case CASE_CONE: return cone_distance(from_axis[0], p[2], half[0], half[2]);
    case CASE_ELLIPSOID: return ellipsoid_distance(p, half);
    default: return box_distance(p, half, 3);
  }
}

long double accurate_point_distance(const case_shape *shape, gjk_vec3 point) {
  real p[3], half[3];
  to_local(shape, point, p);
  set_vec3(half, shape->size);
  return (long double)(core_distance(shape->kind, p, half) - shape->convex_radius);
}

// Asks about a shape and a point. False: there is no such point.
static bool ask_about_point(const case_shape *shape, const case_collider *collider, gjk_vec3 point,
                            void (*query)(const case_pair *, const case_collider *, const case_collider *,
                                          accurate_result *),
                            accurate_result *out) {
  case_pair pair = {{0}, *shape, {0}};
  case_collider at = {0};
  case_shape_reset(&pair.b);
  pair.b.pose.position = point;
  if (case_collider_build(&at, &pair.b, false) != GJK_OK) {
    return false;
  }
  query(&pair, collider, &at, out);
  return true;
}

long double accurate_point_outside(const case_shape *shape, const case_collider *collider, gjk_vec3 point) {
  accurate_result gap;
  return ask_about_point(shape, collider, point, accurate_distance, &gap) ? gap.upper : HUGE_VALL;
}

long double accurate_surface_distance(const case_shape *shape, const case_collider *collider, gjk_vec3 point) {
  accurate_result gap;
  if (!ask_about_point(shape, collider, point, accurate_signed, &gap)) {
    return HUGE_VALL;
  }
  return gap.lower > 0 ? gap.lower : gap.upper < 0 ? -gap.upper : 0;
}
