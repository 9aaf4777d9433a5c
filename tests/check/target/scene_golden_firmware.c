// Firmware: the hash of the match on an emulated core. Exits with 0 if it is the one in scene_golden.h.
#include "board/board.h"
#include "print.h"
#include "scene_golden.h"

int firmware_main(void) {
  const uint64_t hash = scene_golden_hash(SCENE_GOLDEN_TICKS, 0);
  print_hex(board_print, hash);
  board_print("\n");
  return hash == SCENE_GOLDEN_HASH ? 0 : 1;
}
