// Stands in for src/query/gjk_penetration.c: any result, as tests/prove/query.c shows.
#include "src/query/gjk_distance.h"

#include "colliders.h"

gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out) {
  bool points = true;
  return gjk_signed_distance_along(a, b, cache, workspace, &points, out);
}

gjk_status gjk_signed_distance_along(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                                     const gjk_workspace *workspace, bool *points, gjk_distance_result *out) {
  *points = *points || any_bool();
  if (any_bool()) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  const gjk_vec3 u = any_vec3(ANY_UNIT);
  const gjk_unit3 normal = {u.x, u.y, u.z};
  out->distance = any_int32();
  out->lower = any_int32();
  out->upper = any_int32();
  out->normal = normal;
  if (*points) {
    out->point_a = any_position();
    out->point_b = any_position();
  }
  out->intersecting = any_bool();
  out->saturated = any_bool();
  return any_bool() ? GJK_OK : GJK_ERROR_CAPACITY;
}
