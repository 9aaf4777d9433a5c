// Stands in for src/pair_search.c under the queries: what further rounds of src/iteration.c may leave.
#include "colliders.h"
#include "pair_search.h"

gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit) {
  for (unsigned i = 0; i < it->simplex.count; i++) {
    check_vertex(&it->simplex.slot[it->simplex.order[i]]);
  }
  //@ assert limit <= GJK_NO_LIMIT;
  return gjk_iteration_run(it, goal, NULL);
}
