// A late input arrives: the scene goes back five ticks by copying a block, and plays on to the same bits.
#include <stdio.h>
#include <string.h>

#include "gjk/scene.h"

static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_shape *const shapes[] = {&ball};

static uint32_t block[GJK_SCENE_BYTES(2, 2, 4) / 4], saved[GJK_SCENE_BYTES(2, 2, 4) / 4];

// One tick: body 1 moves towards body 0.
static uint64_t play(gjk_scene *scene, gjk_body_id mover) {
  gjk_body_state state;
  gjk_report reports[4];
  gjk_progress progress;
  uint64_t hash = 0;
  gjk_scene_get(scene, mover, &state);
  state.pose.position.x -= GJK_Q16(0.25);
  gjk_scene_move(scene, mover, &state.pose);
  gjk_scene_update(scene, reports, 4, &progress);
  gjk_scene_hash(scene, &hash);
  return hash;
}

int main(void) {
  const gjk_scene_config config = {.bodies = 2, .parts = 2, .pairs = 4};
  const gjk_part part = {.shape = 0};
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &part, .part_count = 1, .category = 1, .mask = 1};
  gjk_scene scene;
  gjk_body_id still, mover;
  uint64_t first[10], again = 0;

  if (gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) != GJK_OK ||
      gjk_scene_add(&scene, &setup, &still) != GJK_OK) {
    return 1;
  }
  setup.kind = GJK_BODY_KINEMATIC;
  setup.pose.position.x = GJK_Q16(2.0);
  if (gjk_scene_add(&scene, &setup, &mover) != GJK_OK) {
    return 1;
  }
  for (int tick = 0; tick < 10; tick++) {
    if (tick == 5) {
      memcpy(saved, block, sizeof block);
    }
    first[tick] = play(&scene, mover);
  }
  memcpy(block, saved, sizeof block);  // the handle names the same block
  for (int tick = 5; tick < 10; tick++) {
    again = play(&scene, mover);
  }
  printf("%s\n", again == first[9] && again != first[8] ? "the same" : "not the same");
  return 0;
}
// prints: the same
