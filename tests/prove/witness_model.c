// Stands in for src/gjk/gjk_witness.c under the queries: any points, from what tests/prove/witness.c shows to be
// enough.
#include "src/gjk/gjk_witness.h"

#include "simplex_any.h"

void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a, gjk_vec3 *point_b,
                        bool *saturated) {
  const gjk_simplex *s = &it->simplex;
  //@ assert s->count >= 1 && s->count <= 3;
  for (unsigned i = 0; i < s->count; i++) {
    check_vertex(&s->slot[s->order[i]]);
  }
  check_size(normal->x, ANY_UNIT);
  check_size(normal->y, ANY_UNIT);
  check_size(normal->z, ANY_UNIT);
  *point_a = any_position();
  *point_b = any_position();
  if (any_bool()) {
    *saturated = true;
  }
}
