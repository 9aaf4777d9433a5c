// Hulls to build on a target, and what to count.
#ifndef HULL_BENCH_H
#define HULL_BENCH_H

#include "gjk/hull.h"

#ifndef HULL_BENCH_POINTS  // of boards with little memory fewer
#define HULL_BENCH_POINTS 256
#endif

// Makes count points on a sphere of 2 units, the same ones on every target.
void hull_bench_make(unsigned count);

// Builds their hull. Returns its facets.
uint32_t hull_bench_build(unsigned count);

#endif
