// Stands in for src/scene_query/gjk_scene_cast.c under gjk_slide: any answers of tests/prove/scene_probe.c.
#include "gjk/probe.h"
#include "scene_any.h"
#include "src/scene_query/gjk_scene_inquiry.h"

void gjk_scene_look_round(const gjk_scene_view *v, const gjk_scene_filter *filter, gjk_scene_vicinity *near) {
  check_size(near->box.lower.x ^ near->box.lower.y ^ near->box.lower.z, INT64_C(1) << 31);
  check_size(near->box.upper.x ^ near->box.upper.y ^ near->box.upper.z, INT64_C(1) << 31);
  near->whole = any_bool();
}

gjk_status gjk_scene_cast_near(const gjk_scene *scene, const gjk_scene_vicinity *near, const gjk_collider *collider,
                               const gjk_vec3 *to, gjk_q16 margin, const gjk_scene_filter *filter, gjk_scene_hit *hit,
                               gjk_cast_result *result, bool *found) {
  //@ assert collider->state == GJK_STATE_POSED;
  //@ assert margin >= 0;
  check_size(to->x ^ to->y ^ to->z, INT64_C(1) << 31);
  const int32_t answer = any_between(0, 3);
  //@ split answer;
  if (answer == 0) {
    return GJK_ERROR_RANGE;
  }
  *found = answer != 1;
  if (answer == 1) {
    return GJK_OK;
  }
  hit->body.slot = any_below(BODIES);
  hit->body.generation = any_uint32();
  hit->part = any_uint16();
  hit->fraction = any_below(0x40000001);
  if (answer == 2) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  result->inside = any_bool();
  result->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  result->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  result->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  result->rest_b = any_position();
  return GJK_OK;
}
