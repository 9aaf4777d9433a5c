// Every query of the plane but the contacts, on any two colliders, and what src/plane/gjk2_search.h and gjk2_edges.h give
// it: any answer of their models.
#include "plane_colliders.h"

// Values of CASE.
#define WITHIN 1
#define WITHIN_UNTIL 2
#define DISTANCE_CURVED 3
#define UNTIL 4
#define PENETRATION 5
#define SIGNED_CURVED 6
#define CHECK_DECISION 8
#define CHECK_DISTANCE 9
#define CHECK_PENETRATION 10
#define DISTANCE_MIXED 11
#define DISTANCE_POLYGONS 12
#define SIGNED_MIXED 13
#define SIGNED_POLYGONS 14

// The kinds of A and B, a bit each that is 1 for a polygon: the longest queries are split by them.
#if CASE == DISTANCE_CURVED || CASE == SIGNED_CURVED
#define LEAST_KINDS 0
#define MOST_KINDS 0
#elif CASE == DISTANCE_MIXED || CASE == SIGNED_MIXED
#define LEAST_KINDS 1
#define MOST_KINDS 2
#elif CASE == DISTANCE_POLYGONS || CASE == SIGNED_POLYGONS
#define LEAST_KINDS 3
#define MOST_KINDS 3
#else
#define LEAST_KINDS 0
#define MOST_KINDS 3
#endif

static bool any_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations) {
  (void)gjk2_nearest_edge(s, edge);
  *lower = any_long(0, (INT64_C(1) << 29) + 16);
  *iterations = any_uint16();
  return any_bool();
}

static void any_certificate(gjk2_certificate *certificate) {
  certificate->direction = any_position2();
  for (int i = 0; i < 3; i++) {
    certificate->a[i] = any_uint16();
    certificate->b[i] = any_uint16();
  }
  const int32_t count = any_between(0, 4);
  //@ split count;
  certificate->count = (uint8_t)(count < 4 ? count : any_between(4, UINT8_MAX));
  certificate->proof = (uint8_t)any_between(0, UINT8_MAX);
}

static void any_unit(gjk2_unit *normal) {
  normal->x = any_int32();
  normal->y = any_int32();
}

static void ask(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache) {
#if CASE == WITHIN
  gjk2_decision decision;
  (void)gjk2_within(a, b, any_int32(), cache, &decision);
#elif CASE == WITHIN_UNTIL
  gjk2_within_result within;
  (void)gjk2_within_until(a, b, any_int32(), (uint8_t)any_between(0, UINT8_MAX), cache, &within);
#elif CASE == DISTANCE_CURVED || CASE == DISTANCE_MIXED || CASE == DISTANCE_POLYGONS
  gjk2_distance_result distance;
  (void)gjk2_distance(a, b, cache, &distance);
#elif CASE == UNTIL
  gjk2_distance_result distance;
  const gjk2_effort effort = {(uint8_t)any_between(0, UINT8_MAX), any_int32()};
  (void)gjk2_distance_until(a, b, &effort, cache, &distance);
#elif CASE == PENETRATION
  gjk2_penetration_result penetration;
  (void)gjk2_penetration(a, b, cache, &penetration);
#elif CASE == SIGNED_CURVED || CASE == SIGNED_MIXED || CASE == SIGNED_POLYGONS
  gjk2_distance_result distance;
  (void)gjk2_signed_distance(a, b, cache, &distance);
#elif CASE == CHECK_DECISION
  gjk2_decision decision;
  any_certificate(&decision.certificate);
  decision.yes = any_bool();
  (void)gjk2_check_decision(a, b, any_int32(), &decision);
#elif CASE == CHECK_DISTANCE
  gjk2_distance_result distance;
  any_certificate(&distance.certificate);
  distance.intersecting = any_bool();
  distance.distance = any_int32();
  distance.lower = any_int32();
  distance.upper = any_int32();
  distance.saturated = any_bool();
  distance.point_a = any_position2();
  distance.point_b = any_position2();
  any_unit(&distance.normal);
  (void)gjk2_check_distance(a, b, &distance);
#else
  gjk2_penetration_result penetration;
  any_certificate(&penetration.certificate);
  penetration.intersecting = any_bool();
  penetration.depth = any_int32();
  penetration.lower = any_int32();
  penetration.upper = any_int32();
  penetration.point_a = any_position2();
  penetration.point_b = any_position2();
  any_unit(&penetration.normal);
  (void)gjk2_check_penetration(a, b, &penetration);
#endif
}

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_cache cache;
  const unsigned kinds = (unsigned)any_between(LEAST_KINDS, MOST_KINDS), warm = (unsigned)any_between(0, 1);
  //@ split kinds;
  any_collider(&a, &shapes[0], (kinds & 1u) != 0 ? &polygon : &curved);
  any_collider(&b, &shapes[1], (kinds & 2u) != 0 ? &polygon : &curved);
  any_cache(&cache);
  //@ split warm;
  ask(&a, &b, warm != 0 ? &cache : NULL);
  return 0;
}
