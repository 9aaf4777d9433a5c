// Stands in for src/depth/gjk_box_sat.c under the queries: any answer, for any pair.
#include "src/depth/gjk_box_sat.h"

#include "facets.h"

extern int facet_is_found;  // by the model of the facet

bool gjk_is_box_pair(const gjk_iteration *it) {
  return !gjk_pair_is_curved(it) && any_bool();
}

gjk_box_sat_answer gjk_box_sat(gjk_iteration *it, unsigned *number, bool *points, gjk_facet *facet) {
  const int32_t answer = any_between(GJK_BOX_SAT_FACET, GJK_BOX_SAT_FLAT);
  //@ assert it->shift >= 0;
  it->direction.d = any_direction(3);
  it->direction.exact = any_bool();
  it->simplex.count = 3;
  for (int i = 0; i < 3; i++) {
    any_corner(&it->simplex.slot[i], false);
  }
  any_normal(&it->simplex.normal);
  *points = *points || any_bool();
  if (answer == GJK_BOX_SAT_FACET) {
    *number = (unsigned)any_between(0, 14);
    any_facet(facet, false);
    facet_is_found = 1;
  }
  return (gjk_box_sat_answer)answer;
}
