// The exact depth of an overlap, in two ways.
//
// exact_depth     tries every direction that a facet of A - B can have, and reads no certificate.
// exact_check_*   judge an answer by its certificate, about polytopes of any number of vertices.
#ifndef EXACT_DEPTH_H
#define EXACT_DEPTH_H

#include "exact.h"
#include "plane.h"

// exact_depth is for shapes of at most so many vertices, and pairs of at most so many directions, which take a second.
#define EXACT_DEPTH_VERTICES 64
#define EXACT_DEPTH_DIRECTIONS 1000000

// How many directions exact_depth tries.
unsigned long exact_depth_work(const gjk_collider *a, const gjk_collider *b);

// Do the cores share a point? If so, out is the plane of the facet of A - B that is nearest to the origin; if A - B is
// flat, a plane through the origin. Convex radii are left out, and no code of the library is used. Pre: each shape has
// 1 to EXACT_DEPTH_VERTICES vertices; not exact_is_far.
bool exact_depth(const gjk_collider *a, const gjk_collider *b, exact_plane *out);

// What gjk_penetration has to say of a pair.
typedef struct exact_overlap {
  bool intersecting;
  bool touching;  // depth 0
  int64_t depth;  // rounded up
} exact_overlap;

// exact_overlap_find uses exact_brute for pairs of at most so many vertices of A - B.
#define EXACT_OVERLAP_BRUTE 16

// Finds it by exact_depth, or if the cores are apart, by exact_brute. Returns false if there are too many vertices for
// that.
bool exact_overlap_find(const gjk_collider *a, const gjk_collider *b, exact_overlap *out);

// Does the answer to gjk_penetration(a, b) after GJK_OK follow from its certificate? Checked: intersecting or not; no
// vertex lies beyond the certificate's plane; depth is the height of the plane, rounded up. That no other plane is
// nearer does not follow from a certificate: exact_depth tells it.
bool exact_check_depth(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                       size_t n);

// exact_check_depth, and: the points lie within 1 LSB of their shapes; their difference is within 2 LSB of the exact
// depth along the exact normal; the normal is within 2^-28; and exact_check_move.
bool exact_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result,
                             char *why, size_t n);

// Does B, moved by exact_move, no longer overlap A? Asked first of the plane across the certificate's feature; if that
// does not tell, of the moved shapes.
bool exact_check_move(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                      size_t n);

// The move of B that parts the shapes: depth times normal, each component rounded away from 0.
exact_point exact_move(const gjk_penetration_result *result);

#endif
