// Counts executed instructions on an emulated board: finds how many ticks of the board's counter one takes.
#ifndef COUNT_H
#define COUNT_H

#include <stdbool.h>

#include "board/board.h"

#define COUNT_ITERATIONS 1000u

// The ticks of a loop of COUNT_ITERATIONS iterations with 0, 8 or 24 instructions besides the loop's own.
static inline uint32_t count_loop(unsigned instructions) {
  const uint32_t start = board_ticks();
  for (unsigned i = 0; i < COUNT_ITERATIONS; i++) {
    switch (instructions) {
      case 8: __asm__ volatile(".rept 8\n nop\n .endr\n"); break;
      case 24: __asm__ volatile(".rept 24\n nop\n .endr\n"); break;
      default: __asm__ volatile(""); break;
    }
  }
  return board_ticks() - start;
}

// Ticks per 8 * COUNT_ITERATIONS instructions. 0: three times the instructions do not take three times as long, within
// 1 in 500, so the counter does not count instructions.
static inline uint32_t count_calibrate(void) {
  const uint32_t empty = count_loop(0), few = count_loop(8) - empty, many = count_loop(24) - empty;
  const uint32_t triple = few * 3, error = many > triple ? many - triple : triple - many;
  return error * 500 <= many ? few : 0;
}

static inline uint32_t count_instructions(uint32_t ticks, uint32_t calibration) {
  return (uint32_t)((uint64_t)ticks * (8 * COUNT_ITERATIONS) / calibration);
}

#endif
