// How far apart are two shapes, and where?
#ifndef GJK_DISTANCE_H
#define GJK_DISTANCE_H

#include "gjk/cache.h"
#include "gjk/certificate.h"

#ifdef __cplusplus
extern "C" {
#endif

// Lengths Q16.16, world frame.
typedef struct gjk_distance_result {
  gjk_q16 distance;  // gap between the surfaces, 0 when intersecting; GJK_DISTANCE_MAX when saturated
  gjk_q16 lower;     // proven bounds of the gap, both included; equal to distance where the answer is exact
  gjk_q16 upper;
  gjk_vec3 point_a;    // nearest point of A; not set when intersecting
  gjk_vec3 point_b;    // nearest point of B; not set when intersecting
  gjk_unit3 normal;    // from A to B, Q2.30; not set when intersecting
  bool intersecting;   // the shapes share a point
  bool saturated;      // the gap, or a coordinate of a point, is beyond Q16.16 and was cut off there
  uint8_t iterations;  // iterations used: support scans of both shapes
  gjk_certificate certificate;
} gjk_distance_result;

#define GJK_DISTANCE_MAX ((gjk_q16)2147483647)

// Distance between two convex shapes, with a nearest point on each.
//
// a, b    posed colliders, read only; may be the same object.
// cache   in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only. Kept after OK.
// Exact   points, segments, triangles, boxes, hulls and their rounded forms: separated or not always; distance
//         correctly rounded (a tie goes up); each witness point within 1 LSB of its shape, their gap within
//         2 LSB of the distance; normal within 2^-28. Cylinder, cone, ellipsoid: within 2 LSB of the exact surface.
//         More than 8192 units apart: distance within 2^-28 of itself, of curved shapes within 2^-27; points to 2^-27 of the
//         distance, and the shapes are that far apart, to 2^-27, along the normal.
//         A gap above 0 but below half an LSB is reported as distance 0, and not as intersecting.
// Cost    at most GJK_ITERATIONS_OF(n, m) iterations, see gjk/format.h; stack: `make sizes`.
// After   Gilbert, Johnson, Keerthi 1988; exact signs instead of tolerances.
//
// What is valid in out after each status; after an error all else is as it was:
//
// OK                   everything, points and normal unless intersecting; of the certificate what its proof uses.
// ITERATION_LIMIT      everything, as gjk_distance_until gives it: 0 <= lower <= gap <= upper; apart is proven if lower is above
//                      0. Of cylinder, cone, ellipsoid and custom alone.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out);

// How much of the work gjk_distance_until may leave undone.
typedef struct gjk_effort {
  uint8_t iterations;  // iterations at most; 0: no limit but that of gjk_distance
  gjk_q16 error;       // stops once the gap is known to within this; 0: exactly
} gjk_effort;

// As gjk_distance, but stops when the effort is spent, with what is proven by then:
//
// lower, upper      the gap lies between them, both included; equal when the answer is exact, as gjk_distance gives it.
// distance          of the two points below, to the nearest LSB; upper is the same rounded up. More than 8192 units
//                   apart: upper.
// point_a, point_b  points of the shapes as accurate as those of gjk_distance, distance apart to within 2 LSB, unless
//                   intersecting.
// normal            a direction from A to B; the certificate's proof is GJK_PROOF_NONE, unless the answer is exact.
// intersecting      that they intersect is proven; false says nothing when lower is 0.
//
// effort   read only; error not negative (GJK_ERROR_NEGATIVE).
// cache    out, the caller's; NULL = none. Not read, as what is proven by then would depend on it; kept for other queries
//          when the answer is exact.
// Cost     each round about a third more than one of gjk_distance, for the bounds.
//
// OK, ITERATION_LIMIT            everything, as above; points and normal unless intersecting. ITERATION_LIMIT: the effort
//                                set no limit below GJK_ITERATIONS_MAX, and so many have not settled it.
// NULL, UNINITIALISED, NEGATIVE  nothing; out is as it was.
gjk_status gjk_distance_until(const gjk_collider *a, const gjk_collider *b, const gjk_effort *effort, gjk_cache *cache,
                              gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
