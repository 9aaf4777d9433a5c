// Do two shapes intersect? Are they within a distance of each other?
#ifndef GJK_INTERSECT_H
#define GJK_INTERSECT_H

#include "gjk/cache.h"
#include "gjk/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// The answer to a yes-or-no question about a pair.
typedef struct gjk_decision {
  bool yes;                     // gjk_intersect: the shapes share a point; gjk_within: they are at most distance apart
  uint8_t iterations;           // support scans of both shapes that the answer took
  gjk_certificate certificate;  // why the answer is right
} gjk_decision;

// Do two convex shapes share a point? Shapes that touch in a single point do.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Written after OK.
// out     the caller's.
// Exact   always for points, segments, triangles, boxes, hulls and their forms with a convex radius. Cylinder, cone and
//         ellipsoid: right unless the surfaces are within 2 LSB of touching.
// Cost    stops at the first separating direction. At most GJK_ITERATIONS_OF(n, m) iterations, or GJK_ITERATIONS_MAX
//         with a curved shape (gjk/format.h). Stack: `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything; in the certificate, only what its proof uses.
// ITERATION_LIMIT      iterations. Only cylinder, cone, ellipsoid and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out);

// Are two convex shapes at most distance apart? If they are exactly that far apart, the answer is yes.
//
// a, b, cache, out  as in gjk_intersect.
// distance          Q16.16, at least 0; 0 asks the same as gjk_intersect.
// Exact             as in gjk_intersect. For centres more than 16384 units apart, to within 2^-28 of that distance.
// Cost              as in gjk_intersect; stops as soon as a bound from either side settles the answer.
// Statuses          as in gjk_intersect. NEGATIVE: distance is below 0, and nothing is valid in out.
gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out);

// What a number of iterations has settled.
typedef enum gjk_answer {
  GJK_ANSWER_NO = 0,   // proven: the answer is no
  GJK_ANSWER_YES = 1,  // proven: the answer is yes
  GJK_ANSWER_OPEN = 2  // neither is proven yet
} gjk_answer;

// What gjk_within_until finds.
typedef struct gjk_within_result {
  gjk_answer answer;      // yes, no or open
  gjk_decision decision;  // as in gjk_within; of an open answer only its iterations are set
} gjk_within_result;

// As gjk_within, but stops after a number of iterations.
//
// iterations  the most iterations, each of about the same cost; 0: no limit but that of gjk_within.
// cache       as in gjk_within. With a limit it is written but not read, so that the answer does not depend on it. An
//             open answer leaves it as it is.
// Exact       yes and no are as in gjk_within; more iterations never change them.
//
// OK                             answer, and decision as in gjk_within_result.
// ITERATION_LIMIT                the same, with an open answer: GJK_ITERATIONS_MAX iterations did not settle it.
// NULL, UNINITIALISED, NEGATIVE  nothing.
gjk_status gjk_within_until(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, uint8_t iterations,
                            gjk_cache *cache, gjk_within_result *out);

#ifdef __cplusplus
}
#endif

#endif
