// Memory, or the end of the program with a message.
#ifndef CONVERT_MEMORY_H
#define CONVERT_MEMORY_H

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

static inline void *solid_need(void *memory) {
  if (memory == NULL) {
    fprintf(stderr, "gjk-convert: out of memory\n");
    exit(2);
  }
  return memory;
}

// Zeroed, for at least one.
static inline void *solid_allocate(size_t count, size_t size) {
  return solid_need(calloc(count + 1, size));
}

static inline void *solid_grow(void *memory, size_t *room, size_t size) {
  *room = *room == 0 ? 16 : 2 * *room;
  return solid_need(realloc(memory, *room * size));
}

#endif
