// Measures methods on a family of pairs: errors once, times again and again, instructions under callgrind.
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "workload.h"

// The figures of a method at a query, over all pairs of a family.
typedef struct bench_tally {
  unsigned long asked, wrong, undecided;
  unsigned long failed, apart, small, large;  // what is wrong with depths: no answer, none, more than 1 LSB and 1 % off
  unsigned long contacts;
  unsigned long outside;         // true distances outside of the bounds that were called proven
  double error_sum, error_most;  // LSB
  unsigned long iterations[256];
  unsigned long gap_asked[32], gap_wrong[32], gap_undecided[32];  // by the index in bench_gaps, or bench_depths
} bench_tally;

// A method, prepared for the pairs of a family.
typedef struct bench_subject {
  const bench_method *method;
  void **prepared;
  size_t count;
  double *times[BENCH_QUERIES];  // ns per query, of each repetition
  size_t repetitions[BENCH_QUERIES];
} bench_subject;

void bench_subject_make(const bench_method *method, const bench_pair *pairs, size_t count, bench_subject *out);
void bench_subject_free(bench_subject *subject);

void bench_measure_errors(const bench_subject *subject, bench_query query, const bench_pair *pairs, bench_tally *out);

// Answers all pairs once and measures the time. keep: adds it to times.
void bench_measure_time(bench_subject *subject, bench_query query, bool keep);
double bench_median_time(bench_subject *subject, bench_query query);

// Answers all pairs once while callgrind counts; the counts go to a dump of callgrind named label. False: callgrind is
// not there.
bool bench_measure_instructions(const bench_subject *subject, bench_query query, const char *label);

#endif
