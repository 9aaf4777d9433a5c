// Stands in for the queries of the plane and their checks under casts: any answer, as tests/prove/plane_query.c shows.
#include "gjk2/check.h"

#include "plane_ways.h"

static void check_posed(const gjk2_collider *a, const gjk2_collider *b) {
  //@ assert a->state == GJK2_STATE_POSED && b->state == GJK2_STATE_POSED;
}

static void any_certificate(gjk2_certificate *certificate, bool curved_pair) {
  certificate->proof = (uint8_t)(curved_pair ? GJK2_PROOF_NONE : GJK2_PROOF_NEAREST);
  certificate->count = (uint8_t)any_between(1, 2);
  certificate->direction = any_vec2(ANY_W);
  for (int i = 0; i < 3; i++) {
    certificate->a[i] = any_uint16();
    certificate->b[i] = any_uint16();
  }
}

gjk_status gjk2_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_distance_result *out) {
  const int32_t touching = any_between(0, 1);
  check_posed(a, b);
  (void)cache;
  //@ split touching;
  out->intersecting = touching != 0;
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->saturated = any_bool();
  out->distance = touching != 0 ? 0 : any_between(0, INT32_MAX);
  out->lower = out->distance;
  out->upper = touching != 0 ? 0 : any_between(0, INT32_MAX);
  out->point_a = any_position2();
  out->point_b = any_position2();
  const gjk2_vec u = any_vec2(ANY_UNIT);
  out->normal.x = u.x;
  out->normal.y = u.y;
  any_certificate(&out->certificate, gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape));
  return any_bool() ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}

gjk_status gjk2_within(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, gjk2_cache *cache,
                       gjk2_decision *out) {
  check_posed(a, b);
  //@ assert distance >= 0;
  (void)cache;
  out->yes = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  return any_bool() ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}

static gjk_status any_proof(void) {
  const int32_t status = any_between(0, 2);
  return status == 0 ? GJK_OK : status == 1 ? GJK_ERROR_UNPROVEN : GJK_ERROR_UNSUPPORTED;
}

gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result) {
  check_posed(a, b);
  check_within(result->intersecting, 1);
  return any_proof();
}

gjk_status gjk2_check_decision(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance,
                               const gjk2_decision *decision) {
  check_posed(a, b);
  //@ assert distance >= 0;
  check_within(decision->yes, 1);
  return any_proof();
}
