// Player 1 as firmware of an emulated Cortex-M3. The link is the first serial port of the board.
#include "board/board.h"
#include "peer.h"
#include "uart.h"

int firmware_main(void) {
  static const peer_link link = {uart_write, uart_read};
  const peer_options options = {1, LOCKSTEP_TICKS, 0};
  uart_start();
  return (int)peer_play(&options, &link, board_print);
}
