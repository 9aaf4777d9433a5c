// Stands in for src/gjk/gjk_search.c under the queries: what further iterations of src/gjk/gjk_iteration.c may leave.
#include "colliders.h"
#include "src/gjk/gjk_search.h"

gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit) {
  for (unsigned i = 0; i < it->simplex.count; i++) {
    check_vertex(&it->simplex.slot[it->simplex.order[i]]);
  }
  //@ assert limit <= GJK_NO_LIMIT;
  return gjk_iteration_run(it, goal, NULL);
}

// A feature of the simplex's vertices or of others, with its direction.
static void any_other_feature(gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  const int32_t count = any_between(1, 3);
  //@ split count;
  s->count = (uint8_t)count;
  for (unsigned i = 0; i < s->count; i++) {
    any_vertex(&s->slot[s->order[i]]);
  }
  any_normal(&s->normal);
  it->direction.d = any_direction(s->count);
  it->direction.exact = any_bool();
}

bool gjk_search_canonical(gjk_iteration *it, bool points) {
  for (unsigned i = 0; i < it->simplex.count; i++) {
    check_vertex(&it->simplex.slot[it->simplex.order[i]]);
  }
  if (!points && any_bool()) {
    return false;
  }
  any_other_feature(it);
  return true;
}

bool gjk_search_closes(gjk_iteration *it, gjk_goal goal) {
  if (goal == GJK_GOAL_WITHIN || it->shift < 0 || any_bool()) {
    return false;
  }
  any_other_feature(it);
  it->iterations = 1;
  it->ties[0] = any_uint16();
  it->ties[1] = any_uint16();
  return true;
}
