// The corners of the convex hull of a polygon's posed vertices, whatever their order.
//
// Where the vertices are in order (gjk2_collider) a corner's neighbours are its neighbours in the list. Elsewhere the
// next corner is the vertex that has no other on the right of the way to it, and of several in one line the farthest:
// one pass over the vertices, a step of gift wrapping (Jarvis 1973). So vertices in no order, repeated ones, ones in a
// line, and those that posing has moved inside or behind each other are all treated as the hull that they have.
#ifndef GJK2_SRC_HULL_H
#define GJK2_SRC_HULL_H

#include "gjk2_class.h"

// The corner farthest along d, of several the last one counterclockwise. Pre: a polygon; d != 0, |d| <= 3 2^29.
void gjk2_hull_corner(const gjk2_collider *c, gjk2_vec d, gjk2_support *out);

// The way to the corner that follows another counterclockwise, or precedes it. False: there is no other.
bool gjk2_hull_neighbour(const gjk2_collider *c, const gjk2_support *corner, bool following, gjk2_support *way);

#endif
