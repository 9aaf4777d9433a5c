// Player 1 as firmware of an emulated Cortex-M3. The link is the first serial port of the board.
#include "board/board.h"
#include "peer.h"

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
  static const peer_link link = {write_text, read_character};
  const peer_options options = {1, LOCKSTEP_TICKS, 0};
  UART_DIVIDER = 16;
  UART_CONTROL = 3;
  return (int)peer_play(&options, &link, board_print);
}
