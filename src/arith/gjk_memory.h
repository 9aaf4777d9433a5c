// Copying and clearing memory without a libc.
#ifndef GJK_SRC_MEMORY_H
#define GJK_SRC_MEMORY_H

#include <stddef.h>

// Both write through volatile, lest the compiler make the loop a call of memcpy or memset, which a freestanding program
// may not have.

// Copies bytes. Pre: the two do not overlap.
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

#endif
