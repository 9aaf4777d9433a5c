// Families of random pairs whose queries are counted in instructions, the same pairs on every core.
#ifndef BENCH_H
#define BENCH_H

#include "gjk/gjk.h"

#define BENCH_PAIRS 50
#define BENCH_VERTICES 64

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

// Starts a family, then poses its next pair and sets its answer.
void bench_start(void);
void bench_next(const bench_family *family);

// What a solver says: gjk_distance's answer to a pair, or a decision, whose distance is not set.
typedef struct bench_answer {
  bool intersecting;
  gjk_q16 distance;
  unsigned rounds;
} bench_answer;

extern const gjk_collider *const bench_pair[2];
extern bench_answer bench_expected;  // intersecting and distance

// One that answers a query on the pair; run is the measured part.
typedef struct bench_solver {
  const char *name;
  void (*pose)(const gjk_collider *a, const gjk_collider *b);
  void (*run)(bench_query query, bench_answer *out);
} bench_solver;

extern const bench_solver bench_gjk, bench_float, bench_double;

#endif
