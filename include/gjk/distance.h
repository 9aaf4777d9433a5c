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
  gjk_q16 distance;    // gap between the surfaces, 0 when intersecting; GJK_DISTANCE_MAX if it is larger
  gjk_q16 lower;       // proven bounds of the gap, both included; equal to distance where the answer is exact
  gjk_q16 upper;       // the other bound
  gjk_vec3 point_a;    // nearest point of A; not set when intersecting
  gjk_vec3 point_b;    // nearest point of B; not set when intersecting
  gjk_unit3 normal;    // from A to B, Q2.30; not set when intersecting
  bool intersecting;   // the shapes share a point
  bool saturated;      // the gap or a coordinate of a point is beyond Q16.16, and the field has the end of that range
  uint8_t iterations;  // support scans of both shapes
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
//           distance           rounded to the nearest LSB, a tie up; a gap below 1/2 LSB is 0, and not intersecting
//           points             each within 1 LSB of its shape, their gap within 2 LSB of the distance
//           normal             within 2^-28
//         Ties: where several pairs of points are equally near, as between parallel edges or faces, they are those that a
//         search finds among the vertices of these alone, from the ones with the lowest numbers on.
//         Exchanged, A and B are as far apart; where the nearest points are unique, within 2 LSB of these, and the normal
//         within 4 units of 2^-30 of the opposite one.
//         Cylinder, cone, ellipsoid: distance and points within 2 LSB of the exact surface.
//         More than 8192 units apart:
//           distance           within 2^-28 of itself, of curved shapes 2^-27
//           points             within 2^-27 of the distance; along the normal the shapes are distance apart, to 2^-27
// Cost    at most GJK_ITERATIONS_OF(n, m) iterations, with a curved shape GJK_ITERATIONS_MAX (gjk/format.h). Stack:
//         `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything, points and normal unless intersecting; of the certificate what its proof uses.
// ITERATION_LIMIT      everything, as gjk_distance_until gives it: 0 <= lower <= gap <= upper. lower above 0 proves
//                      that the shapes are apart. Only cylinder, cone, ellipsoid and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out);

// When gjk_distance_until stops.
typedef struct gjk_effort {
  uint8_t iterations;  // the most iterations; 0: no limit but that of gjk_distance
  gjk_q16 error;       // stops once upper - lower is at most this, Q16.16; 0: exact
} gjk_effort;

// As gjk_distance, but stops when the effort is spent, with what is proven by then:
//
// lower, upper      the gap lies between them, both included. They are equal when the answer is exact, as of
//                   gjk_distance.
// distance          of the two points below, to the nearest LSB; upper is the same rounded up. More than 8192 units
//                   apart: upper.
// point_a, point_b  points of the shapes, as accurate as those of gjk_distance, and distance apart to within 2 LSB. Not
//                   set when intersecting.
// normal            a direction from A to B.
// intersecting      true: proven. false proves nothing when lower is 0.
// certificate       its proof is GJK_PROOF_NONE unless the answer is exact.
//
// effort   read only; error at least 0 (GJK_ERROR_NEGATIVE).
// cache    out, the caller's; NULL = none. Not read: what is proven by then would depend on it. Written when the answer
//          is exact.
// Cost     each iteration about a third more than one of gjk_distance, for the bounds.
//
// OK                             everything, as above.
// ITERATION_LIMIT                the same. The effort sets no limit below GJK_ITERATIONS_MAX, and so many iterations
//                                have not settled it.
// NULL, UNINITIALISED, NEGATIVE  nothing; out is as it was.
gjk_status gjk_distance_until(const gjk_collider *a, const gjk_collider *b, const gjk_effort *effort, gjk_cache *cache,
                              gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
