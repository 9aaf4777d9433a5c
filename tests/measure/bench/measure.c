// Measures methods on a family of pairs.
#define _POSIX_C_SOURCE 199309L
#include "measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef __has_include
#if __has_include(<valgrind/callgrind.h>)
#define HAVE_CALLGRIND 1
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <valgrind/callgrind.h>
#endif
#endif

static void *out_of_memory(void) {
  fprintf(stderr, "bench: out of memory\n");
  exit(2);
  return NULL;
}

void bench_subject_make(const bench_method *method, const bench_pair *pairs, size_t count, bench_subject *out) {
  memset(out, 0, sizeof *out);
  out->method = method;
  out->count = count;
  out->prepared = calloc(count, sizeof *out->prepared);
  for (size_t i = 0; i < count; i++) {
    if (out->prepared == NULL || (out->prepared[i] = method->prepare(method, &pairs[i])) == NULL) {
      out_of_memory();
    }
  }
}

void bench_subject_free(bench_subject *subject) {
  for (size_t i = 0; i < subject->count; i++) {
    subject->method->release(subject->prepared[i]);
  }
  free(subject->prepared);
  for (int q = 0; q < BENCH_QUERIES; q++) {
    free(subject->times[q]);
  }
}

static bench_answer ask(const bench_subject *subject, bench_query query, size_t pair) {
  bench_answer answer;
  memset(&answer, 0, sizeof answer);
  subject->method->run(subject->method, subject->prepared[pair], query, &answer);
  return answer;
}

// Which of bench_depths' ranges a depth is in, or which of bench_gaps a pair was made for. Returns their count: none.
static size_t find_gap(const bench_pair *pair, bool deep) {
  size_t i = 0;
  if (deep) {
    while (i < bench_depth_count && -pair->distance > bench_depths[i]) {
      i++;
    }
    return i;
  }
  while (i < bench_gap_count && bench_gaps[i] != pair->placed) {
    i++;
  }
  return i;
}

static void count_gap(const bench_pair *pair, bool deep, bool wrong, bool undecided, bench_tally *out) {
  const size_t i = find_gap(pair, deep);
  if (i < (deep ? bench_depth_count : bench_gap_count)) {
    out->gap_asked[i]++;
    out->gap_wrong[i] += wrong;
    out->gap_undecided[i] += undecided;
  }
}

// Bounds are integers, rounded to the nearest if the answer is exact.
static bool is_outside(const bench_answer *answer, double distance) {
  const double slack = answer->lower < answer->upper ? 0 : 0.5;
  return answer->bounded && (distance < answer->lower - slack || distance > answer->upper + slack);
}

static bool is_wrong_decision(const bench_answer *answer, const bench_pair *pair, bench_tally *out) {
  out->undecided += answer->decision == BENCH_UNDECIDED;
  return answer->decision != BENCH_UNDECIDED && (answer->decision == BENCH_TOGETHER) != pair->intersecting;
}

// The shapes overlap. A method without an answer gets the whole depth as its error.
static bool is_wrong_depth(const bench_answer *answer, const bench_pair *pair, double *error, bench_tally *out) {
  const double depth = -pair->distance, found = -answer->distance, slack = fmax(1, depth / 100);
  const bool failed = answer->decision == BENCH_UNDECIDED || !isfinite(found),
             apart = !failed && answer->decision == BENCH_APART, small = !failed && !apart && found < depth - slack,
             large = !failed && !apart && found > depth + slack;
  *error = failed || apart ? depth : fabs(found - depth);
  out->failed += failed;
  out->apart += apart;
  out->small += small;
  out->large += large;
  return failed || apart || small || large;
}

void bench_measure_errors(const bench_subject *subject, bench_query query, const bench_pair *pairs, bench_tally *out) {
  const bool deep = query >= BENCH_DEPTH;
  memset(out, 0, sizeof *out);
  for (size_t i = 0; i < subject->count; i++) {
    const bench_answer answer = ask(subject, query, i);
    double error = isnan(answer.distance) ? INFINITY : fabs(answer.distance - pairs[i].distance);
    const bool wrong =
        deep ? is_wrong_depth(&answer, &pairs[i], &error, out) : is_wrong_decision(&answer, &pairs[i], out);
    out->asked++;
    out->wrong += wrong;
    out->outside += is_outside(&answer, pairs[i].distance);
    out->error_sum += error;
    out->error_most = error > out->error_most ? error : out->error_most;
    out->iterations[answer.iterations < 255 ? answer.iterations : 255]++;
    out->contacts += answer.contacts;
    count_gap(&pairs[i], deep, wrong, answer.decision == BENCH_UNDECIDED, out);
  }
}

static void pass(const bench_subject *subject, bench_query query) {
  bench_answer answer;
  memset(&answer, 0, sizeof answer);
  for (size_t i = 0; i < subject->count; i++) {
    subject->method->run(subject->method, subject->prepared[i], query, &answer);
  }
}

// Makes more room at each power of two.
static void keep_time(bench_subject *subject, bench_query query, double time) {
  const size_t n = subject->repetitions[query]++;
  if ((n & (n - 1)) == 0) {
    double *grown = realloc(subject->times[query], (n == 0 ? 1 : 2 * n) * sizeof *grown);
    subject->times[query] = grown != NULL ? grown : out_of_memory();
  }
  subject->times[query][n] = time;
}

void bench_measure_time(bench_subject *subject, bench_query query, bool keep) {
  struct timespec start, end;
  clock_gettime(CLOCK_MONOTONIC, &start);
  pass(subject, query);
  clock_gettime(CLOCK_MONOTONIC, &end);
  const double ns = (double)(end.tv_sec - start.tv_sec) * 1e9 + (double)(end.tv_nsec - start.tv_nsec);
  if (keep) {
    keep_time(subject, query, ns / (double)subject->count);
  }
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double bench_median_time(bench_subject *subject, bench_query query) {
  const size_t n = subject->repetitions[query];
  double *times = subject->times[query];
  if (n == 0) {
    return NAN;
  }
  qsort(times, n, sizeof *times, compare);
  return (times[(n - 1) / 2] + times[n / 2]) / 2;
}

bool bench_measure_instructions(const bench_subject *subject, bench_query query, const char *label) {
#ifdef HAVE_CALLGRIND
  if (RUNNING_ON_VALGRIND) {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    pass(subject, query);
    CALLGRIND_DUMP_STATS_AT(label);
    CALLGRIND_STOP_INSTRUMENTATION;
    return true;
  }
#endif
  (void)subject;
  (void)query;
  (void)label;
  return false;
}
