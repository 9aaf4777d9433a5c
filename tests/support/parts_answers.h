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

static inline bool same_penetration(const gjk_penetration_result *a, const gjk_penetration_result *b) {
  return a->intersecting == b->intersecting && a->iterations == b->iterations &&
         same_certificate(&a->certificate, &b->certificate) &&
         (!a->intersecting || (a->depth == b->depth && a->lower == b->lower && a->upper == b->upper &&
                               same_place(&a->point_a, &b->point_a) && same_place(&a->point_b, &b->point_b) &&
                               same_unit(&a->normal, &b->normal)));
}

static inline bool same_manifold(const gjk_manifold *a, const gjk_manifold *b) {
  bool same = a->count == b->count && same_unit(&a->normal, &b->normal) && a->feature_a == b->feature_a &&
              a->feature_b == b->feature_b;
  for (unsigned i = 0; same && i < a->count; i++) {
    const gjk_contact *p = &a->contact[i], *q = &b->contact[i];
    same = same_place(&p->point_a, &q->point_a) && same_place(&p->point_b, &q->point_b) && p->distance == q->distance &&
           p->id == q->id;
  }
  return same;
}

// But for rest_a and rest_b.
static inline bool same_cast(const gjk_cast_result *a, const gjk_cast_result *b) {
  return a->hit == b->hit && a->inside == b->inside && a->fraction == b->fraction && a->iterations == b->iterations &&
         same_unit(&a->normal, &b->normal) && a->certificate.proof == b->certificate.proof &&
         (a->inside || (same_place(&a->point_a, &b->point_a) && same_place(&a->point_b, &b->point_b)));
}

static inline bool same_impact(const gjk_impact_result *a, const gjk_impact_result *b) {
  return a->hit == b->hit && a->overlap == b->overlap && a->lower == b->lower && a->upper == b->upper &&
         a->iterations == b->iterations && (!a->hit || a->distance == b->distance);
}

#endif
