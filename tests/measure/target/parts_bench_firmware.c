// Counts the instructions of queries of compounds on an emulated board: one line per query and number of parts.
#include "parts_bench.h"

#include "count.h"
#include "print.h"

int firmware_main(void) {
  static const char *const names[PARTS_BENCH_QUERIES] = {"intersect", "distance", "contacts", "cast",
                                                         "distance of each part posed before"};
  static const unsigned counts[] = {8, 32, 128};
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned k = 0; k < 3 && counts[k] <= PARTS_BENCH_PARTS; k++) {
    for (int tree = 1; tree >= 0; tree--) {
      parts_bench_make(counts[k], tree == 1);
      for (int query = 0; query < PARTS_BENCH_QUERIES; query++) {
        uint32_t sum = 0;
        for (unsigned place = 0; place < 8; place++) {
          const uint32_t start = board_ticks();
          (void)parts_bench_ask((parts_bench_query)query, place);
          sum += count_instructions(board_ticks() - start, calibration);
        }
        print_decimal(board_print, counts[k]);
        board_print(tree == 1 ? " parts, tree, " : " parts, list, ");
        board_print(names[query]);
        board_print(": ");
        print_decimal(board_print, sum / 8);
        board_print(" instructions\n");
      }
    }
  }
  return 0;
}
