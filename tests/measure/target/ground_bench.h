// The platform game of tests/programs/examples/platform.c, to be measured on a target.
#ifndef GROUND_BENCH_H
#define GROUND_BENCH_H

#include <stdbool.h>
#include <stddef.h>

bool ground_bench_start(void);
bool ground_bench_tick(int time);

// Bytes of RAM that the game takes besides the stack.
size_t ground_bench_bytes(void);

#endif
