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
