// Points, segments and boxes of two half axes in all, whose cores are apart: their distance or depth without a search.
#ifndef GJK2_SRC_CLOSE_H
#define GJK2_SRC_CLOSE_H

#include "gjk2_search.h"

// What the queries report of such a pair, as of gjk2_signed_distance.
typedef struct gjk2_touch {
  gjk2_unit normal;
  gjk_q16 distance;
  gjk2_vec point_a, point_b;
  bool overlaps, saturated;
  gjk2_certificate certificate;  // NEAREST
} gjk2_touch;

// Measures the pair; false: it is another one. Elsewhere there is none: see GJK2_TOUCH_AXES.
static inline bool gjk2_touch_without_search(const gjk2_collider *a, const gjk2_collider *b, gjk2_touch *out) {
#if GJK_SMALL || !GJK_64_BIT
  (void)a, (void)b, (void)out;
  return false;
#else
  const gjk2_shape_class *of_a = a->shape->type, *of_b = b->shape->type;
  const gjk2_shape_class *type = of_a->touch != NULL ? of_a : of_b;
  return type->touch != NULL && type->touch(a, b, out);
#endif
}

// Keeps the direction for the next query, where there is a cache.
static inline void gjk2_touch_keep(const gjk2_touch *touch, gjk2_cache *cache) {
  if (cache != NULL) {
    cache->count = 0;
    gjk2_cache_direction(cache, touch->certificate.direction);
  }
}

// Copies the certificate.
static inline void gjk2_touch_certify(const gjk2_touch *touch, gjk2_proof proof, gjk2_certificate *out) {
  const gjk2_certificate *c = &touch->certificate;
  gjk2_copy(&out->direction, &c->direction);
  out->count = c->count;
  out->proof = (uint8_t)proof;
  out->a[0] = c->a[0];
  out->b[0] = c->b[0];
  if (c->count == 2) {
    out->a[1] = c->a[1];
    out->b[1] = c->b[1];
  }
}

#endif
