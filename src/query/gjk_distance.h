// What the distance and the penetration queries share.
#ifndef GJK_SRC_DISTANCE_H
#define GJK_SRC_DISTANCE_H

#include "../gjk/gjk_iteration.h"
#include "gjk/penetration.h"

// How far off the distance of a plane along a rounded unit vector is, Q30.
//   unit vector   within 2^-28 of the exact direction:   4 in Q30
//   |w|           at most 3 2^29:                        4 3 2^29 < 2^33
#define GJK_PLANE_ERROR (INT64_C(1) << 33)

// The sum of both convex radii, LSB.
static inline int64_t gjk_convex_radii(const gjk_iteration *it) {
  return (int64_t)it->a->shape->convex_radius + it->b->shape->convex_radius;
}

// Are the cores within the sum of the convex radii of each other? Exact. plane: their distance in the frame, Q30,
// within GJK_PLANE_ERROR.
// Pre: the feature is nearest.
bool gjk_convex_radii_touch(const gjk_iteration *it, int64_t plane);

// The distance of the feature's plane in the frame, Q30, within GJK_PLANE_ERROR, and its unit normal. Pre: it->direction is
// the feature's.
int64_t gjk_plane_of(const gjk_iteration *it, gjk_unit3 *normal);

// The feature's distance in LSB, correctly rounded: to the nearest, a tie up, or down. In a far frame it is that of the
// rounded vertices. plane: its plane's distance, as of gjk_plane_of.
int64_t gjk_feature_distance(const gjk_iteration *it, int64_t plane, gjk_round_to to);

// Bounds of the distance, or of minus the depth, in LSB, that the last iteration of an outcome LIMIT proves.
//   lower   the newest vertex is the support vertex along the direction: no vertex of A - B lies before its plane
//   upper   the plane of the feature, across the feature's own direction, touches it
// Returns ENCLOSING or NEAR when upper <= 0 settles the question after all, otherwise LIMIT. Sets it->direction to the
// feature's.
gjk_outcome gjk_distance_bounds(gjk_iteration *it, int64_t *lower, int64_t *upper);

// Reports the answer and keeps the cache, which may be NULL. points: are points and certificate needed? Otherwise they are
// left out. Pre: the outcome is NEAREST, ENCLOSING or NEAR.
void gjk_distance_report(const gjk_iteration *it, gjk_outcome outcome, bool points, gjk_cache *cache,
                         gjk_distance_result *out);

// What is wanted of a distance.
typedef enum gjk_distance_detail {
  GJK_DISTANCE_ALONE,    // all but normal, points and certificate
  GJK_DISTANCE_POINTS,   // all
  GJK_DISTANCE_BY_SCANS  // all, and the certificate's feature by the same way in every build
} gjk_distance_detail;

// gjk_distance of that detail.
gjk_status gjk_distance_with(const gjk_collider *a, const gjk_collider *b, gjk_distance_detail detail, gjk_cache *cache,
                             gjk_distance_result *out);

// gjk_signed_distance. *points: are points and certificate needed? If not, they are left out for boxes that overlap
// with a face, or lie apart with one across the normal. Otherwise they are set, and *points becomes true.
gjk_status gjk_signed_distance_along(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                                     const gjk_workspace *workspace, bool *points, gjk_distance_result *out);

#endif
