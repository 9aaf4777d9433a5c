// Assert and allocation on a hosted system.
#include "gjk_port.h"

#include "../gjk_allocate.h"

#include <stdio.h>
#include <stdlib.h>

void gjk_port_assert_failed(const char *condition, const char *file, int line) {
  fprintf(stderr, "%s:%d: gjk: contract violated: %s\n", file, line, condition);
  abort();
}

void *gjk_port_allocate(size_t bytes) {
  return bytes == 0 ? NULL : malloc(bytes);
}

void gjk_port_release(void *memory) {
  free(memory);
}
