// The board's face to firmware: text out, exit, a counter of executed instructions. riscv-virt has the same.
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

// Provided by the firmware; its return value becomes the emulator's exit status.
int firmware_main(void);

void board_print(const char *text);
void board_assert_failed(const char *condition);

// Ticks since start-up; differences are good for 5 million instructions. With QEMU's -icount shift=7 the count is
// instructions times a constant that firmware measures on a loop of known length.
uint32_t board_ticks(void);

// The stack, lowest address first, for painting.
extern uint32_t board_stack_low[], board_stack_high[];

#endif
