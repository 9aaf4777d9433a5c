// Families of random pairs whose queries are counted in instructions, the same pairs on every core.
#ifndef BENCH_H
#define BENCH_H

#include "gjk/gjk.h"

#define BENCH_PAIRS 50

typedef enum bench_query { BENCH_DISTANCE, BENCH_INTERSECT } bench_query;

typedef enum bench_gap {
  BENCH_APART,  // 0.1 to 2 units
  BENCH_CLOSE,  // above 0, to 0.1 units; bounding spheres overlap
  BENCH_OVERLAPPING
} bench_gap;

typedef struct bench_family {
  const char *name;
  bench_query query;
  uint16_t vertices;  // of each hull; 0: boxes
  bench_gap gap;
} bench_family;

extern const bench_family bench_families[];
extern const unsigned bench_family_count;

// Starts a family, then poses its next pair.
void bench_start(void);
void bench_next(const bench_family *family);

// The measured part: one query, cold. Returns its rounds.
unsigned bench_run(const bench_family *family);

#endif
