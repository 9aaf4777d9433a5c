// src/plane/gjk2_measure.h and src/plane/gjk2_outward.h: any vectors, heights and radii in the ranges that they state.
#include "plane_any.h"
#include "src/plane/gjk2_measure.h"
#include "src/plane/gjk2_outward.h"

static void measure(gjk2_vec n) {
  const uint64_t h = (uint64_t)any_long(0, INT64_C(9) << 58);
  gjk2_length length;
  gjk2_unit unit;
  unsigned shift;
  gjk2_length_set(&length, n);
  gjk2_unit_set(&unit, &length, n);
  check_within(unit.x, ANY_UNIT);
  check_within(unit.y, ANY_UNIT);
  (void)gjk2_quotient(&length, &shift, h);
  (void)gjk2_round_distance(&length, (gjk2_round_to)any_between(GJK2_ROUND_DOWN, GJK2_ROUND_UP), h);
  (void)gjk2_is_within((int64_t)h, n, any_between(0, INT32_MAX));
  (void)gjk2_weight(&length, any_bool(), any_long(0, INT64_C(1) << 62));
}

static void move(gjk2_vec n) {
  const int64_t height = any_long(-(INT64_C(9) << 58), INT64_C(9) << 58);
  const gjk_q16 depth = any_between(0, (INT32_C(1) << 29) + 16);
  const int32_t radius = any_between(0, (INT32_C(1) << 30) - 1);
  gjk2_unit normal = {any_between(-ANY_UNIT, ANY_UNIT), any_between(-ANY_UNIT, ANY_UNIT)};
  (void)gjk2_outward_clears(n, height, radius, gjk2_outward_move(depth, normal));
  gjk2_length length;
  gjk2_length_set(&length, n);
  gjk2_outward_normal(n, height, radius, &length, depth, &normal);
  check_within(normal.x, ANY_UNIT);
  check_within(normal.y, ANY_UNIT);
}

int main(void) {
  const gjk2_vec n = any_vec2(ANY_W);
  if (n.x != 0 || n.y != 0) {
    measure(n);
    move(n);
  }
  return 0;
}
