// Firmware: the hash of the match of the plane on an emulated core. Exits with 0 if it is the one in plane_scene_golden.h.
#include "board/board.h"
#include "plane_scene_golden.h"
#include "print.h"

int firmware_main(void) {
#ifdef GOLDEN_FEW  // of few ticks, with rollbacks
  const uint64_t expected = PLANE_SCENE_GOLDEN_FEW_HASH,
                 hash = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_FEW_TICKS, 1);
#else
  const uint64_t expected = PLANE_SCENE_GOLDEN_HASH, hash = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_TICKS, 0);
#endif
  print_hex(board_print, hash);
  board_print("\n");
  return hash == expected ? 0 : 1;
}
