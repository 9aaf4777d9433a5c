// Firmware: the hash of the match of the plane on an emulated core. Exits with 0 if it is the one in plane_scene_golden.h.
#include "board/board.h"
#include "plane_scene_golden.h"
#include "print.h"

int firmware_main(void) {
  const uint64_t hash = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_TICKS, 0);
  print_hex(board_print, hash);
  board_print("\n");
  return hash == PLANE_SCENE_GOLDEN_HASH ? 0 : 1;
}
