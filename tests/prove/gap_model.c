// Stands in for src/motion/gjk_gap.c under the brackets: any plane and feature that tests/prove/gap.c shows possible.
#include "src/motion/gjk_gap.h"

#include "gaps.h"

void gjk_gap_start(gjk_gap *gap, const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius) {
  //@ assert radius >= 0 && radius <= 2 * GJK_RADIUS_MAX + 0x7fffffff;
  check_way(way);
  gap->way = way;
  gap->radius = radius;
  gap->start.x = any_long(ANY_WAY);
  gap->start.y = any_long(ANY_WAY);
  gap->start.z = any_long(ANY_WAY);
  gap->scale = (unsigned)any_between(0, 1);
  gap->used = 0;
  gap->it.a = a;
  gap->it.b = b;
  gap->it.stalls = a->shape->type->stalls != NULL ? a->shape->type->stalls : b->shape->type->stalls;
  gap->it.shift = -1;
}

static void any_plane(gjk_gap *gap) {
  gjk_simplex *s = &gap->it.simplex;
  gap->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  gap->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  gap->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  gap->above = any_long(ANY_ABOVE);
  gjk_simplex_clear(s);
  const int32_t count = any_between(1, 3);
  //@ split count;
  s->count = (uint8_t)count;
  for (unsigned i = 0; i < s->count; i++) {
    any_vertex(&s->slot[i]);
  }
  gap->it.shift = (int8_t)any_between(-1, 29);
}

gjk_outcome gjk_gap_measure(gjk_gap *gap, gjk_q30 fraction) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  //@ assert gap->radius >= 0 && gap->radius <= 2 * GJK_RADIUS_MAX + 0x7fffffff + 2;
  int32_t outcome = any_between(GJK_OUTCOME_NEAREST, GJK_OUTCOME_LIMIT);
  if (outcome == GJK_OUTCOME_SEPARATED || outcome == GJK_OUTCOME_NEAR ||
      (outcome == GJK_OUTCOME_LIMIT && !gjk_pair_is_curved(&gap->it))) {
    outcome = GJK_OUTCOME_NEAREST;
  }
  //@ split outcome;
  gap->used = (unsigned)any_between(1, 2000);
  if (outcome == GJK_OUTCOME_ENCLOSING) {
    gap->it.shift = -1;
  } else {
    any_plane(gap);
  }
  return (gjk_outcome)outcome;
}

bool gjk_gap_follow(gjk_gap *gap, gjk_q30 fraction) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  gap->above = any_long(ANY_ABOVE);
  return any_bool();
}

gjk_slope gjk_gap_slope(const gjk_gap *gap) {
  check_size(gap->normal.x, ANY_UNIT);
  const gjk_slope slope = {any_long(INT64_C(1) << 62), any_long(INT64_C(1) << 62)};
  return slope;
}

gjk_vec3 gjk_gap_point(const gjk_gap *gap) {
  check_size(gap->normal.x, ANY_UNIT);
  return any_vec3(ANY_POINT);
}
