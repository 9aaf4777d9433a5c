// Firmware: the golden hash on an emulated core. Exits with 0 when it is the one in golden.h.
#include "board/board.h"
#include "golden.h"
#include "print.h"

#ifndef GOLDEN_RUN_PAIRS
#define GOLDEN_RUN_PAIRS GOLDEN_PAIRS
#endif

int firmware_main(void) {
  const uint64_t expected = GOLDEN_RUN_PAIRS == GOLDEN_PAIRS ? GOLDEN_HASH : GOLDEN_FEW_HASH;
  const uint64_t hash = golden_hash(GOLDEN_RUN_PAIRS);
  print_hex(board_print, hash);
  board_print("\n");
  return hash == expected ? 0 : 1;
}
