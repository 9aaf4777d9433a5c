// src/plane_motion/gjk2_cast_report.h's gjk2_advance on any way and margin, and what the check of a cast asks beside it.
// CASE 0: two polygons, 1: a curved shape and any, 2: a ray and any.
#include "plane_ways.h"
#include "src/plane_motion/gjk2_cast_report.h"

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0}, at_a, at_b;
  gjk2_way way;
  gjk2_cast_result result;
  gjk_q30 fraction;
  gjk2_rate rate;
  any_posed(&a, &shapes[0], CASE == 0 ? &polygon : &curved);
  a.state = GJK2_STATE_POSED;
#if CASE == 2
  const gjk2_vec from = any_position2(), to = any_position2();
  (void)gjk2_cast_ray(&a, &from, &to, &result);
#else
  any_posed(&b, &shapes[1], CASE == 0 || any_bool() ? &polygon : &curved);
  b.state = GJK2_STATE_POSED;
  any_way(&way, &a, &b);
  (void)gjk2_advance(&way, any_between(0, INT32_MAX), any_bool(), any_bool(), &result);
  any_way(&way, &a, &b);
  (void)gjk2_cast_places(&way, any_between(0, GJK_Q30_ONE), &at_a, &at_b);
  const gjk2_vec n = any_vec2((INT32_C(1) << 30) + 4), p = any_vec2(2 * ANY_OFFSET), q = any_vec2(2 * ANY_OFFSET);
  const int64_t most = any_long(-(INT64_C(1) << 62), INT64_C(1) << 62);
  (void)gjk2_cast_bound(&way, n, most, any_long(0, (INT64_C(1) << 32) - 1), (uint32_t)any_between(0, INT32_MAX),
                        &fraction, any_bool() ? &rate : NULL);
  (void)gjk2_cast_foot(&way, p, q, any_between(0, GJK_Q30_ONE));
#endif
  return 0;
}
