// Are answers in space the same, but for iterations and certificate? Fields that are not set are 0. Structures have padding,
// so they are compared field by field.
#ifndef SAME_H
#define SAME_H

#include "gjk/gjk.h"

static inline bool same_vec3(const gjk_vec3 *p, const gjk_vec3 *q) {
  return p->x == q->x && p->y == q->y && p->z == q->z;
}

static inline bool same_unit3(const gjk_unit3 *p, const gjk_unit3 *q) {
  return p->x == q->x && p->y == q->y && p->z == q->z;
}

static inline bool same_quat(const gjk_quat *p, const gjk_quat *q) {
  return p->x == q->x && p->y == q->y && p->z == q->z && p->w == q->w;
}

static inline bool same_pose(const gjk_pose *p, const gjk_pose *q) {
  return same_vec3(&p->position, &q->position) && same_quat(&p->rotation, &q->rotation);
}

static inline bool same_gap(const gjk_distance_result *p, const gjk_distance_result *q) {
  return p->distance == q->distance && p->lower == q->lower && p->upper == q->upper &&
         p->intersecting == q->intersecting && p->saturated == q->saturated && same_vec3(&p->point_a, &q->point_a) &&
         same_vec3(&p->point_b, &q->point_b) && same_unit3(&p->normal, &q->normal);
}

static inline bool same_depth(const gjk_penetration_result *p, const gjk_penetration_result *q) {
  return p->depth == q->depth && p->lower == q->lower && p->upper == q->upper && p->intersecting == q->intersecting &&
         same_vec3(&p->point_a, &q->point_a) && same_vec3(&p->point_b, &q->point_b) &&
         same_unit3(&p->normal, &q->normal);
}

static inline bool same_manifold(const gjk_manifold *p, const gjk_manifold *q) {
  bool same = p->count == q->count && p->feature_a == q->feature_a && p->feature_b == q->feature_b &&
              same_unit3(&p->normal, &q->normal);
  for (int i = 0; i < p->count && same; i++) {
    const gjk_contact *a = &p->contact[i], *b = &q->contact[i];
    same = same_vec3(&a->point_a, &b->point_a) && same_vec3(&a->point_b, &b->point_b) && a->distance == b->distance &&
           a->id == b->id;
  }
  return same;
}

#endif
