// From a polytope of triangles to the facets of a hull: coplanar triangles joined, points within edges left out.
#ifndef GJK_SRC_HULL_FACETS_H
#define GJK_SRC_HULL_FACETS_H

#include "gjk_hull_grow.h"

// The work of a hull that was built.
void gjk_hull_work_of_hull(const gjk_hull *hull, gjk_hull_work *out);

// The dimension of the points, and as many of them that span it. The first two are the first and the last point. The
// third one spans the largest triangle with them, by the sum of its normal's components. The fourth one is the farthest
// from that plane, and below it.
unsigned gjk_hull_span(const gjk_hull_work *w, uint16_t corner[4]);

// Marks the edges between coplanar triangles. Sets next of each extreme point to its number, of others to
// GJK_HULL_NO_POINT. Counts.
void gjk_hull_join(gjk_hull_work *w, gjk_hull *out);

// An edge of a triangle.
typedef struct gjk_hull_edge {
  uint32_t triangle;
  unsigned number;
} gjk_hull_edge;

// A walk over all facets, and over the corners of each. Start with triangle 0.
typedef struct gjk_hull_facet {
  uint32_t triangle;          // from here on facets are looked for
  gjk_hull_edge first, edge;  // of the facet's outline: the first one, and the next one
  bool done;
} gjk_hull_facet;

// Forgets which facets were visited.
void gjk_hull_clear_facets(gjk_hull_work *w);

// Moves on to a facet that was not visited. False: there is none. Pre: all corners of the last one were visited.
bool gjk_hull_next_facet(gjk_hull_work *w, gjk_hull_facet *facet);

// The next corner of the facet, counterclockwise. False: there is none.
bool gjk_hull_next_corner(gjk_hull_work *w, gjk_hull_facet *facet, uint16_t *vertex);

#endif
