// Firmware: the golden hashes of space and of the plane on an emulated core, and with GOLDEN_SCENE, for boards with 50 KB
// of memory, that of a match in a scene. Exits with 0 if they are those of golden.h, plane_golden.h and scene_golden.h.
#include <stdbool.h>

#include "board/board.h"
#include "golden.h"
#include "plane_golden.h"
#include "print.h"
#include "scene_golden.h"

#ifndef GOLDEN_RUN_PAIRS
#define GOLDEN_RUN_PAIRS GOLDEN_PAIRS
#endif

#ifdef GOLDEN_SCENE
static bool scene_is_golden(void) {
  const uint64_t hash = scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1);
  board_print(" ");
  print_hex(board_print, hash);
  return hash == SCENE_GOLDEN_FEW_HASH;
}
#else
static bool scene_is_golden(void) {
  return true;
}
#endif

static bool plane_is_golden(void) {
  const bool few = GOLDEN_RUN_PAIRS != GOLDEN_PAIRS;
  const uint64_t hash = plane_golden_hash(few ? PLANE_GOLDEN_FEW_PAIRS : PLANE_GOLDEN_PAIRS);
  board_print(" ");
  print_hex(board_print, hash);
  return hash == (few ? PLANE_GOLDEN_FEW_HASH : PLANE_GOLDEN_HASH);
}

int firmware_main(void) {
  const uint64_t expected = GOLDEN_RUN_PAIRS == GOLDEN_PAIRS ? GOLDEN_HASH : GOLDEN_FEW_HASH;
  const uint64_t hash = golden_hash(GOLDEN_RUN_PAIRS);
  print_hex(board_print, hash);
  const bool plane = plane_is_golden();
  const bool scene = scene_is_golden();
  board_print("\n");
  return hash == expected && plane && scene ? 0 : 1;
}
