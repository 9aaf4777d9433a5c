// The tree of any scene that gjk_scene_check lets through: changed, asked, and passed through by a box.
#include "scene_any.h"
#include "src/scene/gjk_scene_passage.h"
#include "src/scene/gjk_scene_tree.h"

// Values of CASE.
#define INSERT 1
#define TAKE 2
#define BOX 3
#define RAY 4
#define NEAREST 5
#define PASSAGE 6

#define HITS 3

static void any_hit(gjk_scene_hit *hit) {
  hit->body = any_body_handle();
  hit->part = any_uint16();
  hit->fraction = any_uint32();
}

static void find(const gjk_scene *scene) {
  const gjk_vec3 from = any_position(), to = any_position();
  const gjk_aabb box = {from, to};
  gjk_scene_hit hits[HITS], after;
  gjk_shape of_collider;
  gjk_collider collider = {0};
  gjk_q16 distance;
  bool found;
  uint32_t count;
  const int32_t room = any_between(0, 1);
  const gjk_body_id ignore = any_body_handle();
  any_hit(&after);
  //@ split room;
#if CASE == BOX
  (void)gjk_scene_query_box(scene, any_bool() ? &box : NULL, any_bool() ? &after : NULL, room != 0 ? hits : NULL,
                            any_below(HITS + 1), any_bool() ? &count : NULL);
#elif CASE == RAY
  (void)gjk_scene_query_ray(scene, any_bool() ? &from : NULL, any_bool() ? &to : NULL, any_bool() ? &after : NULL,
                            room != 0 ? hits : NULL, any_below(HITS + 1), any_bool() ? &count : NULL);
#else
  any_collider(&collider, &of_collider, any_bool() ? &polytope : &curved);
  (void)gjk_scene_query_nearest(scene, any_bool() ? &collider : NULL, any_int32(), any_bool() ? &ignore : NULL,
                                room != 0 ? hits : NULL, any_bool() ? &distance : NULL, any_bool() ? &found : NULL);
#endif
}

static void pass(const gjk_scene_view *v) {
  const gjk_aabb box = any_box();
  const gjk_vec3 from = any_position(), to = any_position();
  gjk_scene_passage passage;
  gjk_scene_passage_start(v, &passage, &box, Frama_C_long_long_interval(0, (INT64_C(1) << 35) - 1), &from, &to);
  for (int i = 0; i < 2; i++) {
    uint32_t entered;
    const uint32_t part = gjk_scene_passage_next(v, &passage, &entered);
    if (part == GJK_SCENE_NONE) {
      return;
    }
    //@ assert part < PARTS;
    //@ assert entered <= 0x40000000;
    passage.latest = Frama_C_unsigned_long_interval(0, (uint32_t)GJK_Q30_ONE);
  }
}

int main(void) {
  apart_block apart;
  gjk_scene scene;
  gjk_scene_view v;
  if (!any_scene(&scene, &apart) || gjk_scene_view_of(&scene, &v) != GJK_OK) {
    return 0;
  }
#if CASE == INSERT
  gjk_scene_tree_insert(&v, any_below(PARTS));
#elif CASE == TAKE
  gjk_scene_tree_remove(&v, any_below(PARTS));
#elif CASE == PASSAGE
  pass(&v);
#else
  find(&scene);
#endif
  return 0;
}
