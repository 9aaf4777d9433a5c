// Memory without a libc: copying, clearing, alignment.
//
// What copies and clears writes through volatile: otherwise the compiler would turn their loops into calls of memcpy and memset,
// which a freestanding program may not have.
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

// How the target aligns a uint32_t is where it puts one after a byte. On AVR that is anywhere.
typedef struct gjk_word_after_byte {
  unsigned char byte;
  uint32_t word;
} gjk_word_after_byte;

// Is a block aligned for uint32_t?
static inline bool gjk_is_aligned(const void *block) {
  return (uintptr_t)block % offsetof(gjk_word_after_byte, word) == 0;
}

#endif
