// Where does a shape that moves without turning first touch another, and where does a ray meet a shape?
#ifndef GJK2_CAST_H
#define GJK2_CAST_H

#include "gjk2/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How two shapes move, both in straight lines and in step. At fraction f, 0 <= f <= 1, each has covered f of its way.
typedef struct gjk2_cast_path {
  const gjk2_vec *to_a;  // position of A's pose at the end of its way; NULL: A does not move
  const gjk2_vec *to_b;  // position of B's pose at the end of its way; NULL: B does not move
  gjk_q16 margin;        // the gap at which the shapes count as touching; 0: contact
} gjk2_cast_path;

// Why a cast hits or misses. A pair (a[i], b[i]) names a point w of A - B at the start, as in gjk2/certificate.h. The
// way t of B against A is a segment from the origin. It meets A - B where the shapes touch. radius: both radii and
// margin.
typedef enum gjk2_cast_proof {
  GJK2_CAST_PROOF_NONE = 0,  // curved shapes: there are no vertices to name
  GJK2_CAST_PROOF_SPHERES,   // miss: the bounding circles do not meet on the way
  GJK2_CAST_PROOF_BESIDE,    // miss: the line of the way passes A - B at more than radius; the pair is the nearest
  GJK2_CAST_PROOF_SHORT,     // miss: with n = direction, n . w + radius |n| < 0 and < n . t for every w
  GJK2_CAST_PROOF_INSIDE,    // hit at the start; no pairs
  GJK2_CAST_PROOF_FACET  // hit: with n = direction, the line across n on which the pair or pairs lie has no w beyond it
} gjk2_cast_proof;

// Why the answer of a cast is right; see gjk2_cast_proof.
typedef struct gjk2_cast_certificate {
  gjk2_vec direction;   // of SHORT and FACET: from A to B, at most 3 2^29 LSB long
  uint16_t a[3], b[3];  // numbers of vertices, in pairs, as in gjk2_certificate
  uint8_t count;        // pairs in use, at most 2
  uint8_t proof;        // a gjk2_cast_proof
} gjk2_cast_certificate;

// Lengths Q16.16, points in the world frame, shapes at the fraction reported.
typedef struct gjk2_cast_result {
  bool hit;            // somewhere on the way the gap is at most the margin
  bool inside;         // a hit at the start; fraction is 0, and rest_a and rest_b are the start
  gjk_q30 fraction;    // fraction of the way, Q2.30, rounded down: 0 to GJK_Q30_ONE
  gjk2_vec point_a;    // where A is touched; if the shapes share a point at the start, this and the next two are zero
  gjk2_vec point_b;    // where B is touched, margin away from point_a
  gjk2_unit normal;    // from A to B, Q2.30
  gjk2_vec rest_a;     // positions of both poses at contact, in whole LSB; B's is rounded away from A. The gap there is
  gjk2_vec rest_b;     // at least the margin, and with margin 0 the shapes share no inner point
  bool saturated;      // a coordinate of a point or of rest_b is beyond Q16.16, and set to the end of that range
  uint8_t iterations;  // support scans of both shapes
  gjk2_cast_certificate certificate;  // why hit or miss is right
} gjk2_cast_result;

// Moves A and B along their ways until they touch, or come as near as the margin.
//
// a, b    posed colliders at the start, read only.
// path    read only; margin at least 0 (GJK_ERROR_NEGATIVE). RANGE: a centre leaves int32 on its way. Also RANGE: both
//         move, and the way of one against the other is 2^32 LSB or longer along an axis.
// out     the caller's.
// Exact   points, segments, triangles, boxes, polygons and their forms with a convex radius: hit or miss always. Only if
//         margin and both bounding radii exceed 16384 units in all, it is as gjk2_within decides.
//           without radius and margin   fraction is the exact quotient, rounded down. rest_a is the exact place to the
//                                       nearest LSB. rest_b less rest_a is exact except for rounding along the normal.
//                                       A coordinate along which the normal is 0 is rounded to the nearest LSB
//           with either                 no contact comes before fraction; the gap there is at most 2 LSB above margin.
//                                       rest_a and rest_b are the places at fraction, rounded likewise
//         Ellipse, custom: as gjk2_within decides for a distance within 2 LSB of the margin. The gap at fraction is at
//         most 4 LSB above the margin. If both are such shapes, these are 4 and 6 LSB.
//         For all shapes, the length of one step of fraction adds to the gap if the way is longer than 2^30 LSB. Points
//         and normal are within 2 LSB and 2^-28 of what is touched at fraction.
// Cost    polygons of n and m vertices without radius and margin: at most 6 + 2 (n + m) support scans of both.
//         Otherwise one distance in each of a few steps, mostly one to three.
// After   van den Bergen 2004 and Snethen 2008, with exact signs instead of tolerances.
//
// OK               a miss: hit, iterations, certificate. A hit: everything.
// ITERATION_LIMIT  nothing: GJK_ITERATIONS_MAX did not settle a distance. Only ellipse and custom can cause it.
// Others           nothing; out is as it was.
gjk_status gjk2_cast(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path, gjk2_cast_result *out);

// Casts a ray, the segment from one point to another, against a shape, as gjk2_cast does for a point B moving along it.
//
// point_b and rest_b are where the ray enters, rounded to the nearest LSB and away from A. normal is A's, outwards.
gjk_status gjk2_cast_ray(const gjk2_collider *a, const gjk2_vec *from, const gjk2_vec *to, gjk2_cast_result *out);

// Proves a result of gjk2_cast from its certificate: hit or miss, and the fraction of shapes without radius and margin.
//
// Points, normal and rest positions are proven to follow from the certificate. If the bounding circles do not meet on
// the way, the certificate is not checked.
//
// Statuses  UNPROVEN: the certificate does not hold, or does not prove the result. UNSUPPORTED: a curved shape. With a
//           radius or margin also: the way is 2^30 LSB or longer along an axis, or centres are as far apart. If these
//           and both bounding radii exceed 16384 units in all, a right result may be UNPROVEN.
gjk_status gjk2_check_cast(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                           const gjk2_cast_result *result);

#ifdef __cplusplus
}
#endif

#endif
