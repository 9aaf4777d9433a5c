// Impacts with those parts alone that B is in front of at the start, on a piece of the way.
#ifndef GJK_SRC_PARTS_AHEAD_H
#define GJK_SRC_PARTS_AHEAD_H

#include "gjk_parts_class.h"

// As gjk_parts_impact_ahead, where the motions are a piece of the ways: what B is in front of, and whose planes it goes
// through, is told by the ends of the whole ways. The margin is for what the pieces are off alone: a triangle within it, or
// another part, that B does not touch is in front. Pre: no pointer but part is NULL.
gjk_status gjk_parts_impact_ahead_of(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                     const gjk_motion *motion_b, const gjk_motion *way_a, const gjk_motion *way_b,
                                     const gjk_impact_setup *setup, uint32_t *part, gjk_impact_result *out);

#endif
