// A small platform game: a level of tiles in flash, a lift, eighty crates that fall, and a runner who slides over the level.
#include "gjk2/slide.h"
#include "platform_level.h"

enum { LEVEL, LIFT, FIRST, BODIES = 82, REST = -1, ASLEEP = -2 };
static const gjk2_scene_config config = {
    .bodies = BODIES, .parts = BODIES, .pairs = 128, .box_margin = 4000, .detail = GJK_DETAIL_CONTACTS, .persist = 1};
static const gjk_scene_filter solid = {.category = 2, .mask = 2};
static const gjk2_slide_setup gait = {{0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, 64, GJK_Q16(0.3), GJK_Q16(0.1), true, &solid};
static uint32_t block[5000];
static gjk2_manifold touch;
static const gjk2_scene_bindings tools = {.details = &gjk2_scene_contacts, .manifolds = &touch, .keeps_manifolds = 1};
static gjk2_scene scene;
static gjk2_collider runner;
static gjk_body_id id[BODIES];
static gjk2_pose pose[BODIES];
static int32_t speed[BODIES], rise;  // LSB a tick: of a body downwards, or REST, ASLEEP; of the runner upwards

static bool start(void) {
  static const gjk2_pose upright = {{GJK_Q16(2), GJK_Q16(1.6)}, {0, GJK_Q30_ONE}};
  bool fine = gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 3, &tools) == GJK_OK;
  for (int i = 0; i < BODIES && fine; i++) {
    pose[i] = (gjk2_pose){{i % 62 * 39000, i ? GJK_Q16(4) + i / 62 * 34000 + i % 9 * 7000 : 0}, {GJK_Q30_ONE, 0}};
    const gjk2_part part = {.shape = (uint16_t)(i < FIRST ? i : 2)};
    const uint8_t kind = (uint8_t)(i < FIRST ? i : GJK_BODY_DYNAMIC), category = i < FIRST ? 3 : 1;
    const gjk2_body_setup setup = {pose[i], &part, 1, kind, 0, category, 3, (uint32_t)i, 50};
    fine = gjk2_scene_add(&scene, &setup, &id[i]) == GJK_OK;
  }
  return fine && gjk2_collider_init(&runner, &body, 0, 0) == GJK_OK && gjk2_collider_pose(&runner, &upright) == GJK_OK;
}

// Two that meet or part wake up. Of two that overlap, the upper crate goes out of the other one; unless it hit hard, it rests.
static void part_crates(void *user, const gjk2_report *r) {
  const gjk2_manifold *m = r->manifold;
  const int64_t depth = m != 0 && m->count > 0 ? -m->contact[0].distance : 0;
  const bool b_goes = r->user_a < FIRST || (depth > 0 && m->normal.y > 0);
  const uint32_t i = b_goes ? r->user_b : r->user_a;
  (void)user;
  if (r->event != GJK_EVENT_PERSIST) {
    speed[r->user_a] = speed[r->user_b] = 0;
  }
  if (i >= FIRST && depth > 0) {
    pose[i].position.x += (int32_t)(m->normal.x * (b_goes ? depth : -depth) / GJK_Q30_ONE);
    pose[i].position.y += (int32_t)(m->normal.y * (b_goes ? depth : -depth) / GJK_Q30_ONE);
    speed[i] = depth > 100 ? 0 : REST;
  }
}

static bool tick(int time) {
  gjk2_slide_result slid;
  speed[LIFT] = time % 120 < 60 ? -1518 : 1482;
  for (int i = LIFT; i < BODIES; i++) {
    if (i == LIFT || speed[i] >= 0) {
      speed[i] += 18;
      pose[i].position.y -= speed[i];
      (void)gjk2_scene_move(&scene, id[i], &pose[i]);  // in range
    } else if (speed[i] == REST) {
      speed[i] = ASLEEP;
      (void)gjk2_scene_sleep(&scene, id[i]);  // until it is moved
    }
  }
  const gjk2_vec to = {runner.position.x + 4000, runner.position.y + rise};
  const bool fine = gjk2_scene_update_each(&scene, part_crates, 0) == GJK_OK &&
                    gjk2_slide(&scene, &runner, &to, &gait, &slid) == GJK_OK;
  rise = !slid.on_ground ? rise - 300 : slid.count > 1 ? 9000 : -300;  // at a wall it jumps
  return fine && gjk2_collider_move(&runner, &slid.position) == GJK_OK;
}

#ifndef PLATFORM_IS_MEASURED
#include <stdio.h>
int main(void) {
  int time = 0;
  for (bool fine = start(); fine && time < 570; fine = tick(time++)) {
  }
  printf("after %d ticks at column %ld\n", time, (long)(runner.position.x / GJK_Q16_ONE));
  return 0;
}
#endif
// prints: after 570 ticks at column 33
