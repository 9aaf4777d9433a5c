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
  uint8_t iterations;  // iterations used: support scans of both shapes
  gjk_certificate certificate;
} gjk_decision;

// Do two convex shapes share a point? Shapes that touch in a single point do.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Kept after OK.
// Exact   always for points, segments, triangles, boxes, hulls and their rounded forms; for cylinder, cone,
//         ellipsoid: right unless the surfaces are within 2 LSB of touching.
// Cost    stops at the first separating direction; at most GJK_ITERATIONS_OF(n, m) iterations, see gjk/format.h; stack: `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; after an error all else is as it was:
//
// OK                   everything; of the certificate what its proof uses.
// ITERATION_LIMIT      iterations. Of cylinder, cone, ellipsoid and custom alone.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out);

// Are two convex shapes at most distance apart (closed: exactly that far is within)?
//
// distance  Q16.16, at least 0; 0 asks the same as gjk_intersect.
// Statuses  as gjk_intersect; NEGATIVE, a distance below 0: nothing is valid.
// The rest as gjk_intersect; stops as soon as a bound from either side settles it. Centres more than 16384
// units apart: exact to 2^-28 of their distance.
gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out);

// What a number of iterations has settled.
typedef enum gjk_answer {
  GJK_ANSWER_NO = 0,
  GJK_ANSWER_YES = 1,
  GJK_ANSWER_OPEN = 2  // neither is proven yet
} gjk_answer;

typedef struct gjk_within_result {
  gjk_answer answer;
  gjk_decision decision;  // as of gjk_within; while the answer is open its iterations alone
} gjk_within_result;

// As gjk_within, but stops after so many iterations.
//
// iterations   at most so many, each of about the same cost; 0: no limit but that of gjk_within.
// cache    as gjk_within, but with a limit it is only written: what so many iterations settle must not depend on it. An open answer
//          leaves it as it is.
// Exact    yes and no as of gjk_within; more iterations never change them.
//
// OK                             answer, and decision as stated there.
// ITERATION_LIMIT                the same, open: GJK_ITERATIONS_MAX iterations have not settled it.
// NULL, UNINITIALISED, NEGATIVE  nothing.
gjk_status gjk_within_until(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, uint8_t iterations,
                            gjk_cache *cache, gjk_within_result *out);

#ifdef __cplusplus
}
#endif

#endif
