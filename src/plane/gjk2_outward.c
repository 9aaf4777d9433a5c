// How a normal of the plane is rounded outward.
#include "gjk2_outward.h"

gjk2_vec gjk2_outward_move(gjk_q16 depth, gjk2_unit normal) {
  const gjk2_vec t = {gjk2_outward_step(depth, normal.x), gjk2_outward_step(depth, normal.y)};
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

void gjk2_outward_normal(gjk2_vec n, int64_t height, int32_t radius, const gjk2_length *length, gjk_q16 depth,
                         gjk2_unit *normal) {
  for (int i = 0; i < 6 && depth > 0; i++) {  // not reached: 6, growing 5 times suffices
    if ((!GJK_SMALL && gjk2_outward_is_clear(n, height, radius, length, depth, normal)) ||
        gjk2_outward_clears(n, height, radius, gjk2_outward_move(depth, *normal))) {
      return;
    }
    plane_grow_component(&normal->x);
    plane_grow_component(&normal->y);
  }
}
