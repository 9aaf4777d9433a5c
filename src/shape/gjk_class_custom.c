// A user's own shape, by its support function.
#include "gjk_curved.h"

static gjk_status measure_custom(const gjk_shape *shape, gjk_extent *out) {
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

// The user's point in fine units. A point beyond the bound is pulled back onto it, towards the local origin.
static gjk_fine_point within_bound(const gjk_shape *shape, const gjk_vec3 *at) {
  const gjk_vec3 bound = {shape->size.x, shape->size.x, shape->size.x};
  // Each square <= 2^62:  squared <= 3 2^62
  const uint64_t squared =
      (uint64_t)gjk_mul32(at->x, at->x) + (uint64_t)gjk_mul32(at->y, at->y) + (uint64_t)gjk_mul32(at->z, at->z);
  const bool within = squared <= (uint64_t)gjk_mul32(bound.x, bound.x);
  GJK_ASSERT(within);
  if (!within) {
    const gjk_long3 far = {at->x, at->y, at->z};  // not reached: where the assertion above ends the program
    return gjk_fine_stretch(&bound, &far);
  }
  const gjk_fine_point point = {at->x * (1 << GJK_FINE_BITS), at->y * (1 << GJK_FINE_BITS),
                                at->z * (1 << GJK_FINE_BITS)};
  return point;
}

static void support_custom(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 local = gjk_curved_direction(c, d);
  gjk_vec3 at = {0, 0, 0};
  c->shape->support(c->shape->user, &local, &at);
  const gjk_fine_point point = within_bound(c->shape, &at);
  gjk_curved_support(c, &point, out);
}

const gjk_shape_class gjk_class_custom = GJK_CURVED_CLASS(measure_custom, support_custom, GJK_KIND_SMOOTH);
