// Stands in for src/query/gjk_intersect.c and the check of a decision, under casts and their checks: any decision about two
// posed polytopes.
#include "gjk/check.h"

#include "colliders.h"

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  const bool curved = gjk_is_curved(a->shape) || gjk_is_curved(b->shape);
  //@ assert !curved;
  //@ assert distance >= 0;
  (void)cache;
  out->yes = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  return GJK_OK;
}

gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert distance >= 0;
  //@ assert \initialized(&decision->yes);
  const int32_t status = any_between(0, 2);
  return status == 0 ? GJK_OK : status == 1 ? GJK_ERROR_UNPROVEN : GJK_ERROR_UNSUPPORTED;
}
