// What the emulated boards share: their face to firmware. Each of mps2, riscv-virt and avr provides it.
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

// The firmware's own; its return value, 0 for success, is how the run ends.
int firmware_main(void);

void board_print(const char *text);

// Says what was violated and ends the run as failed.
void board_assert_failed(const char *condition);

// A counter that runs with the emulator's virtual time, which is the number of executed instructions times a constant
// (QEMU's -icount); tests/measure/target/count.h finds the constant. Read it at least once every 5 million
// instructions. Not on AVR.
uint32_t board_ticks(void);

// The stack, lowest address first, for painting. Not on AVR.
extern uint32_t board_stack_low[], board_stack_high[];

#endif
