// Counts executed instructions on an emulated board: finds how many ticks of the board's counter one takes. And prints figures.
#ifndef COUNT_H
#define COUNT_H

#include <stdbool.h>

#include "board/board.h"
#include "print.h"

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

static uint32_t count_calibration;

// Comes before all counts. False, with a message: there can be none.
static inline bool count_prepare(void) {
  count_calibration = count_calibrate();
  if (count_calibration == 0) {
    board_print("the counter does not count instructions\n");
  }
  return count_calibration != 0;
}

// The instructions since board_ticks() was start.
static inline uint32_t count_since(uint32_t start) {
  return (uint32_t)((uint64_t)(board_ticks() - start) * (8 * COUNT_ITERATIONS) / count_calibration);
}

// A function that is counted beside its caller in one file: compiled and called as if it were in another one.
#define COUNTED __attribute__((noipa)) static

// The figures of many calls.
typedef struct count_tally {
  uint32_t calls, sum, worst;
} count_tally;

static inline void count_add(count_tally *t, uint32_t instructions) {
  t->calls++;
  t->sum += instructions;
  t->worst = instructions > t->worst ? instructions : t->worst;
}

static inline void count_field(uint32_t value) {
  board_print("|");
  print_decimal(board_print, value);
}

// Begins a line: NAME|mean|worst
static inline void count_line(const char *name, const count_tally *t) {
  board_print(name);
  count_field(t->sum / t->calls);
  count_field(t->worst);
}

#endif
