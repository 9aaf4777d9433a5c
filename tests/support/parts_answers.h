// Are two answers the same, in all that their statuses make valid?
#ifndef PARTS_ANSWERS_H
#define PARTS_ANSWERS_H

#include <stdbool.h>

#include "gjk/gjk.h"

static inline bool same_place(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

static inline bool same_unit(const gjk_unit3 *a, const gjk_unit3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

static inline bool same_certificate(const gjk_certificate *a, const gjk_certificate *b) {
  bool same = a->proof == b->proof && a->count == b->count;
  for (unsigned i = 0; same && i < a->count; i++) {
    same = a->a[i] == b->a[i] && a->b[i] == b->b[i];
  }
  return same &&
         ((a->proof != GJK_PROOF_DIRECTION && a->proof != GJK_PROOF_PLANE) || same_place(&a->direction, &b->direction));
}

static inline bool same_decision(const gjk_decision *a, const gjk_decision *b) {
  return a->yes == b->yes && a->iterations == b->iterations && same_certificate(&a->certificate, &b->certificate);
}

static inline bool same_distance(const gjk_distance_result *a, const gjk_distance_result *b) {
  return a->distance == b->distance && a->lower == b->lower && a->upper == b->upper &&
         a->intersecting == b->intersecting && a->saturated == b->saturated && a->iterations == b->iterations &&
         same_certificate(&a->certificate, &b->certificate) &&
         (a->intersecting || (same_place(&a->point_a, &b->point_a) && same_place(&a->point_b, &b->point_b) &&
                              same_unit(&a->normal, &b->normal)));
}

#endif
