// The exact depth of an overlap: by trying every direction that a facet of A - B can have, no certificate; and what a
// certificate proves of an answer about shapes of any size.
#ifndef EXACT_DEPTH_H
#define EXACT_DEPTH_H

#include "exact.h"
#include "plane.h"

// Most vertices of a shape that all directions are tried for; and most directions, a second's work.
#define EXACT_DEPTH_VERTICES 64
#define EXACT_DEPTH_DIRECTIONS 1000000

// How many directions exact_depth tries.
unsigned long exact_depth_work(const gjk_collider *a, const gjk_collider *b);

// Do the cores share a point? Then out is the plane of A - B's facet that is nearest to the origin; of a flat A - B one
// through the origin. Neither the shapes' roundings nor the library have a part in it.
// Pre: both have vertices, at most EXACT_DEPTH_VERTICES; not far apart.
bool exact_depth(const gjk_collider *a, const gjk_collider *b, exact_plane *out);

// What gjk_penetration has to say of a pair.
typedef struct exact_overlap {
  bool intersecting;
  bool touching;  // depth 0
  int64_t depth;  // rounded up
} exact_overlap;

// Vertices of A - B that exact_brute is worth here.
#define EXACT_OVERLAP_BRUTE 16

// From exact_depth, or when only the roundings overlap, from exact_brute. False: too many vertices for that.
bool exact_overlap_find(const gjk_collider *a, const gjk_collider *b, exact_overlap *out);

// Does the answer to gjk_penetration(a, b), after GJK_OK, follow from its certificate? As far as one proves it of any
// polytopes: intersecting or not, no vertex beyond the plane, depth its height rounded up. That no other plane is nearer
// is exact_depth's part.
bool exact_check_depth(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                       size_t n);

// The same, and: points within 1 LSB of their
// shapes, their difference within 2 LSB of the exact depth along the exact normal, the normal within 2^-28, and that the
// move parts the shapes.
bool exact_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result,
                             char *why, size_t n);

// Moved by depth along normal, each component of the product rounded away from 0, is B apart from A or touching it?
// That is asked of the plane across the certificate's feature first, then of the shapes as moved.
bool exact_check_move(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result, char *why,
                      size_t n);

// The move: depth along the normal, rounded away from 0.
exact_point exact_move(const gjk_penetration_result *result);

#endif
