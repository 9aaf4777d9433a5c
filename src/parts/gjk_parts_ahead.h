// Impacts with only those parts that B is in front of at the start, on a piece of the way.
#ifndef GJK_SRC_PARTS_AHEAD_H
#define GJK_SRC_PARTS_AHEAD_H

#include "gjk_parts_class.h"

// As gjk_parts_impact_ahead, but the motions are a piece of the ways. The ends of the whole ways tell what B is in
// front of, and whose planes it goes through. The margin covers only the error of the pieces, so a triangle or other
// part within it that B does not touch is in front. Pre: no pointer but part is NULL.
gjk_status gjk_parts_impact_ahead_of(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                     const gjk_motion *motion_b, const gjk_motion *way_a, const gjk_motion *way_b,
                                     const gjk_impact_setup *setup, uint32_t *part, gjk_impact_result *out);

#endif
