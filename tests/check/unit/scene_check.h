// What tests of gjk_scene_check share: a sound block, and checks that a wrong value in it is refused or accepted.
//
// The wrong value goes where src/scene/gjk_scene_block.h says that the field is.
#ifndef SCENE_CHECK_H
#define SCENE_CHECK_H

#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "scene_bodies.h"
#include "src/scene/gjk_scene_block.h"

#define ONE GJK_Q16_ONE
#define WORDS 8192

static const gjk_shape crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2);
static const gjk_shape *const shapes[] = {&crate, NULL};
static const gjk_scene_config config = {40, 60, 5, 30, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};

static uint32_t sound[WORDS], block[WORDS];
static gjk_scene scene;
static gjk_scene_view v;

static gjk_body_id add(gjk_q16 x, uint16_t parts) {
  static const gjk_part part[3] = {{0, false, GJK_POSE_IDENTITY},
                                   {0, true, {{0, 3 * ONE, 0}, {0, 0, 0, GJK_Q30_ONE}}},
                                   {0, true, {{0, 6 * ONE, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  const gjk_pose pose = scene_pose(x, 0);
  return scene_add_parts(&scene, part, parts, GJK_BODY_DYNAMIC, &pose);
}

static void update(void) {
  gjk_report reports[30];
  (void)scene_update(&scene, reports, 30);
}

// Bodies in slots 0 to 35: three that touch, one of three parts, the others alone; every pool has a record that was given
// back. Slot 34 is free again, slots from 36 on never were taken.
static void build(void) {
  gjk_body_id bodies[36];
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  for (int i = 0; i < 36; i++) {
    const gjk_q16 x = i < 3 ? i * (ONE / 2) : 10 * i * ONE;
    bodies[i] = add(x, i == 3 || i == 34 ? 3 : 1);
  }
  scene_teleport_to(&scene, bodies[35], 9 * 10 * ONE, 0);  // a pair for one update
  update();
  scene_teleport_to(&scene, bodies[35], -99 * ONE, 0);
  CHECK(gjk_scene_remove(&scene, bodies[34]) == GJK_OK);
  update();
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  memcpy(sound, block, sizeof block);
}

// The sound block again, found.
static void restore(void) {
  memcpy(block, sound, sizeof block);
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
}

static bool opens(void) {
  gjk_scene opened;
  return gjk_scene_seal(&scene) == GJK_OK &&
         gjk_scene_open(&opened, block, sizeof block, shapes, 2, NULL) != GJK_ERROR_CORRUPT;
}

// The check refuses it; and so does opening it, sealed afresh, wherever it comes so far.
#define REFUSED(...)                                                             \
  do {                                                                           \
    restore();                                                                   \
    __VA_ARGS__;                                                                 \
    CHECK_MSG(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT, "%s", #__VA_ARGS__); \
    CHECK_MSG(!opens(), "%s", #__VA_ARGS__);                                     \
  } while (0)

#define ACCEPTED(...)                                                 \
  do {                                                                \
    restore();                                                        \
    __VA_ARGS__;                                                      \
    CHECK_MSG(gjk_scene_check(&scene) == GJK_OK, "%s", #__VA_ARGS__); \
  } while (0)

// The first part of a slot, the node above it, and the pair of two slots.
static gjk_scene_part *part_of(uint32_t slot) {
  return &v.parts[v.bodies[slot].first];
}

static uint32_t pair_of(uint32_t a, uint32_t b) {
  for (uint32_t i = 0; i < v.header->pairs.fresh; i++) {
    if ((v.pairs[i].state & GJK_SCENE_PAIR_LIVE) != 0 && v.parts[v.pairs[i].ends.linked.part[0]].body == a &&
        v.parts[v.pairs[i].ends.linked.part[1]].body == b) {
      return i;
    }
  }
  CHECK(false);
  return 0;
}

#endif
