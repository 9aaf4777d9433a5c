// Stands in for src/depth/gjk_facet.c: any answer, from what tests/prove/facet.c shows to be enough.
//
// facet_is_found is a copy of the facet's `found`: an analysis may keep the two states apart by it.
#include "facets.h"

int facet_is_found;

uint32_t gjk_height(const gjk_vec3 *d, const gjk_vec3 *w) {
  check_vec3(d, INT32_C(1) << 30);
  check_vec3(w, ANY_W);
  return (uint32_t)any_between(0, (int32_t)GJK_HEIGHT_MAX);
}

gjk_q16 gjk_depth_across(const gjk_iteration *it, const gjk_vec3 *w) {
  check_vec3(&it->direction.d, INT32_C(1) << 30);
  check_vec3(w, ANY_W);
  return any_between(0, ANY_DEPTH - 4);
}

bool gjk_facet_may_improve(const gjk_facet *best, int shift, uint32_t rank) {
  //@ assert shift >= 0 && shift <= 29;
  check_size(rank, UINT32_MAX);
  if (!best->found) {
    return true;
  }
  check_size(best->covers, 1);
  check_size(best->depth, ANY_DEPTH);
  return any_bool();
}

bool gjk_facet_may_tie(const gjk_facet *best, uint32_t rank) {
  check_size(best->found, 1);
  check_size(rank, UINT32_MAX);
  return any_bool();
}

int gjk_facet_compare(gjk_facet *best, gjk_iteration *it) {
  check_facet(best, false);
  check_vec3(&it->direction.d, INT32_C(1) << 30);
  for (int i = 0; i < 3; i++) {
    check_corner(&it->simplex.slot[i], false);
    any_vertex(&it->simplex.slot[i]);
  }
  return (int)any_between(-1, 1);
}

void gjk_facet_consider(gjk_facet *best, gjk_iteration *it, bool covers, gjk_q16 bound) {
  const gjk_simplex *s = &it->simplex;
  //@ assert it->shift >= 0 && it->shift <= 29 && s->count == 3;
  //@ assert bound >= -1 && bound <= ANY_DEPTH;
  check_vec3(&it->direction.d, INT32_C(1) << 30);
  check_size(it->direction.exact, 1);
  check_size(covers, 1);
  for (int i = 0; i < 3; i++) {
    check_corner(&s->slot[i], gjk_pair_is_curved(it));
  }
  any_facet(best, gjk_pair_is_curved(it));
  facet_is_found = 1;
}

void gjk_facet_load(const gjk_facet *facet, gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  check_facet(facet, gjk_pair_is_curved(it));
  if (facet->set && facet->covers) {
    for (int i = 0; i < 3; i++) {
      check_corner(&s->slot[i], gjk_pair_is_curved(it));
    }
  }
  it->direction = facet->direction;
  gjk_simplex_clear(s);
  const int32_t count = any_between(1, 3);
  for (int i = 0; i < 3; i++) {
    any_vertex(&s->slot[i]);
  }
  any_normal(&s->normal);
  s->count = (uint8_t)count;
}
