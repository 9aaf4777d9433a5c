// gjk2_cast, gjk2_cast_ray and gjk2_check_cast on any two colliders, paths, margins and claims, null pointers too.
#include "gjk2/check.h"
#include "plane_ways.h"

// Values of CASE.
#define CAST 1
#define RAY 2
#define CHECK 3

static void any_claim(gjk2_cast_result *r) {
  r->hit = any_bool();
  r->inside = any_bool();
  r->fraction = any_int32();
  r->point_a = any_position2();
  r->point_b = any_position2();
  r->normal.x = any_int32();
  r->normal.y = any_int32();
  r->rest_a = any_position2();
  r->rest_b = any_position2();
  r->saturated = any_bool();
  r->iterations = (uint8_t)any_between(0, UINT8_MAX);
  r->certificate.direction = any_position2();
  for (int i = 0; i < 3; i++) {
    r->certificate.a[i] = any_uint16();
    r->certificate.b[i] = any_uint16();
  }
  r->certificate.count = (uint8_t)any_between(0, UINT8_MAX);
  r->certificate.proof = (uint8_t)any_between(0, UINT8_MAX);
}

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_cast_result result;
  const gjk2_vec to_a = any_position2(), to_b = any_position2();
  const gjk2_cast_path path = {any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, any_int32()};
  const unsigned kinds = (unsigned)any_between(0, 3);
  //@ split kinds;
  any_posed(&a, &shapes[0], (kinds & 1u) != 0 ? &polygon : &curved);
  any_posed(&b, &shapes[1], (kinds & 2u) != 0 ? &polygon : &curved);
  const bool null = any_bool();
#if CASE == CAST
  (void)gjk2_cast(&a, &b, null ? NULL : &path, any_bool() ? &result : NULL);
#elif CASE == RAY
  (void)path;
  (void)gjk2_cast_ray(&a, null ? NULL : &to_a, any_bool() ? &to_b : NULL, any_bool() ? &result : NULL);
#else
  any_claim(&result);
  (void)gjk2_check_cast(&a, &b, null ? NULL : &path, any_bool() ? &result : NULL);
#endif
  return 0;
}
