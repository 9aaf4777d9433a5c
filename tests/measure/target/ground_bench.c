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
  const gjk2_scene_config config = {
      .bodies = BODIES, .parts = BODIES, .pairs = 128, .box_margin = 4000, .detail = GJK_DETAIL_CONTACTS, .persist = 1};
  return gjk2_scene_bytes(&config) + sizeof manifold + sizeof scene + sizeof runner + sizeof id + sizeof pose +
         sizeof speed;
}
