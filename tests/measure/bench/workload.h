// The pairs that are measured: by family, each with its true answer.
#ifndef BENCH_WORKLOAD_H
#define BENCH_WORKLOAD_H

#include <stdint.h>
#include <string.h>

#include "method.h"
#include "random.h"

// A family of pairs. make: sets *placed if the pair is made for a gap.
typedef struct bench_family {
  const char *name, *what;
  unsigned asked;     // BENCH_ASK of each query; with a depth or contacts, all pairs intersect
  unsigned vertices;  // of each shape; 0: they differ
  void (*make)(const struct bench_family *family, random_state *random, struct case_pair *pair, int *placed);
} bench_family;

extern const bench_family bench_families[];
extern const size_t bench_family_count;

// The gaps that pairs of the family "near" are made for, LSB; below 0 they overlap.
extern const int bench_gaps[];
extern const size_t bench_gap_count;

// Depths are sorted into ranges: at most so deep, LSB.
extern const int bench_depths[];
extern const size_t bench_depth_count;

static inline bool bench_asks(const bench_family *family, bench_query query) {
  return (family->asked & BENCH_ASK(query)) != 0;
}

static inline bool bench_boxes_only(const bench_family *family) {
  return strstr(family->name, "boxes") != NULL;
}

static inline bool bench_answers(const bench_method *method, const bench_family *family, bench_query query) {
  return bench_asks(family, query) && (method->answers & BENCH_ASK(query)) != 0 &&
         (!method->boxes_only || bench_boxes_only(family));
}

// Makes count pairs of a family; a seed makes the same ones each time. Each pair has a proven answer (truth.h). A pair
// that cannot be proven ends the program.
// exact: how many of them have a depth that exact integers prove least.
bench_pair *bench_pairs_make(const bench_family *family, uint64_t seed, size_t count, size_t *exact);
void bench_pairs_free(bench_pair *pairs, size_t count);

#endif
