// Player 1 as firmware of an emulated Cortex-M3. The link is the first serial port of the board; its input is a constant.
#include "board/board.h"
#include "play.h"
#include "uart.h"

int firmware_main(void) {
  static const play_run runs[] = {DEMO_PLANE_RUNS};
  static const play_link link = {uart_write, uart_read};
  static flat_world world;
  const play_options options = {1, DEMO_PLANE_TICKS, runs, sizeof runs / sizeof runs[0], 0};
  uint32_t ticks;
  uart_start();
  return (int)play_match(&options, &link, &world, &ticks);
}
