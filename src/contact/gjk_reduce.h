// Keeps the contact candidates that serve a solver best.
#ifndef GJK_SRC_REDUCE_H
#define GJK_SRC_REDUCE_H

#include "gjk_clip.h"

// Writes the indices of the `most` candidates to keep: gjk_reduce.c says which.
// Pre: 1 <= most <= GJK_CONTACTS_MAX, most < candidates->count; points are less than 2^30 apart along each axis.
void gjk_reduce(const gjk_candidates *candidates, const gjk_unit3 *normal, unsigned most, uint8_t *keep);

#endif
