// src/motion/gjk_advance.h on any two colliders, any way and margin: CASE 0 polytopes, CASE 1 a curved shape and any.
#include "src/motion/gjk_advance.h"

#include "gaps.h"

static void check_point(const gjk_vec3 *p) {
  check_size(p->x, INT64_C(1) << 31);
  check_size(p->y, INT64_C(1) << 31);
  check_size(p->z, INT64_C(1) << 31);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_way way;
  gjk_cast_result r;
  any_collider(&a, &shapes[0], CASE == 0 ? &polytope : &curved);
  any_collider(&b, &shapes[1], CASE == 0 || any_bool() ? &polytope : &curved);
  a.position = any_position();
  b.position = any_position();
  any_way(&way);
  const int answer = gjk_advance(&a, &b, &way, any_between(0, INT32_MAX), &r);
  //@ split answer;
  check_size(r.iterations, UINT8_MAX);
  if (answer != GJK_ADVANCE_MISS && answer != GJK_ADVANCE_INSIDE) {
    //@ assert r.fraction >= 0 && r.fraction <= GJK_Q30_ONE;
    check_size(r.normal.x, ANY_UNIT);
    check_size(r.normal.y, ANY_UNIT);
    check_size(r.normal.z, ANY_UNIT);
    check_point(&r.point_a);
    check_point(&r.point_b);
    check_point(&r.rest_a);
    check_point(&r.rest_b);
    check_size(r.inside, 1);
    check_size(r.saturated, 1);
  }
  return 0;
}
