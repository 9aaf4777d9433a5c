// Builds the bodies of a trace.
#include "trace_body.h"

#include <math.h>

#define PI 3.14159265358979323846

// Where the camera stands: angle about the vertical, and above the horizon, radians.
#define AZIMUTH 0.42
#define ELEVATION 0.38

// Faces of the difference are looked for at this size, in units, and at this tolerance.
#define SIZE 100.0
#define TOLERANCE 1e-6

static real3 view_direction(const view *v, int i) {
  const double angle = 2 * PI * (i + 0.25) / OUTLINE_POINTS;
  return real_add(real_scale(cos(angle), v->right), real_scale(sin(angle), v->up));
}

static void set_body(const view *v, const case_shape *shape, trace_body *out) {
  case_shape core = *shape;
  core.convex_radius = 0;
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    const real3 d = view_direction(v, i);
    out->outline[i] = geometry_support(shape, d);
    out->core[i] = geometry_support(&core, d);
  }
  out->outlines = OUTLINE_POINTS;
  out->round = shape->convex_radius > 0;
  out->face_count = geometry_faces(&core, out->faces);
}

// The vertices of a core in the world, from the faces and outline that were found. Returns their number, at most n.
static size_t vertices_of(const case_shape *shape, const trace_body *body, real3 *out, size_t n) {
  size_t count = 0;
  if (shape->kind > CASE_HULL || (body->face_count == 0 && shape->count > 0)) {
    return 0;
  }
  const size_t points = body->face_count > 0 ? body->face_count * FACE_VERTICES_MAX : body->outlines;
  for (size_t i = 0; i < points; i++) {
    const real_face *face = &body->faces[i / FACE_VERTICES_MAX];
    if (body->face_count > 0 && i % FACE_VERTICES_MAX >= face->count) {
      continue;
    }
    const real3 p = body->face_count > 0 ? face->vertex[i % FACE_VERTICES_MAX] : body->core[i];
    size_t k = 0;
    while (k < count && real_dot(real_sub(out[k], p), real_sub(out[k], p)) > 1e-14) {
      k++;
    }
    if (k == count && count < n) {
      out[count++] = p;
    }
  }
  return count;
}

// Finds the faces of the difference of two polytopes with few vertices.
static void set_difference_faces(const case_pair *pair, trace_bodies *s) {
  static real3 a[GEOMETRY_POINTS_MAX], b[GEOMETRY_POINTS_MAX], point[GEOMETRY_POINTS_MAX];
  const size_t n = vertices_of(&pair->a, &s->a, a, GEOMETRY_POINTS_MAX);
  const size_t m = vertices_of(&pair->b, &s->b, b, GEOMETRY_POINTS_MAX);
  trace_body *d = &s->difference;
  double reach = 0;
  d->face_count = 0;
  if (n == 0 || m == 0 || n * m > GEOMETRY_POINTS_MAX) {
    return;
  }
  const real3 corner = real_sub(a[0], b[0]);
  for (size_t i = 0; i < n * m; i++) {
    point[i] = real_sub(real_sub(a[i / m], b[i % m]), corner);
    reach = fmax(reach, sqrt(real_dot(point[i], point[i])));
  }
  const double scale = reach > 0 ? SIZE / reach : 1;
  for (size_t i = 0; i < n * m; i++) {
    point[i] = real_scale(scale, point[i]);
  }
  d->face_count = geometry_hull_faces(point, n * m, TOLERANCE, d->faces);
  for (size_t i = 0; i < d->face_count; i++) {
    for (size_t k = 0; k < d->faces[i].count; k++) {
      d->faces[i].vertex[k] = real_add(real_scale(1 / scale, d->faces[i].vertex[k]), corner);
    }
  }
}

void trace_bodies_space(const case_pair *pair, trace_bodies *out) {
  trace_body *d = &out->difference;
  out->camera = view_make(AZIMUTH, ELEVATION);
  set_body(&out->camera, &pair->a, &out->a);
  set_body(&out->camera, &pair->b, &out->b);
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    const int opposite = (i + OUTLINE_POINTS / 2) % OUTLINE_POINTS;
    d->outline[i] = d->core[i] = real_sub(out->a.core[i], out->b.core[opposite]);
  }
  d->outlines = OUTLINE_POINTS;
  d->round = false;
  set_difference_faces(pair, out);
}
