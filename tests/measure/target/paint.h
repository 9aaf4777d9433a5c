// Finds how much stack a call uses on an emulated board: paints the free stack before, looks for paint afterwards.
#ifndef PAINT_H
#define PAINT_H

#include "board/board.h"

#define PAINT 0x5AA5C33Cu

// Paints the free stack, except 16 words that this function itself may use. Returns the stack pointer. It is not
// inlined, so that nothing of its caller lies below.
__attribute__((noinline)) static uintptr_t paint_stack(void) {
  volatile uint32_t here = 0;
  const uintptr_t top = (uintptr_t)&here;
  for (volatile uint32_t *p = board_stack_low; (uintptr_t)p < top - 64; p++) {
    *p = PAINT;
  }
  return top;
}

// How many bytes of stack below top were written since it was painted.
static uint32_t painted_depth(uintptr_t top) {
  const volatile uint32_t *p = board_stack_low;
  while ((uintptr_t)p < top && *p == PAINT) {
    p++;
  }
  return (uint32_t)(top - (uintptr_t)p);
}

#endif
