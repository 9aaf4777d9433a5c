// Firmware: instructions and stack per cast on an emulated core, one line per family:
// NAME|mean|worst|iterations x 100|bytes of stack
//
// Fails if an answer is not proven.
#include "cast_bench.h"
#include "count.h"
#include "paint.h"
#include "print.h"

static void field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

static bool measure(const cast_family *family, uint32_t calibration) {
  uint32_t sum = 0, worst = 0, iterations = 0, stack = 0, unproven = 0;
  cast_bench_start();
  for (unsigned i = 0; i < CAST_WAYS; i++) {
    unproven += !cast_bench_next(family);
    const uintptr_t top = paint_stack();
    const uint32_t start = board_ticks();
    iterations += cast_bench_run(family);
    const uint32_t count = count_instructions(board_ticks() - start, calibration);
    const uint32_t depth = painted_depth(top);
    sum += count;
    worst = count > worst ? count : worst;
    stack = depth > stack ? depth : stack;
  }
  board_print(family->name);
  field(sum / CAST_WAYS);
  field(worst);
  field(iterations * 100 / CAST_WAYS);
  field(stack);
  board_print("\n");
  return unproven == 0;
}

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned i = 0; i < cast_family_count; i++) {
    if (!measure(&cast_families[i], calibration)) {
      board_print("an answer is not proven\n");
      return 1;
    }
  }
  return 0;
}
