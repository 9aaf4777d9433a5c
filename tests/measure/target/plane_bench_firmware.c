// Firmware: instructions and stack per query of the plane on an emulated core, one line per family:
// NAME|mean|worst|iterations or contacts x 100|bytes of stack
#include "count.h"
#include "paint.h"
#include "plane_bench.h"

static void measure(const plane_family *family) {
  count_tally t = {0, 0, 0};
  uint32_t iterations = 0, stack = 0;
  plane_bench_start();
  for (unsigned i = 0; i < PLANE_PAIRS; i++) {
    plane_bench_next(family);
    const uintptr_t top = paint_stack();
    const uint32_t start = board_ticks();
    iterations += plane_bench_run(family);
    count_add(&t, count_since(start));
    const uint32_t depth = painted_depth(top);
    stack = depth > stack ? depth : stack;
  }
  count_line(family->name, &t);
  count_field(iterations * 100 / PLANE_PAIRS);
  count_field(stack);
  board_print("\n");
}

int firmware_main(void) {
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned i = 0; i < plane_family_count; i++) {
    measure(&plane_families[i]);
  }
  return 0;
}
