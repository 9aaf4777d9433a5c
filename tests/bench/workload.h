// The pairs that are measured, by family, each with its true answer.
#ifndef BENCH_WORKLOAD_H
#define BENCH_WORKLOAD_H

#include <stdint.h>

#include "../random.h"
#include "method.h"

// One family. make: sets *placed where the pair is made for a gap.
typedef struct bench_family {
  const char *name, *what;
  unsigned vertices;  // of each shape; 0: they differ
  void (*make)(const struct bench_family *family, random_state *random, struct case_pair *pair, int *placed);
} bench_family;

extern const bench_family bench_families[];
extern const size_t bench_family_count;

// The gaps that near pairs are made for, in LSB; below 0 they overlap.
extern const int bench_gaps[];
extern const size_t bench_gap_count;

// Makes count pairs of a family, the same for the same seed. Every one is certified: its answer is the library's own,
// proven in exact integers, and its distance that of the feature that the proof names. A pair that cannot be proven
// ends the program.
bench_pair *bench_pairs_make(const bench_family *family, uint64_t seed, size_t count);
void bench_pairs_free(bench_pair *pairs, size_t count);

#endif
