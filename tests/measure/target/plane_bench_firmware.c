// Firmware: instructions and stack per query of the plane on an emulated core, one line per family:
// NAME|mean|worst|iterations or contacts x 100|bytes of stack
#include "count.h"
#include "paint.h"
#include "plane_bench.h"
#include "print.h"

static void field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

static void measure(const plane_family *family, uint32_t calibration) {
  uint32_t sum = 0, worst = 0, iterations = 0, stack = 0;
  plane_bench_start();
  for (unsigned i = 0; i < PLANE_PAIRS; i++) {
    plane_bench_next(family);
    const uintptr_t top = paint_stack();
    const uint32_t start = board_ticks();
    iterations += plane_bench_run(family);
    const uint32_t count = count_instructions(board_ticks() - start, calibration);
    const uint32_t depth = painted_depth(top);
    sum += count;
    worst = count > worst ? count : worst;
    stack = depth > stack ? depth : stack;
  }
  board_print(family->name);
  field(sum / PLANE_PAIRS);
  field(worst);
  field(iterations * 100 / PLANE_PAIRS);
  field(stack);
  board_print("\n");
}

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned i = 0; i < plane_family_count; i++) {
    measure(&plane_families[i], calibration);
  }
  return 0;
}
