// Host program: checks the port; with an argument, violates a contract.
#include "port.h"

#include <stdio.h>

#ifndef PORT_ARENA_BYTES
#define PORT_ARENA_BYTES 0
#endif

static void print(const char *text) {
  fputs(text, stdout);
}

int main(int argc, char **argv) {
  (void)argv;
  if (argc > 1) {
    port_violate_contract();
    return 0;
  }
  const port_counts primitives = port_check(print), allocation = port_check_allocation(print, PORT_ARENA_BYTES);
  printf("%lu passed, %lu failed\n", (unsigned long)(primitives.passed + allocation.passed),
         (unsigned long)(primitives.failed + allocation.failed));
  return primitives.failed + allocation.failed != 0;
}
