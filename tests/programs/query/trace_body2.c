// Builds the bodies of a trace in the plane.
#include <math.h>
#include <stdlib.h>

#include "exact/claim2.h"
#include "trace_body.h"

#define PI 3.14159265358979323846

// A core: the corners of a polygon, counterclockwise, or an ellipse. Units.
typedef struct core2 {
  size_t count;
  real3 corner[OUTLINE_POINTS];
  real3 centre, axis[2];  // where count is 0
  double radius;          // around it
} core2;

static real3 to_units(exact2_point p) {
  const real3 out = {(double)p.x / 65536, (double)p.y / 65536, 0};
  return out;
}

static void set_corners(const exact2_hull *hull, core2 *out) {
  // A hull with more corners than fit is drawn with some of them left out.
  out->count = hull->count < OUTLINE_POINTS ? hull->count : OUTLINE_POINTS;
  for (size_t i = 0; i < out->count; i++) {
    out->corner[i] = to_units(hull->vertex[i * hull->count / out->count]);
  }
}

// False: the shape is an ellipse.
static bool set_core(const case2_shape *shape, const gjk2_collider *posed, exact2_hull *hull, core2 *out) {
  exact2_posed exact;
  out->radius = shape->convex_radius / 65536.0;
  if (exact2_posed_set(posed, &exact)) {
    exact2_hull_find(exact.shape.point, exact.shape.count, hull);
    exact2_posed_free(&exact);
    set_corners(hull, out);
    return true;
  }
  const double c = shape->pose.rotation.c, s = shape->pose.rotation.s, length = hypot(c, s);
  const real3 x = {c / length, s / length, 0}, y = {-s / length, c / length, 0};
  const exact2_point centre = {posed->centre.x, posed->centre.y};
  out->count = 0;
  out->centre = to_units(centre);
  out->axis[0] = real_scale(shape->size.x / 65536.0, x);
  out->axis[1] = real_scale(shape->size.y / 65536.0, y);
  return false;
}

static real3 farthest(const core2 *core, real3 d) {
  if (core->count == 0) {
    const double x = real_dot(core->axis[0], d), y = real_dot(core->axis[1], d), length = fmax(hypot(x, y), 1e-300);
    return real_add(core->centre,
                    real_add(real_scale(x / length, core->axis[0]), real_scale(y / length, core->axis[1])));
  }
  size_t best = 0;
  for (size_t i = 1; i < core->count; i++) {
    best = real_dot(core->corner[i], d) > real_dot(core->corner[best], d) ? i : best;
  }
  return core->corner[best];
}

static real3 direction_of(int i) {
  const double angle = 2 * PI * (i + 0.25) / OUTLINE_POINTS;
  const real3 d = {cos(angle), sin(angle), 0};
  return d;
}

static void set_body(const core2 *core, trace_body *out) {
  out->face_count = 0;
  out->round = core->radius > 0;
  out->outlines = core->count > 0 && !out->round ? core->count : OUTLINE_POINTS;
  for (size_t i = 0; i < out->outlines; i++) {
    const real3 d = direction_of((int)i), at = farthest(core, d);
    out->core[i] = core->count > 0 && !out->round ? core->corner[i] : at;
    out->outline[i] = real_add(out->core[i], real_scale(core->radius, d));
  }
}

// The difference of two polygons: the hull of the differences of their corners.
static void set_difference(const exact2_hull *a, const exact2_hull *b, exact2_hull *hull, core2 *out) {
  exact2_point *point = malloc((size_t)a->count * b->count * sizeof *point);
  for (unsigned i = 0; i < a->count * b->count && point != NULL; i++) {
    point[i].x = a->vertex[i % a->count].x - b->vertex[i / a->count].x;
    point[i].y = a->vertex[i % a->count].y - b->vertex[i / a->count].y;
  }
  if (point != NULL) {
    exact2_hull_find(point, a->count * b->count, hull);
    set_corners(hull, out);
  }
  free(point);
}

void trace_bodies_plane(const case2_pair *pair, const gjk2_collider *a, const gjk2_collider *b, trace_bodies *out) {
  static exact2_hull hull_a, hull_b, hull;
  static core2 core_a, core_b, core;
  static const view flat = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, 1, 0, 0};
  const bool listed_a = set_core(&pair->a, a, &hull_a, &core_a), listed_b = set_core(&pair->b, b, &hull_b, &core_b);
  out->camera = flat;
  set_body(&core_a, &out->a);
  set_body(&core_b, &out->b);
  core.radius = 0;
  if (listed_a && listed_b) {
    set_difference(&hull_a, &hull_b, &hull, &core);
    set_body(&core, &out->difference);
    return;
  }
  out->difference.face_count = 0;
  out->difference.round = false;
  out->difference.outlines = OUTLINE_POINTS;
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    const real3 d = direction_of(i);
    out->difference.outline[i] = real_sub(farthest(&core_a, d), farthest(&core_b, real_scale(-1, d)));
    out->difference.core[i] = out->difference.outline[i];
  }
}
