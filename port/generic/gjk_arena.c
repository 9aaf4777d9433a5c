// Allocation from a fixed arena: its end moves up with each block, and down again when the newest is released.
//
// Blocks released out of order are gone until every younger one is released, too. A block costs one unit besides its
// own size in whole units. Not for use from interrupts or several threads without a lock.
#include "gjk_port.h"

#include "../gjk_allocate.h"

#include <stdbool.h>
#include <stdint.h>

// Aligned for whatever the library stores. In front of each block: where the one before it has its header.
typedef union unit {
  int64_t number;
  void *pointer;
  struct {
    size_t before;
    bool released;
  } header;
} unit;

#define UNITS (GJK_ARENA_BYTES / sizeof(unit))
#define NONE SIZE_MAX

static unit arena[UNITS];
static size_t end, newest = NONE;  // units in use; the newest block's header

void *gjk_port_allocate(size_t bytes) {
  const size_t units = bytes / sizeof(unit) + (bytes % sizeof(unit) != 0);
  if (bytes == 0 || units >= UNITS - end) {
    return NULL;
  }
  arena[end].header.before = newest;
  arena[end].header.released = false;
  newest = end;
  end += 1 + units;
  return &arena[newest + 1];
}

void gjk_port_release(void *memory) {
  if (memory == NULL) {
    return;
  }
  ((unit *)memory - 1)->header.released = true;
  while (newest != NONE && arena[newest].header.released) {
    end = newest;
    newest = arena[newest].header.before;
  }
}
