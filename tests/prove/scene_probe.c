// Queries of shapes, CASE, on any scene that gjk_scene_check lets through: any collider, way, margin, filter, hits, null
// pointers too.
#include "gjk/probe.h"

#include "scene_any.h"

// Values of CASE.
#define CAST 1
#define CASTS 2
#define RAY 3
#define RAYS 4
#define WITHIN 5

#define HITS 3

static bool any_accept(void *user, gjk_body_id body, uint32_t user_of_body, uint16_t part) {
  return any_bool();
}

static void ask(const gjk_scene *scene, const gjk_collider *collider) {
  const gjk_vec3 from = any_position(), to = any_position();
  const gjk_scene_filter filter = {any_uint32(), any_uint32(), any_body_handle(), any_bool() ? any_accept : NULL, NULL};
  const gjk_scene_hit after = {any_body_handle(), any_uint16(), any_uint32(), any_uint32()};
  const gjk_scene_filter *of = any_bool() ? &filter : NULL;
  gjk_scene_hit hits[HITS];
  gjk_cast_result result;
  bool found;
  uint32_t count;
  const int32_t room = any_between(0, HITS);
  //@ split room;
#if CASE == CAST
  (void)gjk_scene_cast(scene, collider, any_bool() ? &to : NULL, any_int32(), of, any_bool() ? hits : NULL,
                       any_bool() ? &result : NULL, any_bool() ? &found : NULL);
#elif CASE == CASTS
  (void)gjk_scene_cast_all(scene, collider, any_bool() ? &to : NULL, any_int32(), of, any_bool() ? &after : NULL,
                           any_bool() ? hits : NULL, (uint32_t)room, any_bool() ? &count : NULL);
#elif CASE == RAY
  (void)gjk_scene_cast_ray(scene, any_bool() ? &from : NULL, any_bool() ? &to : NULL, of, any_bool() ? hits : NULL,
                           any_bool() ? &result : NULL, any_bool() ? &found : NULL);
#elif CASE == RAYS
  (void)gjk_scene_cast_ray_all(scene, any_bool() ? &from : NULL, any_bool() ? &to : NULL, of,
                               any_bool() ? &after : NULL, any_bool() ? hits : NULL, (uint32_t)room,
                               any_bool() ? &count : NULL);
#else
  (void)gjk_scene_query_within(scene, collider, any_int32(), of, any_bool() ? &after : NULL, any_bool() ? hits : NULL,
                               (uint32_t)room, any_bool() ? &count : NULL);
#endif
}

int main(void) {
  apart_block apart;
  gjk_scene scene;
  gjk_shape of_collider;
  gjk_collider collider = {0};
  if (!any_scene(&scene, &apart)) {
    return 0;
  }
  any_collider(&collider, &of_collider, any_bool() ? &polytope : &curved);
  collider.position = any_position();
  ask(&scene, any_bool() ? &collider : NULL);
  return 0;
}
