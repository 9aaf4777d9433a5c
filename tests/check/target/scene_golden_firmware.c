// Firmware: the hash of the match on an emulated core. Exits with 0 if it is the one in scene_golden.h.
#include "board/board.h"
#include "print.h"
#include "scene_golden.h"

int firmware_main(void) {
#ifdef GOLDEN_FEW  // of few ticks, with rollbacks
  const uint64_t expected = SCENE_GOLDEN_FEW_HASH, hash = scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1);
#else
  const uint64_t expected = SCENE_GOLDEN_HASH, hash = scene_golden_hash(SCENE_GOLDEN_TICKS, 0);
#endif
  print_hex(board_print, hash);
  board_print("\n");
  return hash == expected ? 0 : 1;
}
