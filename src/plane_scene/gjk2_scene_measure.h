// What the narrow phase measures in the plane. The narrow phase alone includes this.
#ifndef GJK2_SRC_SCENE_MEASURE_H
#define GJK2_SRC_SCENE_MEASURE_H

#include "gjk2_scene_plane.h"

// A distance along a unit vector errs by less than this:
//
// the vector   2 sqrt(2) 2^-30 of at most sqrt(2) (2^30 + 2^4) LSB: less than 5
// the floor    1
#define GJK2_SCENE_LINE_SLACK 6

// The direction of a feature is exact.
#define GJK2_SCENE_NEAR_SLACK GJK2_SCENE_LINE_SLACK

// Writes the vector from the centre of A to that of B. False: they are 2^29 or more apart along an axis.
static inline bool gjk2_scene_between_centres(const gjk2_collider *a, const gjk2_collider *b, gjk2_vec *out) {
  const int64_t x = (int64_t)b->centre.x - a->centre.x, y = (int64_t)b->centre.y - a->centre.y;
  if ((gjk_magnitude64(x) | gjk_magnitude64(y)) >> 29 != 0) {
    return false;
  }
  //@ assert x > -(1L << 29) && x < 1L << 29;
  //@ assert y > -(1L << 29) && y < 1L << 29;
  out->x = (int32_t)x;
  out->y = (int32_t)y;
  return true;
}

// The length along d from a point of A to one of B, which are given as offsets from their centres.
//
// |centres| < 2^29, |on_a| < 2^28 + 2^3, |on_b| < 2^28 + 2^3 per axis:  |apart| < 2^30 + 2^4
static inline int64_t gjk2_scene_along(const gjk2_vec *d, const gjk2_vec *centres, const gjk2_vec *on_a,
                                       const gjk2_vec *on_b) {
  const gjk2_vec apart = {centres->x + on_b->x - on_a->x, centres->y + on_b->y - on_a->y};
  gjk2_length length;
  gjk2_unit u;
  gjk2_normal_set(&u, &length, d);
  return gjk_sar64(gjk_mac32(gjk_mul32(u.x, apart.x), u.y, apart.y), 30);
}

// The square of the distance of the centres. Pre: below 2^31 along each axis.
static inline uint64_t gjk2_scene_centres_squared(const gjk2_scene_part *a, const gjk2_scene_part *b) {
  const uint32_t x = gjk_scene_difference(a->centre.x, b->centre.x);
  const uint32_t y = gjk_scene_difference(a->centre.y, b->centre.y);
  return gjk_umul32(x, x) + gjk_umul32(y, y);
}

// The radius of a circle about the centre that lies inside the part at any rotation. -2^30: none is known, because the
// centre of a polygon's box may be outside the polygon.
//
// A posed half axis of a box is off by less than 5/4 LSB, so a support line comes nearer by less than 10/4.
static inline int32_t gjk2_scene_inner_radius(const gjk2_shape *shape) {
  if (!gjk2_scene_has_axes(shape)) {
    return -(INT32_C(1) << 30);
  }
  if (shape->type->count < 4) {
    return shape->convex_radius;
  }
  return (shape->size.x < shape->size.y ? shape->size.x : shape->size.y) - 3 + shape->convex_radius;
}

#endif
