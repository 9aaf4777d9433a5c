// A box against compounds of crates in rows, with a tree and without, for counts of instructions.
#ifndef PARTS_BENCH_H
#define PARTS_BENCH_H

#include "gjk/gjk.h"

#ifndef PARTS_BENCH_PARTS  // of boards with little memory fewer
#define PARTS_BENCH_PARTS 128
#endif

// What is asked.
typedef enum parts_bench_query {
  PARTS_BENCH_INTERSECT,
  PARTS_BENCH_DISTANCE,
  PARTS_BENCH_CONTACTS,
  PARTS_BENCH_CAST,
  PARTS_BENCH_EACH_DISTANCE,  // no body: each part posed before, asked by gjk_distance
  PARTS_BENCH_QUERIES
} parts_bench_query;

// Makes a compound of count crates, as a tree or as a list.
void parts_bench_make(unsigned count, bool tree);

// Asks at one of 8 places of the box. Returns a number of the answer.
uint32_t parts_bench_ask(parts_bench_query query, unsigned place);

#endif
