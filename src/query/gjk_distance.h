// What the distance and the penetration query share.
#ifndef GJK_SRC_DISTANCE_H
#define GJK_SRC_DISTANCE_H

#include "../gjk/gjk_iteration.h"
#include "gjk/distance.h"

// How far the distance of a plane, Q30, may be off: the unit vector is within 2^-28 of the exact direction and
// |w| <= 3 2^29.
#define GJK_PLANE_ERROR (INT64_C(1) << 33)

static inline int64_t gjk_convex_radii(const gjk_iteration *it) {
  return (int64_t)it->a->shape->convex_radius + it->b->shape->convex_radius;
}

// Do the cores come within the roundings of each other? plane: their distance in the frame, Q30. Pre: the feature is
// nearest.
bool gjk_convex_radii_touch(const gjk_iteration *it, int64_t plane);

// What the last round of an outcome LIMIT has proven of the distance, negative for minus a depth, in LSB. The newest vertex
// was the support along the direction, so nothing lies before its plane; and the feature's own plane, found from its own
// direction, touches the feature. That may settle it after all: ENCLOSING or NEAR, when upper is not positive; or LIMIT.
// Moves it->direction to the feature's.
gjk_outcome gjk_distance_bounds(gjk_iteration *it, int64_t *lower, int64_t *upper);

// Reports the answer and keeps the cache, which may be NULL. Pre: the outcome is not LIMIT; not SEPARATED.
void gjk_distance_report(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache, gjk_distance_result *out);

#endif
