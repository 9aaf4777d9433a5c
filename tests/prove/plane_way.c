// src/plane_motion/gjk2_way.h: CASE SET any path of any colliders; ASK any way that is set, and any vertices; ENTRY
// gjk2_entry.h on any way of two polygons; RATIO any quotient and number.
#include "plane_ways.h"
#include "src/plane_motion/gjk2_entry.h"

// Values of CASE.
#define SET 1
#define ASK 2
#define ENTRY 3
#define RATIO 4

#if CASE == SET
static void run(const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_way way;
  const gjk2_vec to_a = any_position2(), to_b = any_position2();
  const gjk2_cast_path path = {any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, any_int32()};
  const int status = gjk2_way_set(&way, a, b, any_bool() ? &path : NULL, any_bool() ? &way : NULL);
  //@ split status;
  if (status == GJK_OK) {
    check_long2(&way.of_a);
    check_long2(&way.of_b);
    check_long2(&way.t);
    check_long2(&way.delta);
    check_vec2(way.d, INT32_C(1) << 30);
    check_within(way.base, INT64_C(1) << 62);
    gjk2_way_reverse(&way);
  }
}
#elif CASE == ASK
static void run(const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_way way;
  gjk2_span span;
  bool early, late;
  any_way(&way, a, b);
  const gjk2_vec o = any_vec2(2 * ANY_OFFSET), n = any_vec2(INT32_C(1) << 30);
  const int64_t radius = any_long(0, (INT64_C(1) << 32) - 1);
  (void)gjk2_way_may_meet(&way, radius, &early, &late);
  gjk2_way_outermost(&way, any_bool(), &span);
  (void)gjk2_way_side(&way, o);
  (void)gjk2_way_is_beside(&way, o, radius);
  (void)gjk2_way_along(&way, n, o);
  (void)gjk2_way_ahead(&way, n);
  (void)gjk2_way_is_ahead(&way, o, any_bool());
}
#elif CASE == ENTRY
static void run(const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_way way;
  gjk2_entry e;
  any_way(&way, a, b);
  if (gjk2_entry_find(&way, &e)) {
    check_vec2(e.n, INT32_C(1) << 30);
    check_vec2(e.p.o, 2 * ANY_OFFSET);
    check_within((int64_t)e.count, 2);
  }
}
#else
static void run(const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_portion portion;
  (void)a;
  (void)b;
  portion.den = (uint64_t)any_long(1, INT64_MAX);
  portion.num = (uint64_t)any_long(0, (int64_t)portion.den);
  portion.fraction = gjk2_ratio(portion.num, portion.den, &portion.exact);
  //@ assert portion.fraction >= 0 && portion.fraction <= GJK_Q30_ONE;
  (void)gjk2_portion_floor(&portion, any_long(1 - (INT64_C(1) << 33), (INT64_C(1) << 33) - 1));
  (void)gjk2_portion_nearest(&portion, any_long(-ANY_WAY, ANY_WAY));
}
#endif

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  const unsigned kinds = CASE == ENTRY ? 3 : (unsigned)any_between(0, 3);
  //@ split kinds;
  any_posed(&a, &shapes[0], (kinds & 1u) != 0 ? &polygon : &curved);
  any_posed(&b, &shapes[1], (kinds & 2u) != 0 ? &polygon : &curved);
  run(&a, &b);
  return 0;
}
