// Are answers of the plane the same, but for iterations and certificate?
#ifndef PLANE_SAME_H
#define PLANE_SAME_H

#include "gjk2/gjk2.h"

static inline bool same_place(const gjk2_vec *p, const gjk2_vec *q) {
  return p->x == q->x && p->y == q->y;
}

// Fields that are not set are 0.
static inline bool same_gap(const gjk2_distance_result *p, const gjk2_distance_result *q) {
  return p->distance == q->distance && p->lower == q->lower && p->upper == q->upper &&
         same_place(&p->point_a, &q->point_a) && same_place(&p->point_b, &q->point_b) && p->normal.x == q->normal.x &&
         p->normal.y == q->normal.y && p->intersecting == q->intersecting && p->saturated == q->saturated;
}

static inline bool same_depth(const gjk2_penetration_result *p, const gjk2_penetration_result *q) {
  return p->depth == q->depth && p->lower == q->lower && p->upper == q->upper && same_place(&p->point_a, &q->point_a) &&
         same_place(&p->point_b, &q->point_b) && p->normal.x == q->normal.x && p->normal.y == q->normal.y &&
         p->intersecting == q->intersecting;
}

static inline bool same_manifold(const gjk2_manifold *p, const gjk2_manifold *q) {
  bool same = p->count == q->count && p->feature_a == q->feature_a && p->feature_b == q->feature_b &&
              p->normal.x == q->normal.x && p->normal.y == q->normal.y;
  for (int i = 0; i < p->count && same; i++) {
    const gjk2_contact *a = &p->contact[i], *b = &q->contact[i];
    same = same_place(&a->point_a, &b->point_a) && same_place(&a->point_b, &b->point_b) && a->distance == b->distance &&
           a->id == b->id;
  }
  return same;
}

#endif
