// Template of a port's allocation, for what you build above the core. Leave it out when nothing allocates.
#include "../gjk_allocate.h"

void *gjk_port_allocate(size_t bytes) {
  (void)bytes;
  return NULL;  // nothing left, which every caller must cope with
}

void gjk_port_release(void *memory) {
  (void)memory;
}
