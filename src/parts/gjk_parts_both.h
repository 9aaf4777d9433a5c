// What queries of two bodies of many parts have in common.
#ifndef GJK_SRC_PARTS_BOTH_H
#define GJK_SRC_PARTS_BOTH_H

#include "gjk_parts_class.h"

// Checks both bodies, and sets their frames: that of A, then that of B.
gjk_status gjk_parts_both_open(gjk_parts_frame frame[2], const gjk_parts *a, const gjk_parts *b);

// Makes a part of B a collider, and starts its region in A's frame.
gjk_status gjk_parts_both_part(const gjk_parts_frame frame[2], uint32_t number, gjk_parts_room *room, gjk_collider *out,
                               gjk_region *region);

// Writes the numbers of a pair, unless out is NULL.
void gjk_parts_write_numbers(uint32_t a, uint32_t b, gjk_parts_pair *out);

// Is a part of B missing, such as a triangle at a hole of a height field? The queries skip it.
static inline bool gjk_parts_both_lacks(gjk_status *of_part) {
  const bool lacks = *of_part == GJK_ERROR_RANGE;
  *of_part = lacks ? GJK_OK : *of_part;
  return lacks;
}

#endif
