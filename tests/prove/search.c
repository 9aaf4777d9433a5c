// src/gjk/gjk_search.h on any two colliders of vertices, from any feature that src/gjk/gjk_iteration.c leaves. CASE 1 to 3:
// of so many vertices, at any iteration. CANONICAL: of any, with any ties; shapes may be made of half axes, and have a
// closed form.
#include "colliders.h"
#include "src/gjk/gjk_search.h"

// A value of CASE.
#define CANONICAL 4

#if CASE == CANONICAL
static bool any_close(struct gjk_iteration *it) {
  check_size(it->delta.x, ANY_W);
  return any_bool();
}

static const gjk_shape_class half_axes = {.measure = any_measure,
                                          .pose = keep_pose,
                                          .support = any_support,
                                          .refine = any_refine,
                                          .vertex = any_vertex_of,
                                          .close = any_close,
                                          .kind = GJK_KIND_AXES};
#endif

// Of half axes, or of a list of vertices.
static void any_solid(gjk_collider *c, gjk_shape *shape, bool axes) {
#if CASE == CANONICAL
  const gjk_shape_class *type = axes ? &half_axes : &polytope;
#else
  const gjk_shape_class *type = &polytope;
#endif
  any_collider(c, shape, type);
  c->count = axes ? (uint16_t)any_between(0, 3) : (uint16_t)any_between(1, UINT16_MAX);
}

// All slots are set: how many are, Eva does not follow through so many steps.
static void any_feature(gjk_iteration *it, int32_t count) {
  for (int i = 0; i < 4; i++) {
    any_vertex(&it->simplex.slot[i]);
  }
  any_normal(&it->simplex.normal);
  it->simplex.count = (uint8_t)count;
}

static void ask(gjk_iteration *it, gjk_goal goal) {
#if CASE == CANONICAL
  const int32_t count = any_between(1, 3);
  //@ split count;
  (void)gjk_search_closes(it, goal);
  any_feature(it, count);
  it->ties[0] = any_uint16();
  it->ties[1] = any_uint16();
  it->direction.d = any_direction((unsigned)count);
  it->direction.exact = any_bool();
  if (gjk_search_canonical(it, any_bool())) {
    check_vec3(&it->direction.d, ANY_W);
    check_vertex(gjk_simplex_vertex(&it->simplex, 0));
  }
#else
  it->iterations = (uint8_t)any_between(GJK_PLAIN_ITERATIONS, GJK_SEARCH_ITERATIONS_MAX);
  it->recalls = (uint8_t)any_between(0, GJK_RECALLS_MAX);
  it->seen[0] = ((uint64_t)(uint32_t)any_int32() << 32) | 1u;
  it->seen[1] = ((uint64_t)(uint32_t)any_int32() << 32) | 1u;
  any_feature(it, CASE);
  const unsigned outcome = gjk_search_on(it, goal, GJK_SEARCH_ITERATIONS_MAX);
  //@ assert it->iterations <= GJK_SEARCH_ITERATIONS_MAX;
  check_size(outcome, GJK_OUTCOME_LIMIT);
#endif
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_iteration it;
  const gjk_goal goal = (gjk_goal)any_between(GJK_GOAL_DISTANCE, GJK_GOAL_SIGNED);
  const unsigned kinds = CASE == CANONICAL ? (unsigned)any_between(0, 3) : 0;
  //@ split kinds;
  any_solid(&a, &shapes[0], (kinds & 1u) != 0);
  any_solid(&b, &shapes[1], (kinds & 2u) != 0);
  if (gjk_iteration_start(&it, &a, &b, goal, 0)) {
    ask(&it, goal);
  }
  return 0;
}
