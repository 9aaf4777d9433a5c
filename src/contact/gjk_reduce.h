// Which of many contact points to keep.
#ifndef GJK_SRC_REDUCE_H
#define GJK_SRC_REDUCE_H

#include "gjk_clip.h"

// Writes the indices of the most points to keep, 1 <= most <= GJK_CONTACTS_MAX, most < candidates->count.
//   1. One whose distance is the least to within 4 LSB and a 512th of how far the points reach.
//   2. If most is 2, the one farthest from it; if 3 or more, those that make with it the triangle or quadrilateral of the
//      largest area seen along normal, or at least 9/10 of it; then one that is as far from all others as the farthest, and
//      so on.
//   3. If none of these is within 4 LSB of the least, they are chosen again, beginning with one that is.
// Of equals, and of what rounding may make equal, the first by its id. Points less than 2^30 apart along each axis.
void gjk_reduce(const gjk_candidates *candidates, const gjk_unit3 *normal, unsigned most, uint8_t *keep);

#endif
