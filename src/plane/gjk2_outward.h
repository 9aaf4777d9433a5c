// A depth's normal, rounded outward: moving by the depth along it parts the shapes, exactly.
#ifndef GJK2_SRC_OUTWARD_H
#define GJK2_SRC_OUTWARD_H

#include "gjk2_measure.h"

// depth normal, each component rounded away from 0. Pre: 0 <= depth <= 2^29 + 2^4.
gjk2_vec gjk2_outward_move(gjk_q16 depth, gjk2_unit normal);

// Does moving B by t leave the line across n at least radius behind the origin? All of A - B lies behind or on that line,
// which n . w = height. Exact.  |n|, |height| as in gjk2_measure.h; |t| <= 2^30; 0 <= radius < 2^30.
bool gjk2_outward_clears(gjk2_vec n, int64_t height, int32_t radius, gjk2_vec t);

// Grows the components of normal until the move clears: by 2^-30 at most six times. length: of n.
void gjk2_outward_normal(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length, gjk_q16 depth,
                         gjk2_unit *normal);

#endif
