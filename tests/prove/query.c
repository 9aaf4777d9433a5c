// Every query on any two colliders and what src/gjk/gjk_iteration.h gives it: any answer of
// tests/prove/iteration_model.c.
#include "colliders.h"

// Values of CASE.
#define INTERSECT 1
#define WITHIN 2
#define DISTANCE 3
#define CHECK_DECISION 4
#define CHECK_DISTANCE 5
#define UNTIL 6
#define PENETRATION 7
#define SIGNED 8
#define CHECK_PENETRATION 9
#define WITHIN_UNTIL 10

static void any_certificate(gjk_certificate *certificate) {
  certificate->direction = any_position();
  for (int i = 0; i < 4; i++) {
    certificate->a[i] = any_uint16();
    certificate->b[i] = any_uint16();
  }
  const int32_t count = any_between(0, 5);
  //@ split count;
  certificate->count = (uint8_t)(count < 5 ? count : any_between(5, UINT8_MAX));
  certificate->proof = (uint8_t)any_between(0, UINT8_MAX);
}

static void any_unit3(gjk_unit3 *normal) {
  normal->x = any_int32();
  normal->y = any_int32();
  normal->z = any_int32();
}

static void any_workspace(gjk_workspace *workspace) {
  static gjk_epa_cell cells[1];
  workspace->cells = any_bool() ? cells : NULL;
  workspace->count = (uint32_t)any_int32();
}

static void check_normal(const gjk_unit3 *normal) {
  check_size(normal->x, ANY_UNIT);
  check_size(normal->y, ANY_UNIT);
  check_size(normal->z, ANY_UNIT);
}

// An answer is set.
static void check_points(const gjk_vec3 *a, const gjk_vec3 *b) {
  check_size(a->x, INT64_C(1) << 31);
  check_size(a->y, INT64_C(1) << 31);
  check_size(a->z, INT64_C(1) << 31);
  check_size(b->x, INT64_C(1) << 31);
  check_size(b->y, INT64_C(1) << 31);
  check_size(b->z, INT64_C(1) << 31);
}

static void ask_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                            const gjk_workspace *workspace) {
  gjk_penetration_result r;
  const gjk_status status = gjk_penetration(a, b, cache, workspace, &r);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return;
  }
  //@ split r.intersecting;
  if (r.intersecting) {
    check_size(r.depth, INT64_C(1) << 31);
    check_size(r.lower, INT64_C(1) << 31);
    check_size(r.upper, INT64_C(1) << 31);
    check_normal(&r.normal);
    check_points(&r.point_a, &r.point_b);
  }
}

static void ask_signed(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, const gjk_workspace *workspace) {
  gjk_distance_result r;
  const gjk_status status = gjk_signed_distance(a, b, cache, workspace, &r);
  if (status == GJK_OK || status == GJK_ERROR_CAPACITY) {
    check_size(r.distance, INT64_C(1) << 31);
    check_size(r.lower, INT64_C(1) << 31);
    check_size(r.upper, INT64_C(1) << 31);
    check_normal(&r.normal);
    check_points(&r.point_a, &r.point_b);
  }
}

static void ask(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache) {
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result penetration;
  gjk_workspace workspace;
  any_workspace(&workspace);
#if CASE == INTERSECT
  (void)gjk_intersect(a, b, cache, &decision);
#elif CASE == WITHIN
  (void)gjk_within(a, b, any_int32(), cache, &decision);
#elif CASE == DISTANCE
  (void)gjk_distance(a, b, cache, &distance);
#elif CASE == UNTIL
  const gjk_effort effort = {(uint8_t)any_between(0, UINT8_MAX), any_int32()};
  (void)gjk_distance_until(a, b, &effort, cache, &distance);
#elif CASE == PENETRATION
  ask_penetration(a, b, cache, &workspace);
#elif CASE == SIGNED
  ask_signed(a, b, cache, &workspace);
#elif CASE == CHECK_DECISION
  any_certificate(&decision.certificate);
  decision.yes = any_bool();
  (void)gjk_check_decision(a, b, any_int32(), &decision);
#elif CASE == CHECK_DISTANCE
  any_certificate(&distance.certificate);
  distance.intersecting = any_bool();
  distance.distance = any_int32();
  distance.lower = any_int32();
  distance.upper = any_int32();
  distance.saturated = any_bool();
  distance.point_a = any_position();
  distance.point_b = any_position();
  any_unit3(&distance.normal);
  (void)gjk_check_distance(a, b, &distance);
#elif CASE == WITHIN_UNTIL
  gjk_within_result within;
  (void)gjk_within_until(a, b, any_int32(), (uint8_t)any_between(0, UINT8_MAX), cache, &within);
#else
  any_certificate(&penetration.certificate);
  penetration.intersecting = any_bool();
  penetration.depth = any_int32();
  penetration.lower = any_int32();
  penetration.upper = any_int32();
  penetration.point_a = any_position();
  penetration.point_b = any_position();
  any_unit3(&penetration.normal);
  (void)gjk_check_penetration(a, b, &penetration);
#endif
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_cache cache;
  const unsigned kinds = (unsigned)any_between(0, 3), warm = (unsigned)any_between(0, 1);
  //@ split kinds;
  any_collider(&a, &shapes[0], (kinds & 1u) != 0 ? &polytope : &curved);
  any_collider(&b, &shapes[1], (kinds & 2u) != 0 ? &polytope : &curved);
  any_cache(&cache);
  //@ split warm;
  ask(&a, &b, warm != 0 ? &cache : NULL);
  return 0;
}
