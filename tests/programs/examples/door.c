// A door in a scene swings shut. It never touches what stands in its way, but stops a finger before it, between two ticks
// if need be, and goes on once the crate has gone. A lift, a crane or a turret moves the same way.
#include <stdio.h>

#include "gjk/gjk.h"

enum { HITS = 8 };
static const gjk_shape leaf = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.03), GJK_Q16(1.0));
static const gjk_shape knob = GJK_CAPSULE(GJK_Q16(0.03), GJK_Q16(0.08));
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.3), GJK_Q16(0.3), GJK_Q16(0.3));
static const gjk_shape *const shapes[] = {&leaf, &knob, &crate};
// The hinge is the z axis. The leaf is 1 unit wide, with a knob through it.
static const gjk_arm_link hinge = {GJK_ARM_BASE, GJK_ARM_REVOLUTE, GJK_POSE_IDENTITY, {0, 0, 1}, 0, GJK_ANGLE(2.0)};
static const gjk_arm_part parts[] = {{&leaf, {{GJK_Q16(0.5), 0, 0}, {0, 0, 0, GJK_Q30_ONE}}, 0},
                                     {&knob, {{GJK_Q16(0.9), 0, 0}, {759250125, 0, 0, 759250125}}, 0}};
static const gjk_arm_model model = {&hinge, parts, NULL, 1, 2};
static gjk_arm_link_room link_room;
static gjk_arm_part_room part_room[2];
static gjk_arm_pair pairs[GJK_ARM_PAIRS(2, HITS)];
static uint32_t block[1000];
static gjk_scene scene;
static gjk_arm arm;
static gjk_body_id door, box;

// Turns the door from *angle by up to step, as far as nothing is near. The scene says what is around.
static bool turn(int32_t *angle, int32_t step) {
  const gjk_aabb reach = {{-70000, -70000, -70000}, {70000, 70000, 70000}};
  const gjk_arm_setup setup = {GJK_Q16(0.05), GJK_Q16(0.005), GJK_Q30_ONE / 64};
  const int32_t to = *angle + step;
  gjk_scene_hit hits[HITS];
  gjk_collider around[HITS];
  gjk_arm_edge_result edge;
  gjk_pose pose;
  uint32_t count;
  uint16_t others = 0;
  if (gjk_scene_query_box(&scene, &reach, NULL, hits, HITS, &count) != GJK_OK || count > HITS) {
    return false;
  }
  for (uint32_t i = 0; i < count; i++) {
    others += hits[i].body.slot != door.slot &&
              gjk_scene_collider(&scene, hits[i].body, hits[i].part, &around[others]) == GJK_OK;
  }
  if (gjk_arm_obstacles(&arm, around, others) != GJK_OK ||
      gjk_arm_edge_start(&arm, angle, &to, &setup, NULL, NULL) != GJK_OK ||
      gjk_arm_edge_run(&arm, 200, &edge) != GJK_OK) {
    return false;
  }
  *angle += (int32_t)((int64_t)step * edge.lower / GJK_Q30_ONE);  // proven free up to there
  return gjk_arm_poses(&arm, angle, &pose) == GJK_OK && gjk_scene_move(&scene, door, &pose) == GJK_OK;
}

int main(void) {
  const gjk_scene_config config = {.bodies = 4, .parts = 4, .own_poses = 2, .pairs = 8};
  const gjk_arm_memory memory = {&link_room, part_room, pairs, GJK_ARM_PAIRS(2, HITS)};
  const gjk_part of_door[] = {{0, true, parts[0].pose}, {1, true, parts[1].pose}}, of_box = {.shape = 2};
  const gjk_pose base = GJK_POSE_IDENTITY;
  gjk_body_setup setup = {base, of_door, 2, GJK_BODY_KINEMATIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_progress progress = {0, 0, 0};
  gjk_report report;
  int32_t angle = GJK_ANGLE(1.5707963), tick = 0, held = 0, touches = 0;
  bool made = gjk_arm_init(&arm, &model, &base, &memory) == GJK_OK &&
              gjk_scene_init(&scene, &config, block, sizeof block, shapes, 3, NULL) == GJK_OK &&
              gjk_scene_add(&scene, &setup, &door) == GJK_OK;
  setup.parts = &of_box;
  setup.part_count = 1;
  setup.pose.position = (gjk_vec3){GJK_Q16(0.8), GJK_Q16(0.3), 0};
  made = made && gjk_scene_add(&scene, &setup, &box) == GJK_OK;
  for (; made && angle > 0 && tick < 200; tick++) {  // the crate leaves through the doorway
    const int32_t before = angle;
    setup.pose.position.y -= GJK_Q16(0.01);
    made = gjk_scene_move(&scene, box, &setup.pose) == GJK_OK && turn(&angle, angle < 2000 ? -angle : -2000) &&
           gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK;
    held += before - angle < 2000 && angle > 0;
    touches += (int)progress.reports;
  }
  printf("shut after %d ticks, %d of them held back; %d touches\n", tick, held, touches);
  return !made;
}
// prints: shut after 77 ticks, 48 of them held back; 0 touches
