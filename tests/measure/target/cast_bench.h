// Casts whose instructions are counted.
#ifndef CAST_BENCH_H
#define CAST_BENCH_H

#include "gjk/gjk.h"

#define CAST_WAYS 200

// What B is.
typedef enum cast_mover { CAST_RAY, CAST_SAME, CAST_BALL } cast_mover;

// How the cast ends.
typedef enum cast_end {
  CAST_HITS,    // not at the start
  CAST_FAR,     // a miss by the bounding spheres
  CAST_PASSES,  // another miss, on a way of 6 units
  CAST_STOPS    // a miss on a way of half a unit, too short to arrive
} cast_end;

typedef struct cast_family {
  const char *name;
  uint16_t vertices;  // of each hull; 0: boxes
  cast_mover mover;
  cast_end end;
} cast_family;

extern const cast_family cast_families[];
extern const unsigned cast_family_count;

// Begins the random ways anew.
void cast_bench_start(void);

// Makes the next cast of a family. False: its answer is not proven.
bool cast_bench_next(const cast_family *family);

// Asks. Returns the iterations.
uint32_t cast_bench_run(const cast_family *family);

#endif
