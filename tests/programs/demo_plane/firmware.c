// Player 1 as firmware of an emulated Cortex-M3. The link is the first serial port of the board; its input is a constant.
#include "board/board.h"
#include "play.h"

// The registers of a CMSDK APB UART: data; state (bit 0: full, cannot send; bit 1: received); control (bit 0: sends;
// bit 1: receives); divider.
#define UART_DATA (*(volatile uint32_t *)0x40004000)
#define UART_STATE (*(volatile uint32_t *)0x40004004)
#define UART_CONTROL (*(volatile uint32_t *)0x40004008)
#define UART_DIVIDER (*(volatile uint32_t *)0x40004010)

#define SEND_FULL 1u
#define RECEIVED 2u

static void write_text(const char *text) {
  for (; *text != '\0'; text++) {
    while ((UART_STATE & SEND_FULL) != 0) {
    }
    UART_DATA = (uint32_t)*text;
  }
}

// Waits without a limit. Whoever runs the emulator stops it when the other side is gone.
static int read_character(void) {
  while ((UART_STATE & RECEIVED) == 0) {
  }
  return (int)(UART_DATA & 0xFFu);
}

int firmware_main(void) {
  static const play_run runs[] = {DEMO_PLANE_RUNS};
  static const play_link link = {write_text, read_character};
  static flat_world world;
  const play_options options = {1, DEMO_PLANE_TICKS, runs, sizeof runs / sizeof runs[0], 0};
  uint32_t ticks;
  UART_DIVIDER = 16;
  UART_CONTROL = 3;
  return (int)play_match(&options, &link, &world, &ticks);
}
