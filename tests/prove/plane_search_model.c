// Stands in for src/plane/gjk2_search.c under the queries: any answer that it may give, as tests/prove/plane_search.c
// shows.
#include "plane_colliders.h"

bool gjk2_search_start(gjk2_search *s, const gjk2_collider *a, const gjk2_collider *b, bool circles, uint32_t radius) {
  //@ assert radius <= 2 * GJK2_RADIUS_MAX + 0x7fffffff;
  s->a = a;
  s->b = b;
  if (circles && any_bool()) {
    return false;
  }
  s->delta = any_vec2(INT32_C(1) << 30);
  s->radius = radius > 0 ? any_between(0, ANY_W) : 0;
  s->far = (uint8_t)any_between(0, 3);
  s->curved = gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape);
  s->walks = any_bool();
  s->iterations = 0;
  s->d = any_vec2(ANY_W);
  s->count = 0;
  s->warm = false;
  s->whole = any_bool();
  s->first = &s->slot[0];
  s->apex = &s->slot[1];
  s->last = &s->slot[2];
  s->spare = &s->slot[3];
  return true;
}

void gjk2_search_aim(gjk2_search *s, const gjk2_cache *cache) {
  s->count = cache != NULL ? (uint8_t)any_between(0, 2) : 0;
  s->d = any_vec2(ANY_W);
  for (int i = 0; i < 4; i++) {
    any_vertex(&s->slot[i]);
  }
}

gjk2_outcome gjk2_search_run(gjk2_search *s, gjk2_goal goal, uint32_t limit) {
  gjk2_outcome outcome = (gjk2_outcome)any_between(GJK2_OUTCOME_NEAREST, GJK2_OUTCOME_LIMIT);
  if ((outcome == GJK2_OUTCOME_SEPARATED && goal != GJK2_GOAL_WITHIN && goal != GJK2_GOAL_DEPTH) ||
      (outcome == GJK2_OUTCOME_NEAR && goal > GJK2_GOAL_WITHIN)) {
    outcome = GJK2_OUTCOME_NEAREST;
  }
  const int32_t count = any_between(1, outcome == GJK2_OUTCOME_ENCLOSING ? 3 : 2);
  //@ split outcome;
  //@ split count;
  s->count = (uint8_t)count;
  for (int i = 0; i < 4; i++) {
    any_vertex(&s->slot[i]);
  }
  s->d = any_vec2(ANY_W);
  s->base = any_long(-(INT64_C(9) << 58), outcome == GJK2_OUTCOME_NEAREST ? -1 : INT64_C(9) << 58);
  s->along = any_long(-(INT64_C(9) << 58), INT64_C(9) << 58);
  s->iterations = (uint16_t)(limit < UINT16_MAX ? any_between(0, (int32_t)limit) : any_uint16());
  return outcome;
}

void gjk2_search_scan(const gjk2_search *s, gjk2_vec d, gjk2_vertex *out) {
  (void)s;
  check_vec2(d, ANY_W);
  any_vertex(out);
}

bool gjk2_search_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vertex *out) {
  (void)s;
  check_within(a, UINT16_MAX);
  check_within(b, UINT16_MAX);
  if (any_bool()) {
    return false;
  }
  any_vertex(out);
  return true;
}

void gjk2_search_certify(const gjk2_search *s, gjk2_outcome outcome, gjk2_certificate *out) {
  (void)outcome;
  check_vec2(s->d, ANY_W);
  out->proof = (uint8_t)any_between(GJK2_PROOF_NONE, GJK2_PROOF_LINE);
  out->count = (uint8_t)any_between(0, 3);
  out->direction = s->d;
  for (int i = 0; i < 3; i++) {
    out->a[i] = any_uint16();
    out->b[i] = any_uint16();
  }
}

void gjk2_search_keep(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache) {
  (void)outcome;
  check_vec2(s->d, ANY_W);
  any_cache(cache);
}
