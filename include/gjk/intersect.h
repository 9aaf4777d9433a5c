// Do two shapes touch? Nearer than a distance?
#ifndef GJK_INTERSECT_H
#define GJK_INTERSECT_H

#include "gjk/cache.h"
#include "gjk/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// The answer to a yes-or-no question about a pair.
typedef struct gjk_decision {
  bool yes;            // intersect: they share a point; within: they are at most that far apart
  uint8_t iterations;  // rounds used: support scans of both shapes
  gjk_certificate certificate;
} gjk_decision;

// Do two convex shapes share a point? Shapes that touch in a single point do.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only.
// out     written when the result is GJK_OK.
// Exact   always for points, segments, triangles, boxes, hulls and their rounded forms; for cylinder, cone,
//         ellipsoid: right unless the surfaces are within 2 LSB of touching.
// Cost    stops at the first separating direction; at most GJK_ITERATIONS_MAX rounds; stack: `make sizes`.
// Statuses NULL, UNINITIALISED, ITERATION_LIMIT (out: iterations alone are set).
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out);

// Are two convex shapes at most distance apart (closed: exactly that far is within)?
//
// distance  Q16.16, at least 0 (GJK_ERROR_NEGATIVE); 0 asks the same as gjk_intersect.
// The rest as gjk_intersect; stops as soon as a bound from either side settles it. Centres more than 16384
// units apart: exact to 2^-28 of their distance.
gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out);

#ifdef __cplusplus
}
#endif

#endif
