// The facet nearest to the origin for points, segments and boxes: A - B is then a zonotope, whose facets are spanned by
// pairs of half axes.
#ifndef GJK_SRC_ZONOTOPE_H
#define GJK_SRC_ZONOTOPE_H

#include "facet.h"

// Are both shapes spanned by half axes?
bool gjk_is_zonotope(const gjk_iteration *it);

// Finds the facet; it->direction is then its normal. False: all half axes are parallel, there is none.
// Pre: the cores intersect. facet: not found yet.
bool gjk_zonotope_facet(gjk_iteration *it, gjk_facet *facet);

#endif
