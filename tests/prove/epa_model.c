// Stands in for src/depth/gjk_epa.c: any outcome, as tests/prove/epa.c shows.
#include "src/depth/gjk_epa.h"

#include "facets.h"

extern int facet_is_found;  // by the model of the facet

gjk_epa_outcome gjk_epa(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                        uint16_t *iterations) {
  gjk_simplex *s = &it->simplex;
  const gjk_epa_outcome expansion = (gjk_epa_outcome)any_between(GJK_EPA_FACET, GJK_EPA_FULL);
  const int32_t count = any_between(1, 3);
  //@ assert s->count >= 1 && s->count <= 4 && it->shift >= 0;
  for (unsigned i = 0; i < s->count; i++) {
    check_vertex(&s->slot[s->order[i]]);
  }
  check_size(*iterations, UINT16_MAX);
  *iterations = any_uint16();
  *lower = any_between(-ANY_DEPTH, ANY_DEPTH);
  it->direction.d = any_vec3(ANY_DIRECTION);
  it->direction.exact = any_bool();
  //@ split expansion;
  for (int i = 0; i < 3; i++) {
    any_vertex(&s->slot[i]);
  }
  if (expansion == GJK_EPA_TOUCHES) {
    //@ split count;
    s->count = (uint8_t)count;
    any_normal(&s->normal);
  } else {
    any_facet(facet, gjk_pair_is_curved(it));
    facet_is_found = 1;
  }
  return expansion;
}
