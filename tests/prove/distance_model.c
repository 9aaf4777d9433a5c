// Stands in for src/query/gjk_distance.c and gjk_intersect.c under the time of impact: any result, as tests/prove/query.c
// shows.
#include "src/query/gjk_distance.h"

#include "colliders.h"
#include "gjk/intersect.h"

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert distance >= 0 && cache == \null;
  if (any_bool()) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->yes = any_bool();
  return GJK_OK;
}

gjk_status gjk_distance_with(const gjk_collider *a, const gjk_collider *b, gjk_distance_detail detail, gjk_cache *cache,
                             gjk_distance_result *out) {
  //@ assert detail == GJK_DISTANCE_BY_SCANS;
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert \initialized(&cache->count);
  const int32_t count = any_between(1, 3), touching = any_between(0, 1);
  //@ split touching;
  out->intersecting = touching != 0;
  out->saturated = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->distance = 0;
  out->lower = 0;
  out->upper = 0;
  if (touching == 0) {
    out->distance = any_between(0, INT32_MAX);
    out->lower = any_between(0, out->distance);
    out->upper = any_between(out->distance, INT32_MAX);
    const gjk_vec3 u = any_vec3(ANY_UNIT);
    out->normal.x = u.x;
    out->normal.y = u.y;
    out->normal.z = u.z;
    out->point_a = any_position();
    out->point_b = any_position();
  }
  out->certificate.count = (uint8_t)count;
  for (int i = 0; i < 3; i++) {
    out->certificate.a[i] = any_uint16();
    out->certificate.b[i] = any_uint16();
  }
  return any_bool() ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}
