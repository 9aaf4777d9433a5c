// What every port must get right: its primitives, against plain C, and its allocation.
#ifndef PORT_TEST_H
#define PORT_TEST_H

#include <stddef.h>
#include <stdint.h>

typedef struct port_counts {
  uint32_t passed, failed;
} port_counts;

// Runs the checks for the port that this is compiled with; prints the failed ones.
port_counts port_check(void (*print)(const char *text));

// The same for the allocation that this is linked with. arena_bytes: all that there is, at most 4096; 0: no end to it.
port_counts port_check_allocation(void (*print)(const char *text), size_t arena_bytes);

// Asks the library for what only an assert refuses: a user's shape that reaches beyond its own bound.
void port_violate_contract(void);

#endif
