#include "hostile.h"

#include <string.h>

#include "filled.h"

void hostile_check(gjk_status status, const void *output, size_t size) {
  if (status > GJK_OK || strcmp(gjk_status_name(status), "GJK_ERROR_UNKNOWN") == 0) {
    fuzz_fail("unknown status");
  }
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT || status == GJK_ERROR_CAPACITY) {
    return;
  }
  if (!is_filled(output, size, HOSTILE_POISON)) {
    fuzz_fail("an error wrote to its output");
  }
}

gjk_quat hostile_quat(fuzz_bytes *bytes) {
  gjk_quat q, unit;
  q.x = fuzz_i32(bytes);
  q.y = fuzz_i32(bytes);
  q.z = fuzz_i32(bytes);
  q.w = fuzz_i32(bytes);
  const bool keep = fuzz_u8(bytes) % 4 == 0;
  return keep || gjk_quat_normalize(&q, &unit) != GJK_OK ? q : unit;
}

gjk_vec3 hostile_vec3(fuzz_bytes *bytes, unsigned shift) {
  gjk_vec3 v = fuzz_vec3(bytes);
  v.x >>= shift;
  v.y >>= shift;
  v.z >>= shift;
  return v;
}

static const void *maybe(fuzz_bytes *bytes, const void *pointer) {
  return hostile_leaves_out(bytes) ? NULL : pointer;
}

static const gjk_hull_faces *make_faces(fuzz_bytes *bytes, hostile_shape *out) {
  for (unsigned k = 0; k < HOSTILE_CORNERS; k++) {
    out->corner[k] = fuzz_u8(bytes) % (HOSTILE_VERTICES + 1);
  }
  for (unsigned k = 0; k < HOSTILE_FACES; k++) {
    out->end[k] = fuzz_u8(bytes) % (HOSTILE_CORNERS + 1);
  }
  out->faces.corner = maybe(bytes, out->corner);
  out->faces.end = maybe(bytes, out->end);
  out->faces.count = fuzz_u8(bytes) % (HOSTILE_FACES + 1);
  return &out->faces;
}

static void origin_or_corner(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  const gjk_vec3 corner = {direction->x < 0 ? -1 : 1, 0, 0}, none = {0, 0, 0};
  *out = user != NULL ? corner : none;
}

void hostile_make_shape(fuzz_bytes *bytes, hostile_shape *out) {
  static const gjk_shape_class *const types[] = {
      &gjk_class_point, &gjk_class_segment,  &gjk_class_triangle, &gjk_class_box,       &gjk_class_hull,
      &gjk_class_hull,  &gjk_class_cylinder, &gjk_class_cone,     &gjk_class_ellipsoid, &gjk_class_custom};
  gjk_shape *s = &out->shape;
  s->type = maybe(bytes, types[fuzz_u8(bytes) % (sizeof types / sizeof types[0])]);
  s->vertices = maybe(bytes, out->vertices);
  s->support = hostile_leaves_out(bytes) ? NULL : origin_or_corner;
  s->user = maybe(bytes, out);
  s->size = fuzz_vec3(bytes);
  const unsigned shift = fuzz_u8(bytes) % 32;
  s->size.x >>= shift;
  s->size.y >>= shift;
  s->size.z >>= shift;
  s->convex_radius = fuzz_i32(bytes) >> (fuzz_u8(bytes) % 32);
  s->count = s->type == &gjk_class_triangle ? 3 : fuzz_u8(bytes) % (HOSTILE_VERTICES + 1);
  for (int k = 0; k < HOSTILE_VERTICES; k++) {
    out->vertices[k] = hostile_vec3(bytes, shift);
  }
  s->faces = fuzz_u8(bytes) % 2 == 0 ? NULL : make_faces(bytes, out);
}
