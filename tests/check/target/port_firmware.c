// Firmware: checks the port on an emulated core. Its last step violates a contract, so a good run ends with that
// failure.
#include "board/board.h"
#include "generic/gjk_port.h"
#include "port.h"
#include "print.h"

int firmware_main(void) {
  const port_counts primitives = port_check(board_print);
  const port_counts allocation = port_check_allocation(board_print, GJK_ARENA_BYTES);
  print_decimal(board_print, primitives.passed + allocation.passed);
  board_print(" passed, ");
  print_decimal(board_print, primitives.failed + allocation.failed);
  board_print(" failed\n");
  port_violate_contract();
  board_print("the contract was violated without a word\n");
  return 0;
}
