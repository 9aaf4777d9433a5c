// The platform game, as the example has it.
#define PLATFORM_IS_MEASURED
#include "ground_bench.h"

#include "tests/programs/examples/platform.c"

bool ground_bench_start(void) {
  return start();
}

bool ground_bench_tick(int time) {
  return tick(time);
}

size_t ground_bench_bytes(void) {
  return gjk2_scene_bytes(&config) + sizeof touch + sizeof scene + sizeof runner + sizeof id + sizeof pose +
         sizeof speed;
}
