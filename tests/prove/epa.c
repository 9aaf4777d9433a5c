// Proves src/depth/gjk_epa.h from any simplex of CASE vertices that holds the origin.
#include "src/depth/gjk_epa.h"

#include "colliders.h"
#include "facets.h"

extern int facet_is_found;  // by the model of the facet

static void any_origin(gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  gjk_simplex_clear(s);
  for (int i = 0; i < CASE; i++) {
    any_vertex(&s->slot[i]);
  }
  any_normal(&s->normal);
  s->count = CASE;
}

static void check_expansion(const gjk_iteration *it, gjk_epa_outcome expansion, const gjk_facet *facet, gjk_q16 lower) {
  const gjk_simplex *s = &it->simplex;
  check_size(lower, ANY_DEPTH);
  check_vec3(&it->direction.d, ANY_DIRECTION);
  if (expansion != GJK_EPA_TOUCHES) {
    check_facet(facet, gjk_pair_is_curved(it));
    if (facet->set && facet->covers) {
      for (int i = 0; i < 3; i++) {
        check_corner(&s->slot[i], gjk_pair_is_curved(it));
      }
    }
    return;
  }
  //@ split s->count;
  //@ assert s->count >= 1 && s->count <= 3;
  for (unsigned i = 0; i < s->count; i++) {
    check_vertex(&s->slot[s->order[i]]);
  }
}

static void run(const gjk_collider *a, const gjk_collider *b, const gjk_workspace *workspace) {
  gjk_iteration it;
  gjk_facet facet;
  gjk_q16 lower;
  uint16_t iterations = any_uint16();
  it.a = a;
  it.b = b;
  it.shift = (int8_t)any_between(0, 29);
  it.stalls = b->shape->type->stalls;
  it.direction.d = any_vec3(ANY_W);
  it.direction.exact = any_bool();
  any_origin(&it);
  facet.found = false;
  facet_is_found = 0;
  const gjk_epa_outcome expansion = gjk_epa(&it, workspace, &facet, &lower, &iterations);
  //@ split expansion;
  check_expansion(&it, expansion, &facet, lower);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_epa_cell cells[1];
  const gjk_workspace workspace = {cells, (uint32_t)any_int32()};
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  run(&a, &b, &workspace);
  any_collider(&b, &shapes[1], &curved);
  run(&a, &b, &workspace);
  return 0;
}
