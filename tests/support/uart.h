// The first serial port of an emulated MPS2 board, a CMSDK APB UART: the link of firmware to its peer.
#ifndef UART_H
#define UART_H

#include <stdint.h>

// Data; state (bit 0: full, cannot send; bit 1: received); control (bit 0: sends; bit 1: receives); divider.
#define UART_DATA (*(volatile uint32_t *)0x40004000)
#define UART_STATE (*(volatile uint32_t *)0x40004004)
#define UART_CONTROL (*(volatile uint32_t *)0x40004008)
#define UART_DIVIDER (*(volatile uint32_t *)0x40004010)

#define UART_FULL 1u
#define UART_RECEIVED 2u

static inline void uart_start(void) {
  UART_DIVIDER = 16;
  UART_CONTROL = 3;
}

static inline void uart_write(const char *text) {
  for (; *text != '\0'; text++) {
    while ((UART_STATE & UART_FULL) != 0) {
    }
    UART_DATA = (uint32_t)*text;
  }
}

// Waits without a limit. Whoever runs the emulator stops it when the other side is gone.
static inline int uart_read(void) {
  while ((UART_STATE & UART_RECEIVED) == 0) {
  }
  return (int)(UART_DATA & 0xFFu);
}

#endif
