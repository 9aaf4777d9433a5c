// Stands in for src/gjk/gjk_iteration.c under the queries: any answer that it may give, as tests/prove/iteration.c
// shows.
#include "colliders.h"
#include "src/gjk/gjk_iteration.h"

bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius) {
  //@ assert radius >= 0 && radius <= 2 * GJK_RADIUS_MAX + 0x7fffffff;
  it->a = a;
  it->b = b;
  if (gjk_goal_separates(goal) && any_bool()) {
    return false;
  }
  it->radius = radius > 0 ? any_between(0, INT32_MAX) : 0;
  it->shift = (int8_t)any_between(-3, 29);
  it->delta = any_vec3(ANY_W);
  it->iterations = 0;
  it->stalls = a->shape->type->stalls != NULL ? a->shape->type->stalls : b->shape->type->stalls;
  gjk_simplex_clear(&it->simplex);
  return true;
}

void gjk_iteration_next(gjk_iteration *it, gjk_support *b) {
  check_vec3(&it->direction.d, ANY_DIRECTION);
  any_support(it->b, &it->direction.d, b);
  any_vertex(gjk_simplex_free(&it->simplex));
}

bool gjk_iteration_refine(gjk_iteration *it, gjk_direction *direction, gjk_support *b) {
  check_vec3(&it->direction.d, ANY_W);
  check_vertex(gjk_simplex_free(&it->simplex));
  check_vec3(&b->offset, ANY_OFFSET);
  any_support(it->b, &it->direction.d, b);
  any_vertex(gjk_simplex_free(&it->simplex));
  return any_bool();
}

bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b) {
  check_size(a, UINT16_MAX);
  check_size(b, UINT16_MAX);
  if (any_bool()) {
    return false;
  }
  any_vertex(gjk_simplex_free(&it->simplex));
  return true;
}

gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  gjk_simplex *s = &it->simplex;
  gjk_outcome outcome = (gjk_outcome)any_between(GJK_OUTCOME_NEAREST, GJK_OUTCOME_LIMIT);
  int32_t count = any_between(1, 4);
  if ((outcome == GJK_OUTCOME_SEPARATED && !gjk_goal_separates(goal)) ||
      (outcome == GJK_OUTCOME_NEAR && !gjk_goal_nears(goal))) {
    outcome = GJK_OUTCOME_NEAREST;
  }
  //@ split outcome;
  if (outcome != GJK_OUTCOME_ENCLOSING && count == 4) {
    count = 3;
  }
  //@ split count;
  s->count = (uint8_t)count;
  for (unsigned i = 0; i < s->count; i++) {
    any_vertex(&s->slot[s->order[i]]);
  }
  if (s->count >= 3) {
    any_normal(&s->normal);
  }
  it->iterations = (uint8_t)any_between(0, it->limit);
  it->direction.d = outcome == GJK_OUTCOME_NEAREST ? any_direction(s->count) : any_vec3(ANY_W);
  it->direction.exact = any_bool();
  it->ties[0] = any_uint16();
  it->ties[1] = any_uint16();
  return outcome;
}

bool gjk_iteration_near(const gjk_iteration *it) {
  //@ assert it->simplex.count >= 1 && it->simplex.count <= 3;
  return any_bool();
}

void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out) {
  check_vec3(&it->direction.d, ANY_DIRECTION);
  out->proof = (uint8_t)any_between(GJK_PROOF_NONE, GJK_PROOF_PLANE);
  out->count = (uint8_t)any_between(0, 4);
  out->direction = it->direction.d;
  for (int i = 0; i < 4; i++) {
    out->a[i] = any_uint16();
    out->b[i] = any_uint16();
  }
}

void gjk_iteration_keep(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache) {
  check_vec3(&it->direction.d, ANY_W);
  any_cache(cache);
}
