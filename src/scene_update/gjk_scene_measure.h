// What the narrow phase measures in space, and what it keeps of a query. gjk_scene_narrow_phase.c alone includes this.
#ifndef GJK_SRC_SCENE_MEASURE_H
#define GJK_SRC_SCENE_MEASURE_H

#include "../arith/gjk_unit.h"
#include "../scene/gjk_scene_space.h"

// A distance along a unit vector errs by less than this:
//
// the vector   sqrt(3) 2^-30 of at most sqrt(3) 2^30 LSB: 3
// the floor    1
#define GJK_SCENE_PLANE_SLACK 4

// A distance along a feature's rounded direction errs by less than this:
//
// the direction   it is exact, or its components err by less than 1, the largest of at least 2^29. So the unit vectors
//                 differ by less than 2 sqrt(3) 2^-29, of at most 3 2^29 LSB: 10.4
// the rest        GJK_SCENE_PLANE_SLACK
#define GJK_SCENE_NEAR_SLACK 16

// The length of v along d, rounded down: less than GJK_SCENE_PLANE_SLACK off for |v| <= 2^30 + 2^4 per axis.
static int64_t gjk_scene_along_unit(const gjk_vec3 *d, const gjk_vec3 *v) {
  const gjk_unit3 u = gjk_unit(d);
  return gjk_sar64(gjk_mac32(gjk_mac32(gjk_mul32(u.x, v->x), u.y, v->y), u.z, v->z), 30);
}

// Writes the vector from the centre of A to that of B. False: they are 2^29 or more apart along an axis.
static bool gjk_scene_between_centres(const gjk_collider *a, const gjk_collider *b, gjk_vec3 *out) {
  const int64_t x = (int64_t)b->centre.x - a->centre.x, y = (int64_t)b->centre.y - a->centre.y;
  const int64_t z = (int64_t)b->centre.z - a->centre.z;
  if ((gjk_magnitude64(x) | gjk_magnitude64(y) | gjk_magnitude64(z)) >> 29 != 0) {
    return false;
  }
  //@ assert x > -(1L << 29) && x < 1L << 29;
  //@ assert y > -(1L << 29) && y < 1L << 29;
  //@ assert z > -(1L << 29) && z < 1L << 29;
  out->x = (int32_t)x;
  out->y = (int32_t)y;
  out->z = (int32_t)z;
  return true;
}

// The length along d from a point of A to one of B, which are given as offsets from their centres.
//
// |centres| < 2^29, |on_a| < 2^28 + 2^3, |on_b| < 2^28 + 2^3 per axis:  |apart| < 2^30 + 2^4
static int64_t gjk_scene_along(const gjk_vec3 *d, const gjk_vec3 *centres, const gjk_vec3 *on_a, const gjk_vec3 *on_b) {
  const gjk_vec3 apart = {centres->x + on_b->x - on_a->x, centres->y + on_b->y - on_a->y,
                          centres->z + on_b->z - on_a->z};
  return gjk_scene_along_unit(d, &apart);
}

// The square of the distance of the centres. Pre: below 2^31 along each axis.
static uint64_t gjk_scene_centres_squared(const gjk_scene_part *a, const gjk_scene_part *b) {
  const uint32_t x = gjk_scene_difference(a->centre.x, b->centre.x);
  const uint32_t y = gjk_scene_difference(a->centre.y, b->centre.y);
  const uint32_t z = gjk_scene_difference(a->centre.z, b->centre.z);
  return gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z);
}

// The radius of a sphere about the centre that lies inside the part at any rotation. -2^30: none is known, because the
// centre of a hull's box may be outside the hull.
//
// A posed half axis of a box is off by less than 5/4 LSB, so a support plane comes nearer by less than 15/4.
static int32_t gjk_scene_inner_radius(const gjk_shape *shape) {
  const gjk_vec3 *size = &shape->size;
  if (!gjk_has_half_axes(shape)) {
    return -(INT32_C(1) << 30);
  }
  if (shape->type->count < 3) {
    return shape->convex_radius;
  }
  const int32_t least = size->x < size->y ? size->x : size->y;
  return (least < size->z ? least : size->z) - 4 + shape->convex_radius;
}

// A pair keeps vertices whose numbers fit a byte. A query finds others anew.
static void gjk_scene_load_cache(const gjk_scene_pair *pair, gjk_cache *cache) {
  cache->count = (uint16_t)(pair->state >> GJK_SCENE_PAIR_CACHED);
  for (int i = 0; i < 3; i++) {
    cache->direction[i] = pair->hint.direction[i];
  }
  for (int i = 0; i < 4; i++) {
    cache->a[i] = pair->a[i];
    cache->b[i] = pair->b[i];
  }
}

static void gjk_scene_store_cache(const gjk_cache *cache, bool near, gjk_scene_pair *pair) {
  (void)near;
  unsigned count = 0;
  for (unsigned i = 0; i < cache->count && i < 4; i++) {  // not reached: 4: what a query keeps has no more
    if (cache->a[i] < 256 && cache->b[i] < 256) {
      pair->a[count] = (uint8_t)cache->a[i];
      pair->b[count] = (uint8_t)cache->b[i];
      count++;
    }
  }
  for (int i = 0; i < 3; i++) {
    pair->hint.direction[i] = cache->direction[i];
  }
  const unsigned flags = pair->state & ((1u << GJK_SCENE_PAIR_CACHED) - 1);
  pair->state = (uint8_t)(flags | count << GJK_SCENE_PAIR_CACHED);
}

#endif
