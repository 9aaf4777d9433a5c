// One operation, CASE, on any scene that gjk_scene_check lets through, over any tree: tests/prove/scene_tree_model.c.
#include "scene_any.h"

// Values of CASE.
#define ADD 1
#define REMOVE 2
#define MOVE 3
#define SHAPE 4
#define FIELDS 5
#define BEGIN 6
#define TEST 7
#define FINISH 8
#define REPORT 9
#define HASH 10
#define READ 11

static void add(gjk_scene *scene) {
  gjk_part parts[2];
  gjk_body_id out;
  gjk_body_setup setup = {any_pose(),
                          any_bool() ? parts : NULL,
                          (uint16_t)any_below(3),
                          (uint8_t)any_uint16(),
                          (uint8_t)any_uint16(),
                          any_uint32(),
                          any_uint32(),
                          any_uint32(),
                          any_int32()};
  for (int i = 0; i < 2; i++) {
    parts[i].shape = any_uint16();
    parts[i].own_pose = any_bool();
    parts[i].pose = any_pose();
  }
  if (any_bool()) {
    (void)gjk_scene_add(scene, any_bool() ? &setup : NULL, any_bool() ? &out : NULL);
  } else {
    (void)gjk_scene_add_at(scene, any_uint32(), any_bool() ? &setup : NULL, any_bool() ? &out : NULL);
  }
}

static void move(gjk_scene *scene) {
  const gjk_pose pose = any_pose();
  if (any_bool()) {
    (void)gjk_scene_move(scene, any_body_handle(), any_bool() ? &pose : NULL);
  } else {
    (void)gjk_scene_teleport(scene, any_body_handle(), any_bool() ? &pose : NULL);
  }
}

static void set_fields(gjk_scene *scene) {
  gjk_body_state state;
  gjk_body_id body;
  gjk_collider collider;
  (void)gjk_scene_get(scene, any_body_handle(), any_bool() ? &state : NULL);
  (void)gjk_scene_body_at(scene, any_uint32(), any_bool() ? &body : NULL);
  (void)gjk_scene_collider(scene, any_body_handle(), any_uint16(), any_bool() ? &collider : NULL);
  (void)gjk_scene_sleep(scene, any_body_handle());
  (void)gjk_scene_wake(scene, any_body_handle());
  (void)gjk_scene_set_user(scene, any_body_handle(), any_uint32());
  (void)gjk_scene_set_filter(scene, any_body_handle(), any_uint32(), any_uint32());
  (void)gjk_scene_refilter(scene, any_body_handle());
}

static void test(gjk_scene *scene) {
  (void)gjk_scene_test_pairs(scene, any_uint32(), any_uint32());
}

static void begin_update(gjk_scene *scene) {
  uint32_t pairs;
  (void)gjk_scene_update_begin(scene, any_bool() ? &pairs : NULL);
}

// From the last test on, or from some report on.
static void report(gjk_scene *scene) {
  gjk_report report;
  gjk_progress progress;
  gjk_scene_header *h = scene->block;
  h->phase = CASE == FINISH ? GJK_SCENE_TESTING : GJK_SCENE_REPORTING;
  (void)gjk_scene_update_slice(scene, 0, any_bool() ? &report : NULL, any_below(2), any_bool() ? &progress : NULL);
}

static void read(const gjk_scene *scene) {
  uint32_t cursor = any_uint32();
  bool found;
  gjk_report near;
  gjk_scene_stats stats;
  gjk_manifold manifold;
  (void)gjk_scene_get_stats(scene, any_bool() ? &stats : NULL);
  (void)gjk_scene_next_near(scene, any_bool() ? &cursor : NULL, any_bool() ? &near : NULL, any_bool() ? &found : NULL);
  near.a = any_body_handle();
  near.b = any_body_handle();
  near.part_a = any_uint16();
  near.part_b = any_uint16();
  (void)gjk_scene_manifold(scene, any_bool() ? &near : NULL, any_uint16(), any_bool() ? &manifold : NULL);
}

int main(void) {
  apart_block apart;
  gjk_scene scene;
  if (!any_scene(&scene, &apart)) {
    return 0;
  }
#if CASE == ADD
  add(&scene);
#elif CASE == REMOVE
  (void)gjk_scene_remove(&scene, any_body_handle());
#elif CASE == MOVE
  move(&scene);
#elif CASE == SHAPE
  (void)gjk_scene_set_shape(&scene, any_body_handle(), any_uint16(), any_uint16());
#elif CASE == FIELDS
  set_fields(&scene);
#elif CASE == BEGIN
  begin_update(&scene);
#elif CASE == TEST
  test(&scene);
#elif CASE == FINISH || CASE == REPORT
  report(&scene);
#elif CASE == HASH
  uint64_t hash;
  (void)gjk_scene_hash(&scene, any_bool() ? &hash : NULL);
#else
  read(&scene);
#endif
  return 0;
}
