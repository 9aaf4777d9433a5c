// Stands in for src/plane_motion/gjk2_advance.c and gjk2_advance_place.c under casts and their checks: any answer that tests/prove/plane_advance.c
// shows possible.
#include "plane_ways.h"
#include "src/plane_motion/gjk2_cast_report.h"

static void check_path(const gjk2_way *way) {
  check_long2(&way->t);
  check_long2(&way->delta);
  check_vec2(way->d, INT32_C(1) << 30);
  check_within(way->base, INT64_C(1) << 62);
}

gjk_status gjk2_advance(gjk2_way *way, gjk_q16 margin, bool early, bool late, gjk2_cast_result *out) {
  (void)early, (void)late;
  check_path(way);
  //@ assert margin >= 0;
  out->hit = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  if (out->hit) {
    out->inside = any_bool();
    out->fraction = any_between(0, GJK_Q30_ONE);
    out->saturated = any_bool();
  }
  return any_bool() ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}

const gjk2_collider *gjk2_cast_places(const gjk2_way *way, gjk_q30 fraction, gjk2_collider *at_a, gjk2_collider *at_b) {
  check_path(way);
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  at_a->shape = way->a->shape;
  at_b->shape = way->b->shape;
  at_a->state = way->a->state;
  at_b->state = way->b->state;
  at_a->centre = any_position2();
  at_b->centre = any_position2();
  return any_bool() ? at_a : way->a;
}

gjk2_bound gjk2_cast_bound(const gjk2_way *way, gjk2_vec n, int64_t most, int64_t radius, uint32_t near,
                           gjk_q30 *fraction, gjk2_rate *rate) {
  (void)near;
  check_path(way);
  check_vec2(n, (INT32_C(1) << 30) + 4);
  check_within(most, INT64_MAX);
  //@ assert radius >= 0 && radius < INT64_C(1) << 32;
  *fraction = any_between(0, GJK_Q30_ONE);
  if (rate != NULL) {
    rate->length = any_long(1, INT64_C(1) << 31);
    rate->closing = any_long(1, INT64_MAX);
  }
  return (gjk2_bound)any_between(GJK2_BOUND_AT, GJK2_BOUND_AWAY);
}

int64_t gjk2_cast_foot(const gjk2_way *way, gjk2_vec p, gjk2_vec q, gjk_q30 fraction) {
  check_path(way);
  check_vec2(p, 2 * ANY_OFFSET);
  check_vec2(q, 2 * ANY_OFFSET);
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  return any_long(-1, (int64_t)GJK_Q30_ONE + 1);
}
