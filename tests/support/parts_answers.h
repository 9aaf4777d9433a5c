// Are two answers the same, in all that their statuses make valid?
#ifndef PARTS_ANSWERS_H
#define PARTS_ANSWERS_H

#include <stdbool.h>

#include "gjk/gjk.h"
#include "same.h"

static inline bool same_certificate(const gjk_certificate *a, const gjk_certificate *b) {
  bool same = a->proof == b->proof && a->count == b->count;
  for (unsigned i = 0; same && i < a->count; i++) {
    same = a->a[i] == b->a[i] && a->b[i] == b->b[i];
  }
  return same &&
         ((a->proof != GJK_PROOF_DIRECTION && a->proof != GJK_PROOF_PLANE) || same_vec3(&a->direction, &b->direction));
}

static inline bool same_decision(const gjk_decision *a, const gjk_decision *b) {
  return a->yes == b->yes && a->iterations == b->iterations && same_certificate(&a->certificate, &b->certificate);
}

static inline bool same_distance(const gjk_distance_result *a, const gjk_distance_result *b) {
  return a->distance == b->distance && a->lower == b->lower && a->upper == b->upper &&
         a->intersecting == b->intersecting && a->saturated == b->saturated && a->iterations == b->iterations &&
         same_certificate(&a->certificate, &b->certificate) &&
         (a->intersecting || (same_vec3(&a->point_a, &b->point_a) && same_vec3(&a->point_b, &b->point_b) &&
                              same_unit3(&a->normal, &b->normal)));
}

static inline bool same_penetration(const gjk_penetration_result *a, const gjk_penetration_result *b) {
  return a->intersecting == b->intersecting && a->iterations == b->iterations &&
         same_certificate(&a->certificate, &b->certificate) &&
         (!a->intersecting || (a->depth == b->depth && a->lower == b->lower && a->upper == b->upper &&
                               same_vec3(&a->point_a, &b->point_a) && same_vec3(&a->point_b, &b->point_b) &&
                               same_unit3(&a->normal, &b->normal)));
}

// But for rest_a and rest_b. A miss has no more than iterations and certificate.
static inline bool same_cast(const gjk_cast_result *a, const gjk_cast_result *b) {
  return a->hit == b->hit && a->iterations == b->iterations && a->certificate.proof == b->certificate.proof &&
         a->certificate.count == b->certificate.count &&
         (!a->hit || (a->inside == b->inside && a->fraction == b->fraction && same_unit3(&a->normal, &b->normal) &&
                      (a->inside || (same_vec3(&a->point_a, &b->point_a) && same_vec3(&a->point_b, &b->point_b)))));
}

static inline bool same_impact(const gjk_impact_result *a, const gjk_impact_result *b) {
  return a->hit == b->hit && a->overlap == b->overlap && a->lower == b->lower && a->upper == b->upper &&
         a->iterations == b->iterations && (!a->hit || a->distance == b->distance);
}

#endif
