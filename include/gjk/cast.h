// Where does a shape that moves without turning first touch another, and where does a ray meet a shape?
#ifndef GJK_CAST_H
#define GJK_CAST_H

#include "gjk/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How two shapes move, both in straight lines and in step. At fraction f, 0 <= f <= 1, each has covered f of its way.
typedef struct gjk_cast_path {
  const gjk_vec3 *to_a;  // position of A's pose at the end of its way; NULL: A does not move
  const gjk_vec3 *to_b;  // position of B's pose at the end of its way; NULL: B does not move
  gjk_q16 margin;        // the gap at which the shapes count as touching; 0: contact
} gjk_cast_path;

// Why a cast hits or misses. A pair (a[i], b[i]) names a point w of A - B at the start, as in gjk/certificate.h. The
// way t of B against A is a segment from the origin. It meets A - B where the shapes touch.
//
// Three pairs name the plane across n = (w1 - w0) x (w2 - w0). Fewer pairs name the plane across n = direction.
typedef enum gjk_cast_proof {
  GJK_CAST_PROOF_NONE = 0,  // curved shapes, or ways too long for SWEPT: there are no vertices to name
  GJK_CAST_PROOF_SPHERES,   // miss: the bounding spheres do not meet on the way
  GJK_CAST_PROOF_BESIDE,    // miss: n w < 0 for every w, with n = direction x t; no pairs. (1, 0, 0) stands for t = 0
  GJK_CAST_PROOF_SHORT,     // miss: n w < 0 and n w < n t for every w
  GJK_CAST_PROOF_INSIDE,    // hit at the start; no pairs
  GJK_CAST_PROOF_FACET,     // hit: n w <= n w0 for every w, n t < 0, and the way passes through what the pairs span
  GJK_CAST_PROOF_SWEPT      // with a radius or margin: does A come within it of B swept along its way? No pairs
} gjk_cast_proof;

// Why the answer of a cast is right; see gjk_cast_proof.
typedef struct gjk_cast_certificate {
  gjk_vec3 direction;   // of BESIDE, and with fewer than three pairs: from A to B, at most 2^30 LSB long
  uint16_t a[3], b[3];  // numbers of vertices, in pairs, as in gjk_certificate
  uint8_t count;        // pairs in use
  uint8_t proof;        // a gjk_cast_proof
} gjk_cast_certificate;

// Lengths Q16.16, points in the world frame, shapes at the fraction reported.
typedef struct gjk_cast_result {
  bool hit;            // somewhere on the way the gap is at most the margin
  bool inside;         // a hit at the start; fraction is 0, and rest_a and rest_b are the start
  gjk_q30 fraction;    // fraction of the way, Q2.30, rounded down: 0 to GJK_Q30_ONE
  gjk_vec3 point_a;    // where A is touched; not set when inside
  gjk_vec3 point_b;    // where B is touched, margin away from point_a; not set when inside
  gjk_unit3 normal;    // from A to B, Q2.30; zero if the shapes overlap at the start
  gjk_vec3 rest_a;     // positions of both poses at contact, in whole LSB; B's is rounded away from A. The gap there is
  gjk_vec3 rest_b;     // at least the margin, and with margin 0 the shapes share no inner point
  bool saturated;      // a coordinate of a point or of rest_b is beyond Q16.16, and set to the end of that range
  uint8_t iterations;  // support scans of both shapes
  gjk_cast_certificate certificate;  // why hit or miss is right
} gjk_cast_result;

// Moves A and B along their ways until they touch, or come as near as the margin.
//
// a, b    posed colliders at the start, read only.
// path    read only; margin at least 0 (GJK_ERROR_NEGATIVE). RANGE: a centre leaves int32 on its way. Also RANGE: both
//         move, and the way of one against the other is 2^32 LSB or longer along an axis.
// out     the caller's.
// Exact   points, segments, triangles, boxes, hulls and their forms with a convex radius:
//           without radius and margin   hit or miss always; fraction is the exact quotient, rounded down
//           with either                 hit or miss where |way| plus twice both core radii is below 16380 units.
//                                       Centres must be at most 16384 units apart at the start and halfway, and one
//                                       shape must have fewer than 32768 vertices. Otherwise the answer is right for a
//                                       margin within 2 LSB of the given one. No contact comes before fraction; the gap
//                                       there exceeds margin by at most 2 LSB
//         Cylinder, cone, ellipsoid, custom: as gjk_within decides for a distance within 2 LSB of the margin. The gap
//         at fraction is at most 4 LSB above the margin.
//         For all shapes, the length of one step of fraction adds to the gap if the way is longer than 2^30 LSB. So
//         does 2^-24 of a margin above 8000 units.
// Cost    a miss by the bounding spheres takes some 500 instructions on a Cortex-M3.
//           without radius and margin   only the ceiling of 250 iterations is proven. Searches among hulls of 8 to 64
//                                       points have found casts that take 24
//           with either, or curved      2 to 3 distances, at most 64, each started where the last one ended. With
//                                       curved shapes each takes at most GJK_ITERATIONS_MAX iterations
// After   van den Bergen 2004 and Snethen 2008, with exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was or meaningless:
//
// OK                                    a miss: hit, iterations, certificate. A hit: all, but no points if inside.
// ITERATION_LIMIT                       everything. hit is false, and no contact comes before fraction. So if fraction
//                                       is above 0, rest_a and rest_b are safe. Points and normal are those of the last
//                                       measurement. Only curved shapes are known to cause it.
// NULL, UNINITIALISED, NEGATIVE, RANGE  nothing; out is as it was.
gjk_status gjk_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out);

// Casts a ray, the segment from one point to another, against a shape, as gjk_cast does for a point B moving along it.
//
// point_b and rest_b are where the ray enters, rounded to the nearest LSB and away from A. normal is A's, outwards.
gjk_status gjk_cast_ray(const gjk_collider *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out);

// Proves a result of gjk_cast from its certificate: hit or miss, and the fraction of shapes without radius and margin.
//
// With a radius or margin, the check proves hit or miss and inside by decisions of its own. Without either, it proves
// every field but iterations of an answer as gjk_cast gives it.
//
// Statuses  UNPROVEN: the certificate does not hold, or does not prove the result. UNSUPPORTED: curved shapes; with a
//           radius or margin also ways and centres for which no decision is exact, as above. NULL, UNINITIALISED,
//           NEGATIVE, RANGE as in gjk_cast.
// Cost      visits every vertex of both shapes once or twice.
gjk_status gjk_check_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                          const gjk_cast_result *result);

#ifdef __cplusplus
}
#endif

#endif
