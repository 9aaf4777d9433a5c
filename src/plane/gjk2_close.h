// Points, segments and boxes of two half axes in all, whose cores are apart: their distance or depth without a search.
#ifndef GJK2_SRC_CLOSE_H
#define GJK2_SRC_CLOSE_H

#include "gjk2/distance.h"
#include "gjk2_search.h"

// What is measured of such a pair. All flags: as gjk2_signed_distance. 0: only the certificate, and whether they
// intersect.
#define GJK2_TOUCH_POINTS 1u  // distance, bounds and points, where the shapes are apart
#define GJK2_TOUCH_DEPTH \
  2u  // and where they overlap, normal, depth and points: else only that they do, with a distance of 0
#define GJK2_TOUCH_ALL 3u
#define GJK2_TOUCH_GAP 4u  // distance, bounds and normal, where the shapes are apart

// Measures the pair. False: it is no such pair. Other builds lack this function: see GJK2_TOUCH_AXES.
static inline bool gjk2_touch_without_search(const gjk2_collider *a, const gjk2_collider *b, unsigned parts,
                                             gjk2_distance_result *out) {
#if GJK_SMALL || !GJK_64_BIT
  (void)a, (void)b, (void)parts, (void)out;
  return false;
#else
  const gjk2_shape_class *of_a = a->shape->type, *of_b = b->shape->type;
  const gjk2_shape_class *type = of_a->touch != NULL ? of_a : of_b;
  return type->touch != NULL && type->touch(a, b, parts, out);
#endif
}

// Keeps the direction for the next query, where there is a cache.
static inline void gjk2_touch_keep(const gjk2_distance_result *touch, gjk2_cache *cache) {
  if (cache != NULL) {
    cache->count = 0;
    gjk2_cache_direction(cache, touch->certificate.direction);
  }
}

#endif
