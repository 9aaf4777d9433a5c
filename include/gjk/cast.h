// Where does a shape that moves without turning first touch another, and where does a ray meet a shape?
#ifndef GJK_CAST_H
#define GJK_CAST_H

#include "gjk/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How two shapes move, both in a straight line and in step: at fraction f each has done f of its way, 0 <= f <= 1.
typedef struct gjk_cast_path {
  const gjk_vec3 *to_a;  // the position of A's pose at the end of its way; NULL: A stands
  const gjk_vec3 *to_b;  // of B's; NULL: B stands
  gjk_q16 margin;        // the gap at which the shapes count as touching; 0: contact
} gjk_cast_path;

// Why a cast hits or misses. A pair (a[i], b[i]) names a point w of A - B at the start, as in gjk/certificate.h. The way t
// of B against A is a segment from the origin; it meets A - B where the shapes touch.
//
// Three pairs name the plane across n = (w1 - w0) x (w2 - w0), fewer the plane across n = direction.
typedef enum gjk_cast_proof {
  GJK_CAST_PROOF_NONE = 0,  // curved shapes, and ways that are too long for SWEPT: no vertices to name
  GJK_CAST_PROOF_SPHERES,   // miss: the bounding spheres do not meet on the way
  GJK_CAST_PROOF_BESIDE,    // miss: n w < 0 for every w, with n = direction x t; no pairs. (1, 0, 0) stands for t = 0
  GJK_CAST_PROOF_SHORT,     // miss: n w < 0 and n w < n t for every w
  GJK_CAST_PROOF_INSIDE,    // hit at the start; no pairs
  GJK_CAST_PROOF_FACET,     // hit: n w <= n w0 for every w, n t < 0, and the way passes through what the pairs span
  GJK_CAST_PROOF_SWEPT      // with a radius or margin: A and all places of B come within it, or don't; no pairs
} gjk_cast_proof;

// Why the answer of a cast is right; see gjk_cast_proof.
typedef struct gjk_cast_certificate {
  gjk_vec3 direction;   // of BESIDE, and where there are fewer than three pairs: from A to B, at most 2^30 LSB long
  uint16_t a[3], b[3];  // numbers of vertices, in pairs, as of gjk_certificate
  uint8_t count;        // pairs in use
  uint8_t proof;        // a gjk_cast_proof
} gjk_cast_certificate;

// Lengths Q16.16, points in the world frame, shapes at the fraction reported.
typedef struct gjk_cast_result {
  bool hit;            // somewhere on the way the gap is at most the margin
  bool inside;         // and it is at the start: then fraction is 0, and rest_a and rest_b are the start
  gjk_q30 fraction;    // of the way, Q2.30, rounded down: 0 to GJK_Q30_ONE
  gjk_vec3 point_a;    // where A is touched; not set when inside
  gjk_vec3 point_b;    // where B is touched, margin away from point_a; not set when inside
  gjk_unit3 normal;    // from A to B, Q2.30; zero where the shapes overlap at the start
  gjk_vec3 rest_a;     // positions of both poses at contact, in whole LSB. B's is rounded away from A: with both there
  gjk_vec3 rest_b;     // the gap is at least the margin, and with margin 0 the shapes share no inner point
  bool saturated;      // a coordinate of a point or of rest_b is beyond Q16.16, and has the end of that range
  uint8_t iterations;  // support scans of both shapes
  gjk_cast_certificate certificate;  // why hit or miss is right
} gjk_cast_result;

// Moves A and B along their ways until they touch, or come as near as the margin.
//
// a, b    posed colliders at the start, read only.
// path    read only; margin at least 0 (GJK_ERROR_NEGATIVE). RANGE: a centre leaves int32 on its way. Or the way of
//         one against the other is 2^32 LSB or longer along an axis; that takes two that move.
// out     the caller's.
// Exact   points, segments, triangles, boxes, hulls and their forms with a convex radius: hit or miss.
//           without radius and margin   always; the fraction is the exact quotient, rounded down
//           with one                    where way and shapes together are shorter than 16380 units (|way| plus twice both
//                                       core radii), centres are at most 16384 units apart at the start and at the middle of
//                                       the way, and one has less than 32768 vertices; else at a gap within 2 LSB of the
//                                       margin. No contact before fraction; the gap there is at most 2 LSB above the margin
//         Cylinder, cone, ellipsoid, custom: as gjk_within decides at a gap within 2 LSB of the margin; the gap at
//         fraction at most 4 LSB above it.
//         Where the way is longer than 2^30 LSB, a step of the fraction is more than an LSB; that comes on top.
//         Margins of more than 8000 units: the gap at fraction may be larger by 2^-24 of the margin.
// Cost    a miss by the bounding spheres some 500 instructions on a Cortex-M3.
//           without radius and margin   no bound of the iterations is proven but the ceiling of 250; searches among hulls of
//                                       8 to 64 points have found casts that take 24
//           with one, or curved         2 to 3 distances, each from where the last one ended, at most 64; of curved shapes
//                                       each takes at most GJK_ITERATIONS_MAX iterations
// After   van den Bergen 2004 and Snethen 2008, with exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was or of no meaning:
//
// OK                                    a miss: hit, iterations, certificate. A hit: everything; inside: all but the points.
// ITERATION_LIMIT                       everything: hit is false, no contact is before fraction, so where it is above 0 the
//                                       places of rest are safe; points and normal are those of the last measurement. Only
//                                       curved shapes are known to cause it.
// NULL, UNINITIALISED, NEGATIVE, RANGE  nothing; out is as it was.
gjk_status gjk_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out);

// The segment from one point to another against a shape: as gjk_cast of a point that moves so, as B, against A.
//
// point_b and rest_b are where the ray enters, rounded to the nearest LSB and away from A; normal is A's, outwards.
gjk_status gjk_cast_ray(const gjk_collider *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out);

// Proves a result of gjk_cast from its certificate: hit or miss, and the fraction of shapes without radius and margin.
//
// With a radius or margin it proves hit or miss, and whether it is at the start, by decisions of its own. Without, it
// proves every field but iterations of an answer as gjk_cast gives it.
//
// Statuses  UNPROVEN: the certificate does not hold, or does not prove the result. UNSUPPORTED: curved shapes; with a
//           radius or margin, ways and centres for which no decision is exact, as above. NULL, UNINITIALISED, NEGATIVE,
//           RANGE as of gjk_cast.
// Cost      visits every vertex of both shapes once or twice.
gjk_status gjk_check_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                          const gjk_cast_result *result);

#ifdef __cplusplus
}
#endif

#endif
