// A user's own shape of the plane, by its support function.
#include "gjk2_curved.h"
#include "gjk2_curved_depth.h"

static gjk_status measure_plane_custom(const gjk2_shape *shape, gjk2_extent *out) {
  const gjk2_vec origin = {0, 0};
  if (shape->support == NULL) {
    return GJK_ERROR_NULL;
  }
  if (shape->size.x < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  out->centre = origin;
  out->squared = (uint64_t)gjk_mul32(shape->size.x, shape->size.x);
  out->ordered = false;
  return GJK_OK;
}

// The user's point in fine units. A point beyond the bound is pulled back onto it, towards the local origin.
static gjk2_vec plane_within_bound(const gjk2_shape *shape, gjk2_vec at) {
  const gjk2_vec bound = {shape->size.x, shape->size.x};
  // Each square <= 2^62:  squared <= 2^63
  const uint64_t squared = (uint64_t)gjk_mul32(at.x, at.x) + (uint64_t)gjk_mul32(at.y, at.y);
  const bool within = squared <= (uint64_t)gjk_mul32(bound.x, bound.x);
  GJK_ASSERT(within);
  if (!within) {  // not reached: a shape that breaks its contract, which tests/check/unit/wild.c does
    return gjk2_fine_stretch(bound, at.x, at.y);
  }
  //@ assert at.x >= -GJK2_RADIUS_MAX && at.x <= GJK2_RADIUS_MAX;
  //@ assert at.y >= -GJK2_RADIUS_MAX && at.y <= GJK2_RADIUS_MAX;
  const gjk2_vec point = {at.x * (1 << GJK2_FINE_BITS), at.y * (1 << GJK2_FINE_BITS)};
  return point;
}

static void support_plane_custom(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec local = gjk2_curved_direction(c, *d);
  gjk2_vec at = {0, 0};
  c->shape->support(c->shape->user, &local, &at);
  gjk2_curved_support(c, plane_within_bound(c->shape, at), out);
}

const gjk2_shape_class gjk2_class_custom = GJK2_CURVED_CLASS(measure_plane_custom, support_plane_custom);
