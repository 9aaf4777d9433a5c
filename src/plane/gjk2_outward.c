// How a normal of the plane is rounded outward.
#include "gjk2_outward.h"

// depth u / 2^30, rounded away from 0.
//   |depth u| <= 2^60, and 2^30 - 1 more: size < 2^61
static gjk_q16 plane_move_outward(gjk_q16 depth, gjk_q30 u) {
  const uint64_t size = gjk_magnitude64(gjk_mul32(depth, u)) + ((UINT32_C(1) << 30) - 1);
  const gjk_q16 steps = (gjk_q16)(size >> 30);
  return u < 0 ? -steps : steps;
}

gjk2_vec gjk2_outward_move(gjk_q16 depth, gjk2_unit normal) {
  const gjk2_vec t = {plane_move_outward(depth, normal.x), plane_move_outward(depth, normal.y)};
  return t;
}

bool gjk2_outward_clears(gjk2_vec n, int64_t height, int32_t radius, gjk2_vec t) {
  const int64_t beyond = gjk2_dot(n, t) - height;  // below 2^61 + 2^60
  if (beyond < 0 || radius == 0) {
    return beyond >= 0;
  }
  return gjk2_reaches((uint64_t)beyond, (uint64_t)gjk2_dot(n, n), gjk_umul32((uint32_t)radius, (uint32_t)radius), 0);
}

// A component of 0 is exact to half an LSB, and none exceeds 1.
static void plane_grow_component(gjk_q30 *u) {
  if (*u != 0 && *u > -GJK_Q30_ONE && *u < GJK_Q30_ONE) {
    *u += *u > 0 ? 1 : -1;
  }
}

// The same for a length, by the leading bits of beyond / |n| where they tell.
static bool clears(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length, gjk2_vec t) {
  const int64_t beyond = gjk2_dot(n, t) - height;
  if (beyond > 0 && radius > 0) {
    unsigned shift;
    const uint32_t leading = (uint32_t)(gjk2_quotient(length, &shift, (uint64_t)beyond) >> 32);  // off by less than 9
    if (shift >= 32 && shift <= 62 && leading > 9 && (leading - 9) >> (shift - 32) >= (uint32_t)radius) {
      return true;
    }
  }
  return gjk2_outward_clears(n, height, radius, t);
}

void gjk2_outward_normal(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length, gjk_q16 depth,
                         gjk2_unit *normal) {
  for (int i = 0; i < 6 && depth > 0; i++) {  // not reached: 6, growing 5 times suffices
    if (clears(n, height, radius, length, gjk2_outward_move(depth, *normal))) {
      return;
    }
    plane_grow_component(&normal->x);
    plane_grow_component(&normal->y);
  }
}
