// Where do two shapes of the plane touch? The contact manifold: points, distances and a normal for a solver.
#ifndef GJK2_CONTACTS_H
#define GJK2_CONTACTS_H

#include "gjk2/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most contacts of one manifold.
#define GJK2_CONTACTS_MAX 2

// Lengths Q16.16, points in the world frame; coordinates saturate at the ends of Q16.16.
typedef struct gjk2_contact {
  gjk2_vec point_a, point_b;  // on the surfaces, opposite each other along the normal
  gjk_q16 distance;           // from point_a to point_b along the normal; negative where the shapes overlap
  uint16_t id;  // unique within the manifold and the same from tick to tick while the features stay. The high
                // byte is the feature id of its point on A, the low byte that on B
} gjk2_contact;

// feature_a and feature_b number the edge or corner where each shape meets the normal. Contact ids tell which:
//   edge    (lower vertex number + 256 * higher vertex number) modulo 2^16
//   corner  its vertex number
typedef struct gjk2_manifold {
  gjk2_unit normal;                         // from A to B, Q2.30
  uint8_t count;                            // number of contacts; 0: the shapes are farther apart than the margin
  uint16_t feature_a, feature_b;            // see above
  gjk2_contact contact[GJK2_CONTACTS_MAX];  // in an arbitrary order
} gjk2_manifold;

// The contact manifold of two shapes that overlap or are at most margin apart.
//
// a, b    posed colliders, read only; may be the same object.
// margin  Q16.16, at least 0 (GJK_ERROR_NEGATIVE): the speculative margin. Points farther apart are left out.
// most    the most contacts, 1 or 2 (GJK_ERROR_RANGE).
// cache   as in gjk2_signed_distance, which is called first.
// out     the caller's.
//
// Which points:
// Edges   An edge of a box, segment, triangle or polygon counts if it is within 20 degrees of perpendicular to the
//         normal. The contacts are the ends of the stretch along which two such edges lie opposite each other.
// Others  All other shapes meet in the one pair of points of gjk2_signed_distance. So do shapes whose centres are more
//         than 8192 units apart along an axis.
// Least   The pair of points of gjk2_signed_distance is among the contacts whenever it is nearer than the others.
// most    If most is 1, the deeper contact is kept; ties go to the lower id.
//
// Ids     depend on the shapes and poses alone. Resting shapes keep them: a point near a corner has the corner's id.
//         Near means within 1/64 of the shorter edge or 8 LSB, whichever is more, but at most 1/4 of that edge.
//
// Exact   In LSB:
//           points           within 4 of their shapes, and within 2 of exactly opposite each other
//           distance         within 2 of the points' gap along the normal
//           least distance   within 2 of that of gjk2_signed_distance
//         A depth is rounded up, so the distance of the points of gjk2_signed_distance is within 3 LSB and 2^-28 of
//         their gap along the normal. With a curved shape it is as exact as the depth.
// Cost    that of gjk2_signed_distance, and 500 to 1,000 instructions for edges. Stack: `make sizes`.
//
// What is valid in out after each status; all else is as it was:
//
// OK        normal, count, features, the first count contacts.
// CAPACITY  the same. normal is that of the upper bound of the depth; a single point need not lie on the surfaces.
// ITERATION_LIMIT, NULL, UNINITIALISED, NEGATIVE, RANGE  nothing.
gjk_status gjk2_contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, unsigned most,
                         gjk2_cache *cache, gjk2_manifold *out);

#ifdef __cplusplus
}
#endif

#endif
