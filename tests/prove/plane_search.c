// src/plane/gjk2_search.h, and with EDGES or CURVED gjk2_edges.h and gjk2_curved_depth.h: CASE is a goal or one of these;
// any two colliders of a model class, with vertices or without; any radius, cache and limit on iterations.
#include "plane_colliders.h"
#include "src/plane/gjk2_curved_depth.h"

static bool any_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations) {
  return gjk2_curved_depth(s, edge, lower, iterations);
}

#define EDGES 10
#define CURVED 11

static void run(gjk2_search *s, const gjk2_cache *cache) {
  gjk2_certificate certificate;
  gjk2_cache kept;
  gjk2_search_aim(s, cache);
  const gjk2_outcome outcome = gjk2_search_run(s, (gjk2_goal)CASE, (uint32_t)any_between(1, 200000));
  //@ split outcome;
  gjk2_search_certify(s, outcome, &certificate);
  gjk2_search_keep(s, outcome, &kept);
}

static void measure(gjk2_search *s) {
#if CASE == EDGES
  gjk2_edge edge;
  s->iterations = 0;
  (void)gjk2_nearest_edge(s, &edge);
#elif CASE == CURVED
  gjk2_edge edge;
  int64_t lower;
  uint16_t iterations = (uint16_t)any_between(0, GJK_ITERATIONS_MAX);
  (void)gjk2_curved_depth(s, &edge, &lower, &iterations);
#else
  (void)s;
#endif
}

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_cache cache;
  gjk2_search s;
  const unsigned kinds = CASE == EDGES ? 3 : CASE == CURVED ? (unsigned)any_between(0, 2) : (unsigned)any_between(0, 3);
  const unsigned warm = (unsigned)any_between(0, 1);
  //@ split kinds;
  any_collider(&a, &shapes[0], (kinds & 1u) != 0 ? &polygon : &curved);
  any_collider(&b, &shapes[1], (kinds & 2u) != 0 ? &polygon : &curved);
  any_cache(&cache);
  //@ split warm;
  for (int i = 0; i < 4; i++) {
    any_vertex(&s.slot[i]);
  }
  const uint32_t radius = (uint32_t)any_long(0, 2 * (int64_t)GJK2_RADIUS_MAX + INT32_MAX);
  (void)gjk2_search_start(&s, &a, &b, true, radius);
  (void)gjk2_search_start(&s, &a, &b, false, radius);  // sets all
  if (CASE < EDGES) {
    run(&s, warm != 0 ? &cache : NULL);
  } else if (s.far == 0) {
    measure(&s);
  }
  return 0;
}
