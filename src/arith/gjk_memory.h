// Memory without a libc: copying, clearing, alignment.
//
// Copies and clears write through volatile. Otherwise the compiler would turn their loops into calls of memcpy and
// memset, which a freestanding program may lack.
#ifndef GJK_SRC_MEMORY_H
#define GJK_SRC_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Copies bytes. Pre: the two regions do not overlap.
static inline void gjk_copy(void *to, const void *from, size_t bytes) {
  volatile unsigned char *target = (volatile unsigned char *)to;
  const unsigned char *source = (const unsigned char *)from;
  for (size_t i = 0; i < bytes; i++) {
    target[i] = source[i];
  }
}

static inline void gjk_zero(void *to, size_t bytes) {
  volatile unsigned char *target = (volatile unsigned char *)to;
  for (size_t i = 0; i < bytes; i++) {
    target[i] = 0;
  }
}

// The target's alignment of a uint32_t is the offset at which it places one after a byte. On AVR that is 1.
typedef struct gjk_word_after_byte {
  unsigned char byte;
  uint32_t word;
} gjk_word_after_byte;

// Is a block aligned for uint32_t?
static inline bool gjk_is_aligned(const void *block) {
  return (uintptr_t)block % offsetof(gjk_word_after_byte, word) == 0;
}

#endif
