// The facet nearest to the origin for points, segments and boxes: A - B is then a zonotope, whose facets are spanned by
// pairs of half axes.
#ifndef GJK_SRC_BOX_SAT_H
#define GJK_SRC_BOX_SAT_H

#include "gjk_facet.h"

// Are both shapes spanned by half axes?
bool gjk_is_zonotope(const gjk_iteration *it);

typedef enum gjk_zonotope_answer {
  GJK_ZONOTOPE_FACET,  // found
  GJK_ZONOTOPE_APART,  // the cores are apart
  GJK_ZONOTOPE_FLAT    // all half axes lie in a plane: there is no facet
} gjk_zonotope_answer;

// Finds the facet, or that there is none. APART: it->direction, from A to B, is where to begin to prove it.
// Pre: a frame of shift >= 0; facet: not found yet.
gjk_zonotope_answer gjk_box_sat(gjk_iteration *it, gjk_facet *facet);

#endif
