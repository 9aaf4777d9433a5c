// What the programs that measure on the host have in common: memory, options, times, and counts of callgrind. A program that
// includes this defines _POSIX_C_SOURCE first.
#ifndef MEASURING_H
#define MEASURING_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef __has_include
#if __has_include(<valgrind/callgrind.h>)
#define HAVE_CALLGRIND 1
// Its macros are not ISO C.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#include <valgrind/callgrind.h>
#endif
#endif

// Zeroed memory; without it the program ends.
static inline void *measuring_allocate(size_t count, size_t size) {
  void *memory = calloc(count, size);
  if (memory == NULL) {
    fprintf(stderr, "out of memory\n");
    exit(2);
  }
  return memory;
}

// An option with a number after it.
typedef struct measuring_option {
  const char *name;
  unsigned long *value;
} measuring_option;

// False: a word is neither.
static inline bool measuring_options(int argc, char **argv, const measuring_option *known, size_t count) {
  for (int i = 1; i < argc; i += 2) {
    bool found = false;
    for (size_t k = 0; k < count && i + 1 < argc; k++) {
      if (strcmp(argv[i], known[k].name) == 0) {
        char *end;
        *known[k].value = strtoul(argv[i + 1], &end, 10);
        found = end != argv[i + 1] && *end == '\0';
      }
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

// ns, on the clock of the world or of the process.
static inline double measuring_ns(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

// For qsort, of doubles.
static inline int measuring_ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

// Sorts the values.
static inline double measuring_median(double *values, size_t count) {
  if (count == 0) {
    return NAN;
  }
  qsort(values, count, sizeof *values, measuring_ascending);
  return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

// Callgrind counts from here on. False, with a message: it does not run this program.
static inline bool measuring_count(void) {
#ifdef HAVE_CALLGRIND
  if (RUNNING_ON_VALGRIND) {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    return true;
  }
#endif
  fprintf(stderr, "not run by callgrind, or built without its header\n");
  return false;
}

// Ends the count: it goes to a dump of this name.
static inline void measuring_dump(const char *label) {
#ifdef HAVE_CALLGRIND
  CALLGRIND_DUMP_STATS_AT(label);
  CALLGRIND_STOP_INSTRUMENTATION;
#else
  (void)label;
#endif
}

// A way to answer: gives a number that is the answer about a pair that it has prepared.
typedef double measuring_run(void *prepared);

// Takes the place of an answer, so that the loop can be subtracted.
static inline double measuring_nothing(void *prepared) {
  (void)prepared;
  return 0;
}

// Pairs that a way to answer has prepared, and what answers to them took: ns, the least of each MEASURING_TOGETHER pairs. In
// so short a time the machine seldom does something else.
typedef struct measuring_pairs {
  measuring_run *run;
  void **prepared;
  size_t count;
  double *least;
} measuring_pairs;

#define MEASURING_TOGETHER 50

// prepared  belongs to the caller
static inline measuring_pairs measuring_start(measuring_run *run, void **prepared, size_t count) {
  const measuring_pairs p = {run, prepared, count, measuring_allocate(count, sizeof(double))};
  for (size_t i = 0; i < count; i++) {
    p.least[i] = INFINITY;
  }
  return p;
}

// Answers some pairs: this is what is counted and timed. Returns the sum of the answers.
__attribute__((noinline, unused)) static double measuring_pass(measuring_run *run, void *const *prepared,
                                                               size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; i++) {
    sum += run(prepared[i]);
  }
  return sum;
}

// Two passes, of which the second counts: so a way to answer finds the processor's caches and branch prediction as it leaves
// them itself, not as another one has left them. Returns the sum of the answers.
static inline double measuring_time(const measuring_pairs *p) {
  const double sum = measuring_pass(p->run, p->prepared, p->count);
  for (size_t i = 0; i < p->count; i += MEASURING_TOGETHER) {
    const size_t rest = p->count - i, count = rest < MEASURING_TOGETHER ? rest : MEASURING_TOGETHER;
    const double start = measuring_ns(CLOCK_MONOTONIC);
    measuring_pass(p->run, &p->prepared[i], count);
    p->least[i] = fmin(p->least[i], measuring_ns(CLOCK_MONOTONIC) - start);
  }
  return sum;
}

// ns a pair.
static inline double measuring_least(const measuring_pairs *p) {
  double sum = 0;
  for (size_t i = 0; i < p->count; i += MEASURING_TOGETHER) {
    sum += p->least[i];
  }
  return sum / (double)p->count;
}

// False: callgrind is not there.
static inline bool measuring_count_pass(const measuring_pairs *p, const char *label) {
  measuring_pass(p->run, p->prepared, p->count);  // what is bound and allocated once is not a query's
  if (!measuring_count()) {
    return false;
  }
  measuring_pass(p->run, p->prepared, p->count);
  measuring_dump(label);
  return true;
}

#endif
