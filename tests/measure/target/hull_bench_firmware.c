// Counts the instructions of building hulls on an emulated board: one line per number of points.
#include "hull_bench.h"

#include "count.h"
#include "print.h"

int firmware_main(void) {
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned count = 16; count <= HULL_BENCH_POINTS; count *= 2) {
    hull_bench_make(count);
    const uint32_t start = board_ticks(), faces = hull_bench_build(count);
    const uint32_t instructions = count_instructions(board_ticks() - start, calibration);
    board_print("hull of ");
    print_decimal(board_print, count);
    board_print(" points, ");
    print_decimal(board_print, faces);
    board_print(" facets: ");
    print_decimal(board_print, instructions);
    board_print(" instructions\n");
  }
  return 0;
}
