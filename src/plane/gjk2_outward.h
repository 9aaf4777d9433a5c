// A depth's normal, rounded outward: moving by the depth along it parts the shapes, exactly.
#ifndef GJK2_SRC_OUTWARD_H
#define GJK2_SRC_OUTWARD_H

#include "gjk2_measure_inline.h"

// depth u / 2^30, rounded away from 0.
//   |depth u| <= 2^60, and 2^30 - 1 more: size < 2^61
static inline gjk_q16 gjk2_outward_step(gjk_q16 depth, gjk_q30 u) {
  const uint64_t size = gjk_magnitude64(gjk_mul32(depth, u)) + ((UINT32_C(1) << 30) - 1);
  const gjk_q16 steps = (gjk_q16)(size >> 30);
  return u < 0 ? -steps : steps;
}

// depth normal, each component rounded away from 0. Pre: 0 <= depth <= 2^29 + 2^4.
gjk2_vec gjk2_outward_move(gjk_q16 depth, gjk2_unit normal);

// Does moving B by t leave the line across n at least radius behind the origin? All of A - B lies behind or on that
// line, n . w = height. Exact. |n|, |height| as in gjk2_measure.h; |t| <= 2^30; 0 <= radius < 2^30.
bool gjk2_outward_clears(gjk2_vec n, int64_t height, int32_t radius, gjk2_vec t);

// Grows the components of normal until the move clears: by 2^-30 at most six times. length: of n.
void gjk2_outward_normal(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length, gjk_q16 depth,
                         gjk2_unit *normal);

// Does the move clear, by the leading bits of how far it leads? False: they do not tell. length: of n.
static inline bool gjk2_outward_is_clear(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length,
                                         gjk_q16 depth, const gjk2_unit *normal) {
  const gjk2_vec t = {gjk2_outward_step(depth, normal->x), gjk2_outward_step(depth, normal->y)};
  const int64_t beyond = gjk2_dot(n, t) - height;  // below 2^61 + 2^60
  unsigned shift;
  if (beyond <= 0 || radius == 0) {
    return beyond >= 0 && radius == 0;
  }
  const uint32_t leading =
      (uint32_t)(gjk2_inline_quotient(length, &shift, (uint64_t)beyond) >> 32);  // off by less than 9
  return shift >= 32 && shift <= 62 && leading > 9 && (leading - 9) >> (shift - 32) >= (uint32_t)radius;
}

#endif
