// What tests do with a scene of a few bodies. Types are those of space, or of the plane where macros name them so.
#ifndef SCENE_BODIES_H
#define SCENE_BODIES_H

#include "check.h"

// A pose that is not turned.
static inline gjk_pose scene_pose(gjk_q16 x, gjk_q16 y) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  pose.position.y = y;
  return pose;
}

static inline gjk_body_id scene_add_parts(gjk_scene *scene, const gjk_part *parts, uint16_t count, uint8_t kind,
                                          const gjk_pose *pose) {
  gjk_body_setup setup = {0};
  gjk_body_id id = {0, 0};
  setup.pose = *pose;
  setup.parts = parts;
  setup.part_count = count;
  setup.kind = kind;
  setup.category = setup.mask = 1;
  CHECK(gjk_scene_add(scene, &setup, &id) == GJK_OK);
  return id;
}

// A body of one part: the shape of that number.
static inline gjk_body_id scene_add_shape(gjk_scene *scene, uint16_t shape, uint8_t kind, const gjk_pose *pose) {
  const gjk_part part = {shape, false, GJK_POSE_IDENTITY};
  return scene_add_parts(scene, &part, 1, kind, pose);
}

static inline void scene_move_to(gjk_scene *scene, gjk_body_id id, gjk_q16 x, gjk_q16 y) {
  const gjk_pose pose = scene_pose(x, y);
  CHECK(gjk_scene_move(scene, id, &pose) == GJK_OK);
}

static inline void scene_teleport_to(gjk_scene *scene, gjk_body_id id, gjk_q16 x, gjk_q16 y) {
  const gjk_pose pose = scene_pose(x, y);
  CHECK(gjk_scene_teleport(scene, id, &pose) == GJK_OK);
}

// A whole update, of which all reports have room. Returns how many there are.
static inline uint32_t scene_update(gjk_scene *scene, gjk_report *reports, uint32_t capacity) {
  gjk_progress progress;
  CHECK(gjk_scene_update(scene, reports, capacity, &progress) == GJK_OK);
  CHECK(progress.reports_left == 0 && progress.pairs_left == 0);
  CHECK(gjk_scene_check(scene) == GJK_OK);
  return progress.reports;
}

static inline uint64_t scene_hash(const gjk_scene *scene) {
  uint64_t hash = 0;
  CHECK(gjk_scene_hash(scene, &hash) == GJK_OK);
  return hash;
}

static inline void scene_ignore(void *user, const gjk_report *report) {
  (void)user;
  (void)report;
}

#endif
