// Where do two shapes touch? The contact manifold: points, distances and a normal for a solver.
#ifndef GJK_CONTACTS_H
#define GJK_CONTACTS_H

#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most contacts of one manifold.
#define GJK_CONTACTS_MAX 8

// Lengths Q16.16, points in the world frame; coordinates saturate at the ends of Q16.16.
typedef struct gjk_contact {
  gjk_vec3 point_a, point_b;  // on the surfaces, opposite each other along the normal
  gjk_q16 distance;           // from point_a to point_b along the normal; negative where the shapes overlap
  uint16_t id;  // unique within the manifold and the same from tick to tick while the features stay. The high
                // byte is the feature id of its point on A, the low byte that on B
} gjk_contact;

// feature_a and feature_b number the face, edge or corner where each shape meets the normal. Contact ids tell which:
//   face    of a box: 2 * axis, plus 1 on the minus side. Of a hull: its index. Of a triangle: 0, or 1 seen from the
//           other side. The top of a cylinder is 0, the base of a cylinder or cone 1
//   side    of a cylinder or cone: 2
//   edge    (lower vertex number + 256 * higher vertex number) modulo 2^16
//   corner  its vertex number
typedef struct gjk_manifold {
  gjk_unit3 normal;                       // from A to B, Q2.30
  uint8_t count;                          // number of contacts; 0: the shapes are farther apart than the margin
  uint16_t feature_a, feature_b;          // see above
  gjk_contact contact[GJK_CONTACTS_MAX];  // in an arbitrary order
} gjk_manifold;

// The contact manifold of two shapes that overlap or are at most margin apart.
//
// a, b              posed colliders, read only; may be the same object.
// margin            Q16.16, at least 0 (GJK_ERROR_NEGATIVE): the speculative margin. Points farther apart are left out.
// most              the most contacts, 1 to 8 (GJK_ERROR_RANGE); 4 are enough for a solver.
// cache, workspace  as in gjk_signed_distance, which is called first.
// out               the caller's.
//
// Which points:
// Faces   Faces of boxes, triangles and hulls, and flat ends of cylinders and cones (as octagons), overlap in a
//         polygon, seen along the normal. Its corners are the contacts. If a hull has a convex radius, a face counts
//         only if it is wider than about 6 sqrt(convex radius), both in LSB. Posing tilts narrower ones.
// Edges   A shape without a face within 20 degrees of the normal touches with an edge, a curved side along a line
//         within 20 degrees of perpendicular. Edges opposite each other all along, to 2 LSB, share two points. So do
//         curved sides if a point between them is within 1/2 LSB of both, and at most 1 beyond their ends. Other edges
//         meet where they cross.
// Others  All other shapes, such as hulls without faces, meet in the one pair of points of gjk_signed_distance. So do
//         shapes whose centres are more than 8192 units apart along an axis.
// Least   The pair of points of gjk_signed_distance is among the contacts whenever it is nearer than the others.
// most    If there are more contacts than most, one about as deep as the deepest is kept first. Next come those that
//         span at least 9/10 of the largest area with it, then those farthest from all others. At least one is within 4
//         LSB of the deepest. Ties go to the lowest ids.
//
// Ids     depend on the shapes and poses alone. Resting shapes keep them. If bodies tremble by 1 LSB and 1e-7 rad, at
//         most 1 id in 100 is new in a tick. This holds for faces that are congruent, flush, spun or shifted. For this,
//         points near each other along each axis count as one. Near means within 1/64 of the shortest edge, in |x| +
//         |y| + |z|, or within 8 LSB if that is more. It never exceeds 1/4 of that edge.
//           a point near a corner has the corner's id, whatever edges meet there
//           of points with one id the deepest stays
//           a crossing of face edges near a line between other points is left out, unless it is deeper
//         Of points that keep their id, 97 in 100 move by at most 4 LSB. Crossings of nearly parallel edges move by up
//         to 1/64 of the shortest edge. Posing rounds each vertex, so the normal turns by up to 5e-5 rad, and that of a
//         bar 1/10 unit thick by 1.5e-4 (test_contacts_jitter).
//
// Exact   The shared polygon is exact, apart from points left out for ids. In LSB:
//           points           within 4 of their shapes (tests allow 3), and within 2 of exactly opposite each other
//           distance         within 2 of the points' gap along the normal
//           least distance   within 2 of that of gjk_signed_distance; 6 where most leaves points out
//         A depth is rounded up, so the distance of the points of gjk_signed_distance is within 3 LSB and 2^-28 of
//         their gap along the normal. With a curved shape it is as exact as the depth.
// Cost    that of gjk_signed_distance, and 8,000 to 20,000 instructions for faces. Stack: `make sizes`.
//
// What is valid in out after each status; all else is as it was:
//
// OK        normal, count, features, the first count contacts.
// CAPACITY  the same. normal is that of the upper bound of the depth; a single point need not lie on the surfaces.
// ITERATION_LIMIT, NULL, UNINITIALISED, NEGATIVE, RANGE  nothing.
gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out);

#ifdef __cplusplus
}
#endif

#endif
