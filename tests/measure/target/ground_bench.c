// Firmware: instructions a tick of the platform game of tests/programs/examples/platform.c, and its RAM: falling|mean|worst,
// landing and resting alike, bytes|RAM
#define PLATFORM_IS_MEASURED
#include "count.h"
#include "tests/programs/examples/platform.c"

// Ticks: crates fall up to the first, and lie still from the second on.
#define FALLING 120
#define LANDING 240
#define TICKS 480

COUNTED bool counted_tick(int time) {
  return tick(time);
}

// Runs ticks first to last - 1.
static bool measure(const char *name, uint32_t first, uint32_t last) {
  count_tally t = {0, 0, 0};
  bool fine = true;
  for (uint32_t i = first; i < last && fine; i++) {
    const uint32_t begin = board_ticks();
    fine = counted_tick((int)i);
    count_add(&t, count_since(begin));
  }
  count_line(name, &t);
  board_print("\n");
  return fine;
}

int firmware_main(void) {
  const bool fine = count_prepare() && start() && measure("falling", 0, FALLING) &&
                    measure("landing", FALLING, LANDING) && measure("resting", LANDING, TICKS);
  board_print("bytes");
  count_field((uint32_t)(gjk2_scene_bytes(&config) + sizeof touch + sizeof scene + sizeof runner + sizeof id +
                         sizeof pose + sizeof speed));
  board_print("\n");
  return fine ? 0 : 1;
}
