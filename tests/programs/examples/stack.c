// A crate falls onto the ground and stays there: a scene finds the contacts, and a solver of a few lines uses them.
#include <stdio.h>

#include "gjk/scene.h"

static const gjk_shape ground = GJK_BOX(GJK_Q16(10.0), GJK_Q16(10.0), GJK_Q16(0.5));
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape *const shapes[] = {&ground, &crate};

static uint32_t block[GJK_SCENE_BYTES(8, 8, 16) / 4];  // the whole scene
static gjk_manifold manifold;
static gjk_pose pose = GJK_POSE_IDENTITY;  // of the crate
static gjk_q16 speed;                      // upwards, units a tick

// Stops the fall, and takes out what the crate is too deep.
static void resolve(void *user, const gjk_report *report) {
  (void)user;
  if (report->manifold != NULL && report->manifold->count > 0) {
    speed = speed < 0 ? 0 : speed;
    pose.position.z -= report->distance < 0 ? report->distance : 0;
  }
}

int main(void) {
  const gjk_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .detail = GJK_DETAIL_CONTACTS, .persist = 1};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .manifolds = &manifold};
  const gjk_part parts[] = {{.shape = 0}, {.shape = 1}};
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &parts[0], .part_count = 1, .category = 1, .mask = 1};
  gjk_scene scene;
  gjk_body_id floor, falling;

  if (gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) != GJK_OK ||
      gjk_scene_add(&scene, &setup, &floor) != GJK_OK) {
    return 1;
  }
  pose.position.z = GJK_Q16(3.0);
  setup.kind = GJK_BODY_DYNAMIC;
  setup.parts = &parts[1];
  setup.pose = pose;
  if (gjk_scene_add(&scene, &setup, &falling) != GJK_OK) {
    return 1;
  }
  for (int tick = 0; tick < 120; tick++) {
    speed -= GJK_Q16(0.0027);  // gravity at 60 ticks a second
    pose.position.z += speed;
    if (gjk_scene_move(&scene, falling, &pose) != GJK_OK || gjk_scene_update_each(&scene, resolve, NULL) != GJK_OK) {
      return 1;
    }
  }
  printf("the crate rests at z = %ld of 65536\n", (long)pose.position.z);
  return 0;
}
// prints: the crate rests at z = 65536 of 65536
