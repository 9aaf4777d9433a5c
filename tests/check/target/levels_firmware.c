// Firmware: the hashes of the set of the level that it is built for, as levels_host prints them. Exits with 0 if it refuses just
// the kinds beyond that.
#include "board/board.h"
#include "levels.h"
#include "print.h"

static void print_set(const char *name, const uint64_t hash[LEVELS_QUERIES]) {
  board_print(name);
  for (int i = 0; i < LEVELS_QUERIES; i++) {
    board_print(" ");
    print_hex(board_print, hash[i]);
  }
  board_print("\n");
}

int firmware_main(void) {
  uint64_t hash[LEVELS_QUERIES];
  (void)levels_hash(LEVELS_LEVEL, LEVELS_FEW_PAIRS, hash);
  print_set("space", hash);
  (void)plane_levels_hash(LEVELS_LEVEL, LEVELS_FEW_PAIRS, hash);
  print_set("plane", hash);
  return levels_refused() == levels_beyond(LEVELS_LEVEL) && plane_levels_refused() == plane_levels_beyond(LEVELS_LEVEL)
             ? 0
             : 1;
}
