// SAT of boxes: finds the facet of A - B nearest to the origin, for points, segments and boxes.
#ifndef GJK_SRC_BOX_SAT_H
#define GJK_SRC_BOX_SAT_H

#include "gjk_facet.h"

// Are both shapes boxes, segments or points, which are given by half axes?
bool gjk_is_box_pair(const gjk_iteration *it);

typedef enum gjk_box_sat_answer {
  GJK_BOX_SAT_FACET,  // found: the cores overlap
  GJK_BOX_SAT_APART,  // the cores are apart
  GJK_BOX_SAT_FLAT    // open: all half axes lie in a plane, A - B has no facet
} gjk_box_sat_answer;

// Finds the facet, or that there is none. APART: it->direction, from A to B, separates them up to its rounding; a
// search that starts there proves it. Pre: gjk_is_box_pair, it->shift >= 0, no facet is found yet.
// *number: a guess of the number of the nearest facet's plane, where a right guess saves time. FACET sets it to that
// number. *points: must the facet's corners hold the origin's projection? If not, and a face of a box is nearest, they
// are any corners in its plane. Otherwise *points becomes true.
gjk_box_sat_answer gjk_box_sat(gjk_iteration *it, unsigned *number, bool *points, gjk_facet *facet);

#endif
