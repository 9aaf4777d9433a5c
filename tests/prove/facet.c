// src/depth/gjk_facet.h: heights and height keys of any planes, CASE 0; any candidate, 1; the corners of any facet, 2.
#include "facets.h"

#include "colliders.h"

// As the vertex function of the library's classes. Every number comes from a support point, so such a vertex exists.
static bool any_existing(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  *offset = any_vec3(ANY_OFFSET);
  return true;
}

static const gjk_shape_class existing = {.measure = any_measure,
                                         .pose = keep_pose,
                                         .support = any_support,
                                         .refine = any_refine,
                                         .vertex = any_existing,
                                         .kind = GJK_KIND_SMOOTH};

static void any_iteration(gjk_iteration *it, const gjk_collider *a, bool is_curved) {
  it->a = a;
  it->b = a;
  it->shift = (int8_t)any_between(0, 29);
  it->stalls = is_curved ? any_stalls : NULL;
  it->direction.d = any_direction(3);
  it->direction.exact = any_bool();
}

static void any_triangle(gjk_iteration *it) {
  for (int i = 0; i < 3; i++) {
    any_corner(&it->simplex.slot[i], gjk_pair_is_curved(it));
  }
  gjk_simplex_set(&it->simplex, 3);
}

static void measure(const gjk_iteration *it) {
  const gjk_vec3 w = any_vec3(ANY_W);
  gjk_facet facet;
  const uint32_t key =
      gjk_height_key(Frama_C_long_long_interval(INT64_MIN, INT64_MAX), Frama_C_long_long_interval(1, INT64_MAX));
  //@ assert key <= GJK_HEIGHT_KEY_MAX;
  const uint32_t height = gjk_height(&it->direction.d, &w);
  //@ assert height <= GJK_HEIGHT_MAX;
  const gjk_q16 depth = gjk_depth_across(it, &w);
  //@ assert depth >= 0 && depth <= ANY_DEPTH - 4;
  facet.found = false;
  (void)gjk_facet_may_improve(&facet, it->shift, key);
  any_facet(&facet, false);
  (void)gjk_facet_may_improve(&facet, it->shift, key);
}

static void consider(gjk_iteration *it, gjk_q16 bound, bool found) {
  gjk_facet facet;
  any_triangle(it);
  facet.found = false;
  if (found) {
    any_facet(&facet, gjk_pair_is_curved(it));
  }
  gjk_facet_consider(&facet, it, any_bool(), bound);
  check_facet(&facet, gjk_pair_is_curved(it));
  for (int i = 0; i < 3; i++) {
    check_corner(&it->simplex.slot[i], gjk_pair_is_curved(it));
  }
}

static void load(gjk_iteration *it, bool is_set) {
  const gjk_simplex *s = &it->simplex;
  gjk_facet facet;
  any_facet(&facet, gjk_pair_is_curved(it));
  facet.set = is_set;
  gjk_simplex_clear(&it->simplex);
  if (is_set) {
    any_triangle(it);
  }
  gjk_facet_load(&facet, it);
  //@ split s->count;
  //@ assert s->count >= 1 && s->count <= 3;
  check_vec3(&it->direction.d, INT32_C(1) << 30);
  for (unsigned i = 0; i < s->count; i++) {
    check_vertex(&s->slot[s->order[i]]);
  }
}

int main(void) {
  gjk_shape shape = {0};
  gjk_collider a = {0};
  gjk_iteration it;
  any_collider(&a, &shape, &existing);
  for (int i = 0; i < 4; i++) {
    any_iteration(&it, &a, (i & 1) != 0);
#if CASE == 0
    measure(&it);
#elif CASE == 1
    consider(&it, -1, (i & 2) != 0);
    consider(&it, any_between(0, ANY_DEPTH), (i & 2) != 0);
#else
    load(&it, (i & 2) != 0);
#endif
  }
  return 0;
}
