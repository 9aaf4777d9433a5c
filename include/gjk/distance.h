// How far apart are two shapes, and where?
#ifndef GJK_DISTANCE_H
#define GJK_DISTANCE_H

#include "gjk/cache.h"
#include "gjk/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// Lengths Q16.16, points in the world frame.
typedef struct gjk_distance_result {
  gjk_q16 distance;             // gap between the surfaces; 0 when intersecting, GJK_DISTANCE_MAX if the gap is larger
  gjk_q16 lower;                // proven lower bound of the gap, inclusive; equal to distance if the answer is exact
  gjk_q16 upper;                // proven upper bound of the gap, inclusive; equal to distance if the answer is exact
  gjk_vec3 point_a;             // nearest point of A; not set when intersecting
  gjk_vec3 point_b;             // nearest point of B; not set when intersecting
  gjk_unit3 normal;             // from A to B, Q2.30; not set when intersecting
  bool intersecting;            // the shapes share a point
  bool saturated;               // the gap or a coordinate of a point is beyond Q16.16, and set to the end of that range
  uint8_t iterations;           // support scans of both shapes
  gjk_certificate certificate;  // why the answer is right
} gjk_distance_result;

// The largest distance that is reported.
#define GJK_DISTANCE_MAX ((gjk_q16)2147483647)

// The distance between two convex shapes, with a nearest point on each.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Written after OK.
// out     the caller's.
// Exact   points, segments, triangles, boxes, hulls and their forms with a convex radius:
//           separated or not   always
//           distance           rounded to the nearest LSB, ties up. A gap below 1/2 LSB gives 0 with intersecting false
//           points             each within 1 LSB of its shape; their gap is within 2 LSB of distance
//           normal             within 2^-28
//         Ties: several pairs of points may be equally near, as between parallel edges or faces. The answer is then
//         that of a search of those features' vertices alone, from the lowest numbers on. Swapping the shapes keeps the
//         distance. Unique nearest points then move by at most 2 LSB, and the normal is opposite to within 4 LSB of
//         Q2.30. Cylinder, cone, ellipsoid: distance and points are within 2 LSB of the exact surface. More than 8192
//         units apart:
//           distance           within 2^-28 of its value, or 2^-27 for curved shapes
//           points             within 2^-27 of the distance; the gap along the normal is distance, to 2^-27
// Cost    at most GJK_ITERATIONS_OF(n, m) iterations, or GJK_ITERATIONS_MAX with a curved shape (gjk/format.h). Stack:
//         `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything, points and normal unless intersecting; in the certificate, only what its proof uses.
// ITERATION_LIMIT      everything, as in gjk_distance_until: 0 <= lower <= gap <= upper. lower above 0 proves that the
//                      shapes are apart. Only cylinder, cone, ellipsoid and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out);

// When gjk_distance_until stops.
typedef struct gjk_effort {
  uint8_t iterations;  // the most iterations; 0: no limit but that of gjk_distance
  gjk_q16 error;       // stop once upper - lower is at most this, Q16.16; 0: exact
} gjk_effort;

// As gjk_distance, but stops when the effort is spent, and reports what is proven by then:
//
// lower, upper      inclusive bounds of the gap. They are equal if the answer is exact, as in gjk_distance.
// distance          from point_a to point_b, to the nearest LSB; upper is the same, rounded up. More than 8192 units
//                   apart, it is upper.
// point_a, point_b  points of the shapes, as accurate as in gjk_distance, and distance apart to within 2 LSB. Not set
//                   when intersecting.
// normal            a direction from A to B.
// intersecting      true is proven. false proves nothing if lower is 0.
// certificate       its proof is GJK_PROOF_NONE unless the answer is exact.
//
// effort   read only; error at least 0 (GJK_ERROR_NEGATIVE).
// cache    out, the caller's; NULL = none. It is not read, so that the result does not depend on it. Written if the
//          answer is exact.
// Cost     an iteration costs about a third more than in gjk_distance, because it computes the bounds.
//
// OK                             everything, as above.
// ITERATION_LIMIT                the same: effort allows GJK_ITERATIONS_MAX iterations, which did not settle it.
// NULL, UNINITIALISED, NEGATIVE  nothing; out is as it was.
gjk_status gjk_distance_until(const gjk_collider *a, const gjk_collider *b, const gjk_effort *effort, gjk_cache *cache,
                              gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
