// Boxes around ground, and what fits in its limits.
#ifndef GJK2_SRC_GROUND_BOX_H
#define GJK2_SRC_GROUND_BOX_H

#include "../plane/gjk2_vector.h"
#include "gjk2/ground.h"

static inline bool gjk2_ground_fits(gjk2_vec v) {
  return v.x <= GJK2_GROUND_REACH && v.x >= -GJK2_GROUND_REACH && v.y <= GJK2_GROUND_REACH && v.y >= -GJK2_GROUND_REACH;
}

// Pre: both ends fit, so differences are below 2^29 + 2.
static inline bool gjk2_ground_fits_segment(gjk2_vec p, gjk2_vec q) {
  return gjk2_norm1(gjk2_sub(q, p)) <= (uint32_t)GJK2_GROUND_REACH;
}

// Does ground at this position stay in int32 at any rotation?
static inline bool gjk2_ground_has_room(const gjk2_vec *position) {
  const gjk_q16 most = INT32_MAX - 2 * GJK2_GROUND_REACH;
  return position->x <= most && position->x >= -most && position->y <= most && position->y >= -most;
}

// The least box that holds both.
static inline gjk2_aabb gjk2_aabb_hull(const gjk2_aabb *a, const gjk2_aabb *b) {
  gjk2_aabb box = *a;
  box.lower.x = b->lower.x < box.lower.x ? b->lower.x : box.lower.x;
  box.lower.y = b->lower.y < box.lower.y ? b->lower.y : box.lower.y;
  box.upper.x = b->upper.x > box.upper.x ? b->upper.x : box.upper.x;
  box.upper.y = b->upper.y > box.upper.y ? b->upper.y : box.upper.y;
  return box;
}

// Writes ground and its shape, or returns SIZE. Pre: the box's corners fit.
gjk_status gjk2_ground_set(const gjk2_ground_class *type, const void *data, const gjk2_aabb *box, gjk2_ground *out,
                           gjk2_shape *shape);

#endif
