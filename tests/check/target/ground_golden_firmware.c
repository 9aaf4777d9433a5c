// Firmware: the hash of ground on an emulated core. Exits with 0 if it is the one in ground_golden.h.
#include "board/board.h"
#include "ground_golden.h"
#include "print.h"

int firmware_main(void) {
  const uint64_t hash = ground_golden_hash();
  print_hex(board_print, hash);
  board_print("\n");
  return hash == GROUND_GOLDEN_HASH ? 0 : 1;
}
