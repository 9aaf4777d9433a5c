// Do parts enclose a solid? Decided exactly, from the triangles and the parts' points and planes alone.
//
// Three things are checked.
//   1. Each part is what it says: its points lie in all its facets' planes or behind them, its facets close
//      (gjk_hull_check), and its planes are those of its facets. So it is convex, and known by its planes.
//   2. Each triangle is covered. It is cut by the planes of the parts, as a polygon in its own plane, and of what
//      the parts leave no area may remain.
//   3. Each facet of each part is covered from outside, or the solid ends there. The facet is cut by the other parts and by
//      the triangles, and of each piece that no other part reaches beyond, a point just beyond it must be outside.
//
// Why that suffices. Suppose a point u of the solid is in no part. By 2 the surface is covered, so u is inside, and so is
// all that can be reached from u without meeting a part or the surface. Go straight from u towards a
// point inside some part, chosen so that the way meets no edge and no cut of 3. Where the way first meets a part, it
// enters that by a facet, and just before, beyond that facet, it is inside the solid and in no part. 3 says there is no such place.
#ifndef ENCLOSE_H
#define ENCLOSE_H

#include "part.h"

// What is not covered: polygons, their corners rounded. A few are enough for a repair.
enum { ENCLOSE_GAPS_MAX = 256, ENCLOSE_PROBLEM = 160 };

typedef struct enclose_gap {
  long double (*corner)[3];
  unsigned corners;
  long part;  // of whose facet it is; -1: of a triangle
} enclose_gap;

typedef struct enclose_report {
  bool enclosed;
  unsigned gaps;
  enclose_gap gap[ENCLOSE_GAPS_MAX];
  char problem[ENCLOSE_PROBLEM];  // what is wrong first
} enclose_report;

// Checks all, or until there are ENCLOSE_GAPS_MAX gaps. out: to be freed.
bool enclose_check(const solid *s, const part *p, size_t parts, enclose_report *out);

void enclose_free(enclose_report *report);

// Is a part inside the solid? True is proven. Triangles may go through it where the solid is on both their sides.
bool enclose_is_inside(const solid *s, const part *p);

#endif
