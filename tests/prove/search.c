// src/gjk/gjk_search.h on any two colliders of vertices, from any feature of CASE vertices that src/gjk/gjk_iteration.c leaves, at any iteration.
#include "colliders.h"
#include "src/gjk/gjk_search.h"

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_iteration it;
  const gjk_goal goal = (gjk_goal)any_between(GJK_GOAL_DISTANCE, GJK_GOAL_SIGNED);
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  a.count = (uint16_t)any_between(1, UINT16_MAX);
  b.count = (uint16_t)any_between(1, UINT16_MAX);
  if (!gjk_iteration_start(&it, &a, &b, goal, 0)) {
    return 0;
  }
  it.iterations = (uint8_t)any_between(GJK_PLAIN_ITERATIONS, GJK_SEARCH_ITERATIONS_MAX);
  it.recalls = (uint8_t)any_between(0, GJK_RECALLS_MAX);
  it.seen[0] = ((uint64_t)(uint32_t)any_int32() << 32) | 1u;
  it.seen[1] = ((uint64_t)(uint32_t)any_int32() << 32) | 1u;
  it.simplex.count = CASE;
  for (unsigned i = 0; i < CASE; i++) {
    any_vertex(&it.simplex.slot[i]);
  }
  any_normal(&it.simplex.normal);
  const unsigned outcome = gjk_search_on(&it, goal, GJK_SEARCH_ITERATIONS_MAX);
  //@ assert it.iterations <= GJK_SEARCH_ITERATIONS_MAX;
  check_size(outcome, GJK_OUTCOME_LIMIT);
  return 0;
}
