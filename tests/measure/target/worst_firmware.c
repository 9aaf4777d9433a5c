// Firmware: replays the known cases and prints 'ID|iterations|instructions' for each. With WORST_MEASUREMENTS it
// searches instead for a pair of the family WORST_FAMILY that takes more instructions, and prints it as a case.
#include "worst.h"

#include "count.h"

static unsigned iterations;

static uint32_t instructions(const worst_family *family, const worst_pair *pair) {
  if (!worst_pose(pair)) {
    return 0;
  }
  const uint32_t start = board_ticks();
  iterations = worst_query(family);
  return count_since(start);
}

#ifdef WORST_MEASUREMENTS

static int run(void) {
  static worst_pair most;
  const worst_family *family = &worst_families[WORST_FAMILY];
  worst_search(family, instructions, WORST_SEED, WORST_MEASUREMENTS, &most);
  const uint32_t count = instructions(family, &most);
  worst_print(board_print, family, "instructions", &most);
  board_print("# iterations ");
  print_decimal(board_print, iterations);
  board_print(" instructions ");
  print_decimal(board_print, count);
  board_print("\n");
  return 0;
}

#else

static int run(void) {
  for (unsigned i = 0; i < worst_case_count; i++) {
    const worst_family *family = worst_family_of(worst_cases[i].id);
    const uint32_t count = family == NULL ? 0 : instructions(family, &worst_cases[i].pair);
    if (count == 0) {
      return 1;
    }
    board_print(worst_cases[i].id);
    board_print("|");
    print_decimal(board_print, iterations);
    board_print("|");
    print_decimal(board_print, count);
    board_print("\n");
  }
  return 0;
}

#endif

int firmware_main(void) {
  return count_prepare() ? run() : 1;
}
