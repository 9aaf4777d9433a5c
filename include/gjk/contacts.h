// Where do two shapes touch? The contact manifold: points, distances and a normal for a solver.
#ifndef GJK_CONTACTS_H
#define GJK_CONTACTS_H

#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// Most contacts of one manifold.
#define GJK_CONTACTS_MAX 8

// Lengths Q16.16, points in the world frame; coordinates saturate at the ends of Q16.16.
typedef struct gjk_contact {
  gjk_vec3 point_a, point_b;  // on the surfaces, one straight across the normal from the other
  gjk_q16 distance;           // from point_a to point_b along the normal; negative where the shapes overlap
  uint16_t id;  // of this contact alone, and the same from tick to tick while the features stay: the feature
                // id of its point on A in the high byte, on B in the low one
} gjk_contact;

// feature_a and feature_b number the face, edge or corner with which each shape meets the normal; the ids tell which of
// the three it is:
//   face    of a box 2 axis + (1 on the minus side); of a hull its index; of a triangle 0, or 1 seen from the other
//           side; the top of a cylinder 0, the base of a cylinder or cone 1
//   side    of a cylinder or cone 2
//   edge    (lower vertex number + 256 higher vertex number) modulo 2^16
//   corner  its vertex number
typedef struct gjk_manifold {
  gjk_unit3 normal;                       // from A to B, Q2.30
  uint8_t count;                          // of contacts; 0: the shapes are farther apart than the margin
  uint16_t feature_a, feature_b;          // the feature of each shape, see above
  gjk_contact contact[GJK_CONTACTS_MAX];  // in no order that matters
} gjk_manifold;

// The contact manifold of two shapes that overlap or are at most margin apart.
//
// a, b              posed colliders, read only; may be the same object.
// margin            Q16.16, at least 0 (GJK_ERROR_NEGATIVE); points farther apart are left out.
// most              the most contacts, 1 to 8 (GJK_ERROR_RANGE); 4 are enough for a solver.
// cache, workspace  as of gjk_signed_distance, which is asked first.
// out               the caller's.
//
// Which points:
// Faces   Boxes, triangles, hulls with faces and the flat ends of cylinders and cones (as octagons) share a polygon,
//         seen along the normal. Its corners are the contacts. A face of a hull with a convex radius counts only if it
//         is wider than about 6 sqrt(convex radius), both in LSB, since posing turns a narrower one.
// Edges   A shape may have no face within 20 degrees of the normal. It meets with its edge then, or with the line of
//         its curved side, if that is level within 20 degrees. Two edges share two points where they lie across from
//         each other all along: to 2 LSB, curved sides to where a point between them is within 1/2 LSB of both. Other
//         edges meet where they cross.
// Others  Everything else, such as a hull without faces, meets in the one pair of points of gjk_signed_distance. So do
//         shapes whose centres are more than 8192 units apart along an axis.
// Least   The pair of points of gjk_signed_distance is among the contacts wherever it is nearer than the others.
// most    If there are more contacts, it keeps one about as deep as the deepest, then those that span at least 9/10 of the
//         largest area with it, then those farthest from all others. At least one is within 4 LSB of the deepest. Ties go
//         to the lowest ids.
//
// Ids     depend on the shapes and poses alone. Shapes that rest keep them: of bodies that tremble by 1 LSB and 1e-7
//         rad, congruent, flush, spun or moved aside, at most 1 in 100 is new from one tick to the next. For that,
//         points that are near count as one, along each axis: within 1/64 of the shortest edge, measured as
//         |x| + |y| + |z|, or 8 LSB, but at most 1/4 of that edge.
//           a point near a corner has the corner's id, whatever edges meet there
//           of points with one id the deepest stays
//           a crossing of faces' edges near a line between other points is left out, unless it is deeper
//         97 of 100 points that keep their id move by at most 4 LSB then. Crossings of nearly parallel edges move farther,
//         up to 1/64 of the shortest edge. The normal turns by up to 5e-5 rad, that of a bar 1/10 unit thick by 1.5e-4,
//         since posing rounds each vertex (test_contacts_jitter).
//
// Exact   The shared polygon is exact but for what ids leave out. In LSB:
//           points           within 4 of their shapes (tests hold 3), and within 2 of straight across from each other
//           distance         within 2 of the points' gap along the normal
//           least distance   within 2 of that of gjk_signed_distance; 6 where most leaves points out
//         The distance of the points of gjk_signed_distance is within 3 LSB and 2^-28 of their gap along the normal,
//         since a depth is rounded up; with a curved shape it is as exact as the depth.
// Cost    of gjk_signed_distance, and 8,000 to 20,000 instructions for faces; stack: `make sizes`.
//
// What is valid in out after each status; all else is as it was:
//
// OK        normal, count, features, the first count contacts.
// CAPACITY  the same. The normal is that of the upper bound of the depth; a single point need not lie on the surfaces.
// ITERATION_LIMIT, NULL, UNINITIALISED, NEGATIVE, RANGE  nothing.
gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out);

#ifdef __cplusplus
}
#endif

#endif
