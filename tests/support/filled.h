// Was memory written? Tests fill outputs with a byte before a call that must leave them as they are.
#ifndef FILLED_H
#define FILLED_H

#include <stdbool.h>
#include <stddef.h>

#define POISON 0xA5

static inline bool is_filled(const void *memory, size_t size, unsigned char with) {
  const unsigned char *byte = memory;
  for (size_t i = 0; i < size; i++) {
    if (byte[i] != with) {
      return false;
    }
  }
  return true;
}

static inline bool is_untouched(const void *memory, size_t size) {
  return is_filled(memory, size, POISON);
}

#endif
