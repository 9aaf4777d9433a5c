// Ticks of a scene whose instructions are counted.
#ifndef SCENE_BENCH_H
#define SCENE_BENCH_H

#include "gjk/probe.h"
#include "scene/traffic.h"

typedef struct scene_bench_case {
  const char *name;
  traffic_kind kind;
  uint32_t bodies, percent;
  bool ray;  // what is measured is a ray through them, not a tick
} scene_bench_case;

extern const scene_bench_case scene_bench_cases[];
extern const unsigned scene_bench_count;

// Starts a case and runs its first ticks. False: the scene could not be made.
bool scene_bench_start(const scene_bench_case *c);

// What is measured: the moves of a tick that is already planned, and the update.
void scene_bench_plan(void);
bool scene_bench_tick(void);

// Of the tick before.
void scene_bench_stats(gjk_scene_stats *out);

#endif
