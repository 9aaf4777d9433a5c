// Firmware: instructions a tick of the platform game, and its RAM: falling|mean|worst, landing and resting alike, bytes|RAM
#include "count.h"
#include "ground_bench.h"
#include "print.h"

// Ticks: crates fall up to the first, and lie still from the second on.
#define FALLING 120
#define LANDING 240
#define TICKS 480

static void line(const char *name, uint32_t mean, uint32_t worst) {
  board_print(name);
  board_print("|");
  print_decimal(board_print, mean);
  board_print("|");
  print_decimal(board_print, worst);
  board_print("\n");
}

// Runs ticks first to last - 1.
static bool measure(const char *name, uint32_t first, uint32_t last, uint32_t calibration) {
  uint32_t sum = 0, worst = 0;
  bool fine = true;
  for (uint32_t i = first; i < last && fine; i++) {
    const uint32_t begin = board_ticks();
    fine = ground_bench_tick((int)i);
    const uint32_t count = count_instructions(board_ticks() - begin, calibration);
    sum += count;
    worst = count > worst ? count : worst;
  }
  line(name, sum / (last - first), worst);
  return fine;
}

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  const bool fine = calibration != 0 && ground_bench_start() && measure("falling", 0, FALLING, calibration) &&
                    measure("landing", FALLING, LANDING, calibration) &&
                    measure("resting", LANDING, TICKS, calibration);
  line("bytes", (uint32_t)ground_bench_bytes(), 0);
  return fine ? 0 : 1;
}
