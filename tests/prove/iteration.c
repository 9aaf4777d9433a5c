// Proves src/gjk/gjk_iteration.h with the goal CASE on any two colliders, and that it leaves nothing behind that
// tests/prove/iteration_model.c does not answer.
#include "colliders.h"
#include "src/gjk/gjk_iteration.h"

// As boxes, of which some half axes may have no length.
static const gjk_shape_class boxes = {.measure = any_measure,
                                      .pose = keep_pose,
                                      .support = any_support,
                                      .refine = any_refine,
                                      .vertex = any_vertex_of,
                                      .kind = GJK_KIND_AXES};

// At least the ceiling of any query.
#define MOST 250

static void check_direction(const gjk_search_direction *direction, int32_t size) {
  check_vec3(&direction->d, size);
  check_size(direction->exact, 1);
}

// What the queries read after an outcome.
static void check_iteration(const gjk_iteration *it, unsigned outcome) {
  const gjk_simplex *s = &it->simplex;
  check_direction(&it->direction, outcome == GJK_OUTCOME_NEAREST && s->count > 1 ? INT32_C(1) << 30 : ANY_W);
  if (outcome != GJK_OUTCOME_SEPARATED) {
    const unsigned most = outcome == GJK_OUTCOME_ENCLOSING ? 4 : 3;
    //@ assert s->count >= 1 && s->count <= most;
    for (unsigned i = 0; i < s->count; i++) {
      check_vertex(&s->slot[s->order[i]]);
    }
  }
}

// True: it goes on.
static bool run(gjk_iteration *it, gjk_cache *cache) {
  if (it->iterations >= MOST) {
    return false;
  }
  it->limit = (uint8_t)any_between(it->iterations + 1, MOST);
  const unsigned outcome = gjk_iteration_run(it, CASE, cache);
  //@ split outcome;
  check_iteration(it, outcome);
  if (outcome == GJK_OUTCOME_LIMIT) {
    return true;
  }
  gjk_certificate certificate;
  gjk_iteration_certify(it, (gjk_outcome)outcome, &certificate);
  if (cache != NULL) {
    gjk_iteration_keep(it, (gjk_outcome)outcome, cache);
  }
  if (outcome != GJK_OUTCOME_SEPARATED && it->simplex.count < 4) {
    (void)gjk_iteration_near(it);
  }
  return false;
}

static void any_kind(gjk_collider *c, gjk_shape *shape, bool of_vertices) {
  any_collider(c, shape, !of_vertices ? &curved : any_bool() ? &polytope : &boxes);
  c->count = (uint16_t)any_between(1, 3);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_cache cache;
  gjk_iteration it;
  const int64_t radius = any_bool() ? 0 : Frama_C_long_long_interval(1, 2 * (int64_t)GJK_RADIUS_MAX + INT32_MAX);
  const unsigned kinds = (unsigned)any_between(0, 3), warm = (unsigned)any_between(0, 1);
  //@ split kinds;
  any_kind(&a, &shapes[0], (kinds & 1u) != 0);
  any_kind(&b, &shapes[1], (kinds & 2u) != 0);
  any_cache(&cache);
  // What the simplex keeps of its vertices, which its model leaves as it is.
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) {
      it.simplex.toward[i][j] = any_long(ANY_SQUARE);
    }
  }
  //@ split warm;
  if (gjk_iteration_start(&it, &a, &b, CASE, radius)) {
    //@ assert it.shift >= -3 && it.shift <= 29;
    check_size(it.radius, INT32_MAX);
    check_vec3(&it.delta, ANY_W);
    if (run(&it, warm != 0 ? &cache : NULL)) {
      (void)run(&it, NULL);
    }
  }
  return 0;
}
