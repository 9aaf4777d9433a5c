// Copying and clearing memory without a libc.
//
// Both functions write through volatile: otherwise the compiler would turn their loops into calls of memcpy and memset,
// which a freestanding program may not have.
#ifndef GJK_SRC_MEMORY_H
#define GJK_SRC_MEMORY_H

#include <stddef.h>

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

#endif
