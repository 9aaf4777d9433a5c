// gjk_cast, gjk_cast_ray and gjk_check_cast on any two colliders, paths, margins and claims, null pointers too.
#include "gjk/check.h"
#include "portals.h"

// Values of CASE.
#define CAST 1
#define RAY 2
#define CHECK 3

static void check_result(int status, const gjk_cast_result *r) {
  //@ split status;
  if (status == GJK_OK) {
    check_size(r->hit, 1);
    check_size(r->iterations, UINT8_MAX);
    if (r->hit) {
      //@ assert r->fraction >= 0 && r->fraction <= GJK_Q30_ONE;
      check_size(r->inside, 1);
      check_size(r->saturated, 1);
      check_size(r->rest_a.x, INT64_C(1) << 31);
      check_size(r->rest_b.x, INT64_C(1) << 31);
      check_size(r->normal.x, ANY_UNIT);
    }
  }
}

static void any_claim(gjk_cast_result *r) {
  r->hit = any_bool();
  r->inside = any_bool();
  r->fraction = any_int32();
  r->point_a = any_position();
  r->point_b = any_position();
  r->normal.x = any_int32();
  r->normal.y = any_int32();
  r->normal.z = any_int32();
  r->rest_a = any_position();
  r->rest_b = any_position();
  r->saturated = any_bool();
  r->iterations = (uint8_t)any_between(0, UINT8_MAX);
  r->certificate.direction = any_position();
  for (int i = 0; i < 3; i++) {
    r->certificate.a[i] = any_uint16();
    r->certificate.b[i] = any_uint16();
  }
  const int32_t count = any_between(0, 4);
  //@ split count;
  r->certificate.count = (uint8_t)(count < 4 ? count : any_between(4, UINT8_MAX));
  r->certificate.proof = (uint8_t)any_between(0, UINT8_MAX);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_cast_result result;
  const gjk_vec3 to_a = any_position(), to_b = any_position();
  const gjk_cast_path path = {any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, any_int32()};
  const unsigned kinds = (unsigned)any_between(0, 3);
  //@ split kinds;
  any_collider(&a, &shapes[0], (kinds & 1u) != 0 ? &polytope : &curved);
  any_collider(&b, &shapes[1], (kinds & 2u) != 0 ? &polytope : &curved);
  a.position = any_position();
  b.position = any_position();
  b.count = any_uint16();
  const bool null = any_bool();
#if CASE == CAST
  const int status = gjk_cast(&a, &b, null ? NULL : &path, any_bool() ? &result : NULL);
  check_result(status, &result);
#elif CASE == RAY
  const int status = gjk_cast_ray(&a, null ? NULL : &to_a, &to_b, any_bool() ? &result : NULL);
  check_result(status, &result);
#else
  any_claim(&result);
  (void)gjk_check_cast(&a, &b, null ? NULL : &path, any_bool() ? &result : NULL);
#endif
  return 0;
}
