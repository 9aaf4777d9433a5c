// A stack stands under one iteration a tick when contacts start from their last impulses, kept in the words of pairs.
#include <stdio.h>

#include "gjk/scene.h"

enum { CRATES = 4 };
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape *const shapes[] = {&crate};
static uint32_t block[(GJK_SCENE_BYTES(8, 8, 16) + GJK_SCENE_MORE_BYTES(0, 0, 16)) / 4];
static gjk_report reports[16];
static int32_t height[CRATES + 1], speed[CRATES + 1];  // upwards, LSB and LSB a tick; body 0 is the floor

static void push(const gjk_report *r, int32_t impulse) {
  speed[r->a.slot] -= r->a.slot == 0 ? 0 : impulse;
  speed[r->b.slot] += impulse;
}

// Two bodies that touch do not approach each other.
static void solve(const gjk_report *r) {
  const int32_t last = (int32_t)r->words[0], closing = speed[r->a.slot] - speed[r->b.slot];
  const int32_t wanted = last + (r->a.slot == 0 ? closing : closing / 2), impulse = wanted > 0 ? wanted : 0;
  push(r, impulse - last);
  r->words[0] = (uint32_t)impulse;
}

// By how much the crate on top sinks in two seconds.
static long sinks(bool warm) {
  const gjk_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .persist = 1, .pair_words = 1};
  const gjk_part part = {.shape = 0};
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &part, .part_count = 1, .category = 1, .mask = 1};
  gjk_body_id id[CRATES + 1];
  gjk_progress progress;
  gjk_scene scene;
  (void)gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL);
  for (int i = 0; i <= CRATES; i++, setup.kind = GJK_BODY_DYNAMIC, setup.pose.position.z += GJK_Q16_ONE) {
    height[i] = setup.pose.position.z;
    (void)gjk_scene_add(&scene, &setup, &id[i]);
    speed[i] = i == 0 ? 0 : -178;
  }
  for (int tick = 0; tick < 120; tick++) {
    (void)gjk_scene_update(&scene, reports, 16, &progress);  // in this scene no pair ends
    for (uint32_t i = 0; i < 2 * progress.reports; i++) {    // first all start, then all are solved
      const gjk_report *r = &reports[i % progress.reports];
      i < progress.reports ? push(r, (int32_t)(r->words[0] *= warm)) : solve(r);
    }
    for (int i = 1; i <= CRATES; i++, speed[i - 1] -= 178) {  // gravity, 60 ticks a second
      height[i] += speed[i];
      setup.pose.position.z = height[i];
      (void)gjk_scene_move(&scene, id[i], &setup.pose);
    }
  }
  return (long)(CRATES * GJK_Q16_ONE - height[CRATES]);
}

int main(void) {
  printf("it sinks by %ld LSB from the last impulses, by %ld from none\n", sinks(true), sinks(false));
  return 0;
}
// prints: it sinks by 1514 LSB from the last impulses, by 102294 from none
