// Which hits of a segment count: from the outside, and with a normal that the surface has.
#ifndef GJK2_SRC_GROUND_WAY_H
#define GJK2_SRC_GROUND_WAY_H

#include "gjk2_ground_walk.h"

// Where the normal of a hit, from the segment to the body, lies among those of the surface.
typedef enum gjk2_ground_side {
  GJK2_GROUND_OWN,      // it is the segment's own, within 2^-26
  GJK2_GROUND_BETWEEN,  // of a convex joint or an open end
  GJK2_GROUND_CONCAVE,  // beyond a concave joint, so the segment's own takes its place
  GJK2_GROUND_OTHER     // none of them: a neighbour is nearer
} gjk2_ground_side;

// Is it the segment's own? The line's neighbours are not looked at.
bool gjk2_ground_is_own(const gjk2_line *line, const gjk2_unit *normal);

gjk2_ground_side gjk2_ground_side_of(const gjk2_line *line, const gjk2_unit *normal);

// Is all of a body in front of the segment's line by more than apart? Pre: apart >= 0.
bool gjk2_ground_is_ahead(const gjk2_line *line, const gjk2_collider *body, gjk_q16 apart);

// The box of a collider, grown by a margin and moved by x and y, which are up to 2^33 in size; saturated.
gjk2_aabb gjk2_ground_box_at(const gjk2_aabb *box, gjk_q16 margin, int64_t x, int64_t y);

#endif
