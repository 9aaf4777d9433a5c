// Which of many contact points to keep.
#ifndef GJK_SRC_REDUCE_H
#define GJK_SRC_REDUCE_H

#include "clip.h"

// Writes the indices of the most points to keep, 1 <= most <= GJK_CONTACTS_MAX, most < touches->count: the deepest -
// the first within an LSB of it and at most at limit, so that it lasts -, then, if most is 2, the one farthest from
// it; if 3 or more, those that make with it the triangle or quadrilateral of the largest area seen along normal; then
// the one that is farthest from all others, and so on. Among equals the first. Points less than 2^30 apart along each
// axis; one of them is at most at limit.
void gjk_reduce(const gjk_touches *touches, const gjk_unit3 *normal, unsigned most, gjk_q16 limit, uint8_t *keep);

#endif
