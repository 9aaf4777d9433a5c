// Stands in for src/zonotope.c under the queries: any answer, for any pair.
#include "zonotope.h"

#include "simplex_any.h"

bool gjk_is_zonotope(const gjk_iteration *it) {
  return any_bool();
}

static void any_facet(gjk_facet *facet) {
  for (int i = 0; i < 3; i++) {
    any_vertex(&facet->corner[i]);
  }
  facet->direction.d = any_direction(3);
  facet->direction.exact = any_bool();
  facet->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  facet->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  facet->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  facet->rank = (uint32_t)any_int32();
  facet->depth = any_between(0, INT32_C(1) << 30);
  facet->covers = any_bool();
  facet->set = any_bool();
  facet->found = true;
}

gjk_zonotope_answer gjk_zonotope_facet(gjk_iteration *it, gjk_facet *facet) {
  const int32_t answer = any_between(GJK_ZONOTOPE_FACET, GJK_ZONOTOPE_FLAT);
  //@ assert it->shift >= 0;
  it->direction.d = any_direction(3);
  it->direction.exact = any_bool();
  it->simplex.count = 3;
  for (int i = 0; i < 3; i++) {
    any_vertex(&it->simplex.slot[i]);
  }
  any_normal(&it->simplex.normal);
  if (answer == GJK_ZONOTOPE_FACET) {
    any_facet(facet);
  }
  return (gjk_zonotope_answer)answer;
}
