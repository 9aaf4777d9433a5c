// Do two shapes of the plane intersect? Are they within a distance of each other?
#ifndef GJK2_INTERSECT_H
#define GJK2_INTERSECT_H

#include "gjk2/cache.h"
#include "gjk2/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// The answer to a yes-or-no question about a pair.
typedef struct gjk2_decision {
  bool yes;             // gjk2_intersect: the shapes share a point; gjk2_within: they are at most distance apart
  uint16_t iterations;  // support scans of both shapes that the answer took
  gjk2_certificate certificate;  // why the answer is right
} gjk2_decision;

// Do two convex shapes share a point? Shapes that touch in a single point do.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Written after OK.
// out     the caller's.
// Exact   always for points, segments, triangles, boxes, polygons and their forms with a convex radius. Ellipse: right
//         unless the surfaces are within 2 LSB of touching.
// Cost    stops at the first separating direction. At most GJK2_ITERATIONS_OF(n, m) iterations, or GJK_ITERATIONS_MAX
//         with a curved shape (gjk2/format.h). Stack: `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything; in the certificate, only what its proof uses.
// ITERATION_LIMIT      iterations. Only ellipse and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_intersect(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_decision *out);

// Are two convex shapes at most distance apart? If they are exactly that far apart, the answer is yes.
//
// a, b, cache, out  as in gjk2_intersect.
// distance          Q16.16, at least 0; 0 asks the same as gjk2_intersect.
// Exact             as in gjk2_intersect. For centres more than 16384 units apart, to within 2^-28 of that distance.
// Cost              as in gjk2_intersect; stops as soon as a bound from either side settles the answer.
// Statuses          as in gjk2_intersect. NEGATIVE: distance is below 0, and nothing is valid in out.
gjk_status gjk2_within(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, gjk2_cache *cache,
                       gjk2_decision *out);

// What a number of iterations has settled.
typedef enum gjk2_answer {
  GJK2_ANSWER_NO = 0,   // proven: the answer is no
  GJK2_ANSWER_YES = 1,  // proven: the answer is yes
  GJK2_ANSWER_OPEN = 2  // neither is proven yet
} gjk2_answer;

// What gjk2_within_until finds.
typedef struct gjk2_within_result {
  gjk2_answer answer;      // yes, no or open
  gjk2_decision decision;  // as in gjk2_within; of an open answer only its iterations are set
} gjk2_within_result;

// As gjk2_within, but stops after a number of iterations.
//
// iterations  the most iterations, each of about the same cost; 0: no limit but that of gjk2_within.
// cache       as in gjk2_within. With a limit it is written but not read, so that the answer does not depend on it. An
//             open answer leaves it as it is.
// Exact       yes and no are as in gjk2_within; more iterations never change them.
//
// OK                             answer, and decision as in gjk2_within_result.
// ITERATION_LIMIT                the same, with an open answer: GJK_ITERATIONS_MAX iterations did not settle it.
// NULL, UNINITIALISED, NEGATIVE  nothing.
gjk_status gjk2_within_until(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, uint8_t iterations,
                             gjk2_cache *cache, gjk2_within_result *out);

#ifdef __cplusplus
}
#endif

#endif
