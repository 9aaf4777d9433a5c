// How far apart are two shapes of the plane, and where?
#ifndef GJK2_DISTANCE_H
#define GJK2_DISTANCE_H

#include "gjk2/cache.h"
#include "gjk2/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// Lengths Q16.16, points in the world frame.
typedef struct gjk2_distance_result {
  gjk_q16 distance;     // gap between the surfaces; 0 when intersecting, GJK2_DISTANCE_MAX if the gap is larger
  gjk_q16 lower;        // proven lower bound of the gap, inclusive; equal to distance if the answer is exact
  gjk_q16 upper;        // proven upper bound of the gap, inclusive; equal to distance if the answer is exact
  gjk2_vec point_a;     // nearest point of A; not set when intersecting
  gjk2_vec point_b;     // nearest point of B; not set when intersecting
  gjk2_unit normal;     // from A to B, Q2.30; not set when intersecting
  bool intersecting;    // the shapes share a point
  bool saturated;       // the gap or a coordinate of a point is beyond Q16.16, and set to the end of that range
  uint16_t iterations;  // support scans of both shapes
  gjk2_certificate certificate;  // why the answer is right
} gjk2_distance_result;

// The largest distance that is reported.
#define GJK2_DISTANCE_MAX ((gjk_q16)2147483647)

// The distance between two convex shapes, with a nearest point on each.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Written after OK.
// out     the caller's.
// Exact   points, segments, triangles, boxes, polygons and their forms with a convex radius:
//           separated or not   always
//           distance           rounded to the nearest LSB, ties up. A gap below 1/2 LSB gives 0 with intersecting false
//           points             each within 1 LSB of its shape; their gap is within 2 LSB of distance
//           normal             within 2^-28
//         Ties: where edges are parallel, the points divide the whole shared edge of A - B. They lie in the same
//         proportion on both edges.
//         Ellipse: distance and points within 2 LSB of the exact surface.
//         Centres more than 16384 units apart:
//           distance           within 2^-28 of its value, or 2^-27 for curved shapes
//           points             within 2^-27 of the distance; the gap along the normal is distance, to 2^-27
// Cost    at most GJK2_ITERATIONS_OF(n, m) iterations, or GJK_ITERATIONS_MAX with a curved shape (gjk2/format.h).
//         Stack: `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything, points and normal unless intersecting; in the certificate, only what its proof uses.
// ITERATION_LIMIT      everything, as in gjk2_distance_until: 0 <= lower <= gap <= upper. lower above 0 proves that the
//                      shapes are apart. Only ellipse and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_distance_result *out);

// When gjk2_distance_until stops.
typedef struct gjk2_effort {
  uint8_t iterations;  // the most iterations; 0: no limit but that of gjk2_distance
  gjk_q16 error;       // stop once upper - lower is at most this, Q16.16; 0: exact
} gjk2_effort;

// As gjk2_distance, but stops when the effort is spent, and reports what is proven by then:
//
// lower, upper      inclusive bounds of the gap. They are equal if the answer is exact, as in gjk2_distance.
// distance          from point_a to point_b, to the nearest LSB; upper is the same, rounded up. With centres more than
//                   16384 units apart, it is upper.
// point_a, point_b  points of the shapes, as accurate as in gjk2_distance, and distance apart to within 2 LSB. Not set
//                   when intersecting.
// normal            a direction from A to B.
// intersecting      true is proven. false proves nothing if lower is 0.
// certificate       its proof is GJK2_PROOF_NONE unless the answer is exact.
//
// effort   read only; error at least 0 (GJK_ERROR_NEGATIVE).
// cache    out, the caller's; NULL = none. It is not read, so that the result does not depend on it. Written if the
//          answer is exact.
// Cost     an iteration costs about a third more than in gjk2_distance, because it computes the bounds.
//
// OK                             everything, as above.
// ITERATION_LIMIT                the same: effort allows GJK_ITERATIONS_MAX iterations, which did not settle it.
// NULL, UNINITIALISED, NEGATIVE  nothing; out is as it was.
gjk_status gjk2_distance_until(const gjk2_collider *a, const gjk2_collider *b, const gjk2_effort *effort,
                               gjk2_cache *cache, gjk2_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
