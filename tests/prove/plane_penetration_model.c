// Stands in for src/plane/gjk2_penetration.c under the contacts: any answer of gjk2_signed_distance.
#include "plane_any.h"

gjk_status gjk2_signed_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                gjk2_distance_result *out) {
  (void)a;
  (void)b;
  (void)cache;
  const gjk_status status = any_bool() ? GJK_OK : any_bool() ? GJK_ERROR_CAPACITY : GJK_ERROR_ITERATION_LIMIT;
  //@ split status;
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  out->distance = any_int32();
  out->normal.x = any_between(-GJK_Q30_ONE, GJK_Q30_ONE);
  out->normal.y = any_between(-GJK_Q30_ONE, GJK_Q30_ONE);
  out->point_a = any_position2();
  out->point_b = any_position2();
  return status;
}
