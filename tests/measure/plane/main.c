// gjk-plane: decisions and costs in the plane, this library beside others. Writes CSV.
//
//   gjk-plane decisions PAIRS          family,method,pairs,wrong; the truth of each pair is proven first
//   gjk-plane costs PAIRS REPETITIONS  family,method,measure,value: the sum of the answers, and ns a query, all methods
//                                      in turn in one process, of each few pairs the least of the repetitions
//   gjk-plane count PAIRS              under callgrind: a dump for each family and method
#define _POSIX_C_SOURCE 200112L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "families.h"

#ifdef __has_include
#if __has_include(<valgrind/callgrind.h>)
#define HAVE_CALLGRIND 1
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <valgrind/callgrind.h>
#endif
#endif

#define METHODS_MAX 16
#define SEED 1

// Times are taken of so many pairs at once: in so short a time the machine seldom does something else.
#define TIMED_TOGETHER 50

// A peer that is not linked has no list.
__attribute__((weak)) extern plane_method_list plane_box2d_methods, plane_chipmunk_methods;

// A method, prepared for the pairs of a family.
typedef struct subject {
  const plane_method *method;
  plane_run *run;
  void **prepared;
  double *least;  // ns, of each TIMED_TOGETHER pairs
} subject;

typedef struct work {
  const plane_family *family;
  plane_pair *pairs;
  size_t pair_count, count;
  subject subjects[METHODS_MAX];
} work;

static void *allocate(size_t count, size_t size) {
  void *memory = calloc(count, size);
  if (memory == NULL) {
    fprintf(stderr, "gjk-plane: out of memory\n");
    exit(2);
  }
  return memory;
}

// What is measured in place of a query, so that the loop can be subtracted.
static double run_nothing(void *prepared) {
  (void)prepared;
  return 0;
}

static plane_run *choose_nothing(plane_query query) {
  (void)query;
  return run_nothing;
}

static void *prepare_nothing(const plane_pair *pair) {
  (void)pair;
  return malloc(1);
}

static const plane_method nothing = {"nothing", choose_nothing, prepare_nothing, free};
static plane_method_list nothing_methods = {&nothing, NULL};

static void add_method(const plane_method *method, work *out) {
  subject *s = &out->subjects[out->count];
  const bool moved = method == plane_own_methods[1];
  if ((moved && !out->family->moved) ||
      (out->family->own && !moved && method != &nothing && method != plane_own_methods[0])) {
    return;
  }
  s->method = method;
  s->run = method->choose(out->family->query);
  if (s->run == NULL || out->count == METHODS_MAX) {
    return;
  }
  s->prepared = allocate(out->pair_count, sizeof *s->prepared);
  s->least = allocate(out->pair_count, sizeof *s->least);
  for (size_t i = 0; i < out->pair_count; i++) {
    s->least[i] = INFINITY;
    s->prepared[i] = method->prepare(&out->pairs[i]);
    if (s->prepared[i] == NULL) {
      exit(2);
    }
  }
  out->count++;
}

static void work_make(const plane_family *family, size_t pairs, work *out) {
  const plane_method *const *lists[] = {nothing_methods, plane_own_methods, plane_box2d_methods,
                                        plane_chipmunk_methods};
  out->family = family;
  out->pairs = plane_pairs_make(family, SEED, pairs);
  out->pair_count = pairs;
  out->count = 0;
  for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
    for (const plane_method *const *m = lists[i]; m != NULL && *m != NULL; m++) {
      add_method(*m, out);
    }
  }
}

static void work_free(work *w) {
  for (size_t s = 0; s < w->count; s++) {
    for (size_t i = 0; i < w->pair_count; i++) {
      w->subjects[s].method->release(w->subjects[s].prepared[i]);
    }
    free(w->subjects[s].prepared);
    free(w->subjects[s].least);
  }
  plane_pairs_free(w->pairs, w->pair_count);
}

static void decide(const work *w) {
  for (size_t s = 0; s < w->count; s++) {
    size_t wrong = 0;
    for (size_t i = 0; i < w->pair_count; i++) {
      wrong += (w->subjects[s].run(w->subjects[s].prepared[i]) != 0) != w->pairs[i].intersecting;
    }
    if (w->subjects[s].method != &nothing) {
      printf("%s,%s,%zu,%zu\n", w->family->name, w->subjects[s].method->name, w->pair_count, wrong);
    }
  }
}

// Answers some pairs: this is what is counted and timed.
__attribute__((noinline)) static double pass(plane_run *run, void *const *prepared, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; i++) {
    sum += run(prepared[i]);
  }
  return sum;
}

static void measure_time(const work *w, subject *s) {
  (void)pass(s->run, s->prepared, w->pair_count);
  for (size_t i = 0; i < w->pair_count; i += TIMED_TOGETHER) {
    const size_t rest = w->pair_count - i, count = rest < TIMED_TOGETHER ? rest : TIMED_TOGETHER;
    struct timespec start, end;
    clock_gettime(CLOCK_MONOTONIC, &start);
    (void)pass(s->run, &s->prepared[i], count);
    clock_gettime(CLOCK_MONOTONIC, &end);
    const double ns = (double)(end.tv_sec - start.tv_sec) * 1e9 + (double)(end.tv_nsec - start.tv_nsec);
    s->least[i / TIMED_TOGETHER] = fmin(s->least[i / TIMED_TOGETHER], ns);
  }
}

static void put_costs(const work *w) {
  for (size_t k = 0; k < w->count; k++) {
    const subject *s = &w->subjects[k];
    double ns = 0;
    for (size_t i = 0; i < w->pair_count; i += TIMED_TOGETHER) {
      ns += s->least[i / TIMED_TOGETHER];
    }
    printf("%s,%s,sum,%.9g\n", w->family->name, s->method->name, pass(s->run, s->prepared, w->pair_count));
    printf("%s,%s,ns,%.9g\n", w->family->name, s->method->name, ns / (double)w->pair_count);
  }
}

// False: callgrind is not there.
static bool count_work(const work *w) {
#ifdef HAVE_CALLGRIND
  if (RUNNING_ON_VALGRIND) {
    for (size_t k = 0; k < w->count; k++) {
      const subject *s = &w->subjects[k];
      char label[160];
      snprintf(label, sizeof label, "%s,%s", w->family->name, s->method->name);
      (void)pass(s->run, s->prepared, w->pair_count);  // what is bound and allocated once is not a query's
      CALLGRIND_START_INSTRUMENTATION;
      CALLGRIND_ZERO_STATS;
      (void)pass(s->run, s->prepared, w->pair_count);
      CALLGRIND_DUMP_STATS_AT(label);
      CALLGRIND_STOP_INSTRUMENTATION;
    }
    return true;
  }
#endif
  (void)w;
  fprintf(stderr, "gjk-plane: not run by callgrind, or built without its header\n");
  return false;
}

int main(int argc, char **argv) {
  const bool decisions = argc == 3 && strcmp(argv[1], "decisions") == 0;
  const bool costs = argc == 4 && strcmp(argv[1], "costs") == 0;
  const bool count = argc == 3 && strcmp(argv[1], "count") == 0;
  const size_t pairs = argc > 2 ? strtoul(argv[2], NULL, 10) : 0;
  const unsigned long repetitions = argc > 3 ? strtoul(argv[3], NULL, 10) : 0;
  const plane_family *families = decisions ? plane_decision_families : plane_cost_families;
  const size_t family_count = decisions ? plane_decision_family_count : plane_cost_family_count;
  bool done = true;
  if ((!decisions && !costs && !count) || pairs == 0) {
    fputs("usage: gjk-plane decisions PAIRS | costs PAIRS REPETITIONS | count PAIRS\n", stderr);
    return 2;
  }
  for (size_t f = 0; f < family_count; f++) {
    work w;
    work_make(&families[f], pairs, &w);
    for (unsigned long r = 0; r < repetitions; r++) {
      for (size_t s = 0; s < w.count; s++) {
        measure_time(&w, &w.subjects[s]);
      }
    }
    if (decisions) {
      decide(&w);
    } else if (costs) {
      put_costs(&w);
    } else {
      done = count_work(&w) && done;
    }
    work_free(&w);
  }
  return done ? 0 : 1;
}
