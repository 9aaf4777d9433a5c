// Records what bodies do over some ticks, so that each method replays the same motion.
#ifndef BENCH_SCENE_MOTION_H
#define BENCH_SCENE_MOTION_H

#include "method.h"
#include "scene/traffic.h"

#define MOTION_TICKS 10

typedef struct motion {
  uint32_t count;
  traffic traffic;
  gjk_scene scene;       // where the traffic moves; never updated
  traffic_body *bodies;  // of the traffic
  gjk_aabb *exact;       // box of each body now
  bool *fixed;
  scene_box *boxes;      // recorded: those of tick i from first[i] to first[i + 1]
  traffic_body *states;  // likewise
  uint32_t first[MOTION_TICKS + 1];
} motion;

// False: out of memory, or the scene could not be made. Free it either way.
bool motion_start(motion *m, traffic_kind kind, uint32_t count, uint32_t percent);
void motion_free(motion *m);

// Every body at its present place.
scene_tick motion_all(motion *m);

// Records the next MOTION_TICKS ticks.
bool motion_record(motion *m);
scene_tick motion_tick(const motion *m, unsigned tick);

// A scene_meet about the present boxes; user is a motion.
bool motion_meet(const void *user, uint32_t a, uint32_t b);

// How many boxes meet at present, by a test of all pairs.
uint32_t motion_test_all(const motion *m);

#endif
