// Allocation from a fixed arena: a pointer that moves up, and down again when the newest block is released.
#include "gjk_port.h"

#include "../gjk_allocate.h"

#include <stdint.h>

// In front of each block: where the one before it began, in units of 8 bytes.
typedef union unit {
  uint64_t alignment;
  struct {
    size_t before, size;
  } block;
} unit;

#define UNITS (GJK_ARENA_BYTES / sizeof(unit))

static unit arena[UNITS];
static size_t used, newest;  // units taken; the newest block's header, plus 1, 0 when there is none

void *gjk_port_allocate(size_t bytes) {
  const size_t units = bytes / sizeof(unit) + (bytes % sizeof(unit) != 0);
  if (bytes == 0 || units >= UNITS - used) {
    return NULL;
  }
  arena[used].block.before = newest;
  newest = used + 1;
  used += 1 + units;
  return &arena[newest];
}

void gjk_port_release(void *memory) {
  if (newest != 0 && memory == &arena[newest]) {
    used = newest - 1;
    newest = arena[used].block.before;
  }
}
