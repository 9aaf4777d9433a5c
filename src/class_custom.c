// A user's own shape by its support function.
#include "curved.h"

static gjk_status measure(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 origin = {0, 0, 0};
  if (shape->support == NULL) {
    return GJK_ERROR_NULL;
  }
  if (shape->size.x < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  out->centre = origin;
  out->squared = (uint64_t)gjk_mul32(shape->size.x, shape->size.x);
  return GJK_OK;
}

static void support(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 local = gjk_curved_direction(c, d);
  const int32_t bound = c->shape->size.x;
  gjk_vec3 at = {0, 0, 0};
  c->shape->support(c->shape->user, &local, &at);
  GJK_ASSERT(at.x >= -bound && at.x <= bound && at.y >= -bound && at.y <= bound && at.z >= -bound && at.z <= bound);
  (void)bound;
  const gjk_fine_point point = {at.x * (1 << GJK_FINE_BITS), at.y * (1 << GJK_FINE_BITS), at.z * (1 << GJK_FINE_BITS)};
  gjk_curved_support(c, &point, out);
}

const gjk_shape_class gjk_class_custom = {measure,           gjk_curved_pose, support, NULL,           NULL,
                                          gjk_curved_stalls, false,           0,       GJK_KIND_SMOOTH};
