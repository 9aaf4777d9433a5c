// Firmware: instructions and stack per query on an emulated core, one line per family:
// NAME|mean|worst|rounds x 100, mean|most rounds|bytes of stack
#include "bench.h"
#include "count.h"
#include "print.h"

#define PAINT 0x5AA5C33Cu

// Paints the free stack but for the last 16 words above its end, which this function may be using itself.
static void paint_stack(uintptr_t top) {
  for (volatile uint32_t *p = board_stack_low; (uintptr_t)p < top - 64; p++) {
    *p = PAINT;
  }
}

// Bytes of stack below top that were written since it was painted.
static uint32_t painted_depth(uintptr_t top) {
  const volatile uint32_t *p = board_stack_low;
  while ((uintptr_t)p < top && *p == PAINT) {
    p++;
  }
  return (uint32_t)(top - (uintptr_t)p);
}

static void field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

static void measure(const bench_family *family, uint32_t calibration) {
  uint32_t sum = 0, worst = 0, rounds = 0, most_rounds = 0, stack = 0;
  bench_start();
  for (int i = 0; i < BENCH_PAIRS; i++) {
    bench_next(family);
    volatile uint32_t here = 0;
    paint_stack((uintptr_t)&here);
    const uint32_t start = board_ticks();
    const unsigned used = bench_run(family);
    const uint32_t count = count_instructions(board_ticks() - start, calibration);
    const uint32_t depth = painted_depth((uintptr_t)&here);
    sum += count;
    worst = count > worst ? count : worst;
    rounds += used;
    most_rounds = used > most_rounds ? used : most_rounds;
    stack = depth > stack ? depth : stack;
  }
  board_print(family->name);
  field(sum / BENCH_PAIRS);
  field(worst);
  field(rounds * 100 / BENCH_PAIRS);
  field(most_rounds);
  field(stack);
  board_print("\n");
}

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned i = 0; i < bench_family_count; i++) {
    measure(&bench_families[i], calibration);
  }
  return 0;
}
