// Checks what every port must get right: its primitives, against plain C, and its allocation.
#ifndef PORT_TEST_H
#define PORT_TEST_H

#include <stddef.h>
#include <stdint.h>

typedef struct port_counts {
  uint32_t passed, failed;
} port_counts;

// Checks the port that this is compiled with, and prints what fails.
port_counts port_check(void (*print)(const char *text));

// Checks the allocation that this is linked with. arena_bytes: all memory that there is, at most 4096; 0: there is no
// limit.
port_counts port_check_allocation(void (*print)(const char *text), size_t arena_bytes);

// Asks the library for what only an assert refuses: a custom shape that reaches beyond its own bound.
void port_violate_contract(void);

#endif
