// The outward normal: a normal rounded so that moving B by the depth along it parts the shapes.
//
// A depth is a whole number of LSB, at least the exact depth. The move along the exact normal would part the shapes.
// The move that is reported has integer components and a normal in Q2.30, so both are rounded outwards:
//   1. Each component of depth normal is rounded away from 0, to LSB (gjk_outward_move).
//   2. If a bound on that rounding proves that the move is far enough, the normal stays.
//   3. Otherwise an exact test asks whether the move parts the shapes; if it does, the normal stays.
//   4. Otherwise each component of the normal grows by 2^-30 away from 0. Back to 1.
// The normal is within 9/2 2^-30 of the exact one. After 5 times no component is smaller than the exact one, so the
// move suffices.
#ifndef GJK_SRC_OUTWARD_H
#define GJK_SRC_OUTWARD_H

#include "../depth/gjk_facet.h"

// Step 1: depth normal / 2^30, each component rounded away from 0. Pre: 0 <= depth.
gjk_vec3 gjk_outward_move(gjk_q16 depth, const gjk_unit3 *normal);

// Once A - B has moved by -t, is its vertex w on or behind the plane through the origin across n? Exact.
//   w   in the frame of shift >= 0, so 2^shift times an integer; in LSB at most 2^30 in size
//   t   LSB, components at most 2^29 + 2^3 in size
bool gjk_outward_clears(const gjk_vec3 *w, int shift, const gjk_long3 *n, const gjk_vec3 *t);

// Steps 2 to 4: rounds the normal outwards for the depth. Overwrites the iteration, unless facet is given.
//   facet   of the cores, for shapes without convex radii whose cores intersect; otherwise NULL
//   exact   false: the depth is an upper bound, and there is no test to ask. The normal grows until step 2 stops it,
//           or 5 times
void gjk_outward_normal(gjk_iteration *it, const gjk_facet *facet, bool exact, gjk_q16 depth, gjk_unit3 *normal);

#endif
