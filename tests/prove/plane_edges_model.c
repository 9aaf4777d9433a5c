// Stands in for src/plane/gjk2_edges.c under the queries: any answer that it may give, as tests/prove/plane_search.c
// shows.
#include "plane_colliders.h"

gjk2_lie gjk2_nearest_edge(gjk2_search *s, gjk2_edge *edge) {
  const gjk2_lie lie = (gjk2_lie)any_between(GJK2_LIE_OVERLAP, GJK2_LIE_OPEN);
  any_vertex(&edge->p);
  any_vertex(&edge->q);
  edge->height = any_long(0, INT64_C(9) << 58);
  edge->length.squared = (uint64_t)any_long(1, (INT64_C(1) << 60) + 1);
  edge->length.inverse = (uint32_t)any_long(0x3fffffff, 0x7fffffff);
  edge->length.zeros = (unsigned)any_between(1, 31);
  s->d = any_vec2(ANY_W);
  s->along = any_long(-(INT64_C(9) << 58), INT64_C(9) << 58);
  return lie;
}

bool gjk2_edge_is_lower(const gjk2_edge *edge, uint64_t height, const gjk2_length *length) {
  (void)edge;
  (void)height;
  (void)length;
  return any_bool();
}
