// Firmware: instructions per tick of a scene on an emulated core, one line per case:
// NAME|mean|worst|pairs|resting|motion|boxes|direction|warm|cold, the last seven as means
#include "count.h"
#include "print.h"
#include "scene_bench.h"

#define TICKS 50

static void field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

static bool measure(const scene_bench_case *c, uint32_t calibration) {
  uint32_t sum = 0, worst = 0;
  gjk_scene_stats all = {0}, stats;
  bool fine = scene_bench_start(c);
  for (int i = 0; i < TICKS && fine; i++) {
    scene_bench_plan();
    const uint32_t start = board_ticks();
    fine = scene_bench_tick();
    const uint32_t count = count_instructions(board_ticks() - start, calibration);
    sum += count;
    worst = count > worst ? count : worst;
    scene_bench_stats(&stats);
    all.pairs += stats.pairs;
    all.resting += stats.resting;
    all.motion += stats.motion;
    all.boxes += stats.boxes;
    all.direction += stats.direction;
    all.warm += stats.warm;
    all.cold += stats.cold;
  }
  const uint32_t means[] = {sum,       worst * TICKS, all.pairs, all.resting, all.motion,
                            all.boxes, all.direction, all.warm,  all.cold};
  board_print(c->name);
  for (unsigned i = 0; i < sizeof means / sizeof means[0]; i++) {
    field(means[i] / TICKS);
  }
  board_print("\n");
  return fine;
}

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned i = 0; i < scene_bench_count; i++) {
    if (!measure(&scene_bench_cases[i], calibration)) {
      board_print("a scene failed\n");
      return 1;
    }
  }
  return 0;
}
