// Rays in the plane: the cast of a point.
#include "../plane/gjk2_class.h"
#include "gjk2/cast.h"

static void support_ray_end(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  (void)c;
  (void)d;
  out->offset.x = 0;
  out->offset.y = 0;
  out->vertex = 0;
}

static bool vertex_ray_end(const gjk2_collider *c, uint16_t number, gjk2_vec *offset) {
  (void)c;
  offset->x = 0;
  offset->y = 0;
  return number == 0;
}

gjk_status gjk2_cast_ray(const gjk2_collider *a, const gjk2_vec *from, const gjk2_vec *to, gjk2_cast_result *out) {
  // No collider of a caller has this class: a ray needs neither posing nor order.
  static const gjk2_shape_class ray_end = {
      .measure = NULL,
      .pose = NULL,
      .support = support_ray_end,
      .vertex = vertex_ray_end,
      .adjacent = NULL,
      .depth = NULL,
      .touch = NULL,
      .ground = NULL,
      .buffered = false,
      .count = 1,
  };
  static const gjk2_vec origin = {0, 0};
  static const gjk2_shape point = {&ray_end, NULL, NULL, NULL, {0, 0}, 0, 0};
  if (from == NULL || to == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk2_cast_path path = {NULL, to, 0};
  gjk2_collider b;
  b.shape = &point;
  b.buffer = NULL;
  gjk2_copy(&b.position, from);
  gjk2_copy(&b.centre, from);
  // A point has no frame, but the places of a rounded cast are copies of the whole collider.
  gjk2_copy(&b.local_centre, &origin);
  for (int i = 0; i < 3; i++) {
    gjk2_copy(&b.frame[i], &origin);
  }
  b.fraction[0] = 0;
  b.fraction[1] = 0;
  b.core_radius = 0;
  b.radius = 0;
  b.count = 1;
  b.ordered = false;
  b.state = GJK2_STATE_POSED;
  return gjk2_cast(a, &b, &path, out);
}
