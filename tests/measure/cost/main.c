// gjk-cost: measures what queries cost and writes CSV, one value a line.
//
// Times are taken in one process, all methods in turn; of each few pairs the least of the repetitions counts. Under
// callgrind it writes a dump for each family, method and mode instead.
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

static const char usage[] =
    "usage: gjk-cost [option VALUE]...  writes CSV: family,library,method,mode,measure,value\n"
    "  --pairs N        pairs of each family (1000)\n"
    "  --repetitions N  times that all are measured, the least counts (15)\n"
    "  --seed N         of the pairs (1)\n"
    "  --count 1        under callgrind: nothing but its dumps, one of each family,library,method,mode\n";

static const char *const mode_names[COST_MODES] = {"cold", "warm", "posed", "posed warm"};

#define METHODS_MAX 32

// Times are taken of so many pairs at once: in so short a time the machine seldom does something else.
#define TIMED_TOGETHER 50

typedef struct options {
  unsigned long pairs, repetitions, seed, count;
} options;

// A peer that is not linked has no list.
__attribute__((weak)) extern cost_method_list cost_ccd_methods, cost_bullet_methods, cost_fcl_methods, cost_ode_methods;

// What is measured in place of a query, so that the loop can be subtracted.
static double run_nothing(void *prepared) {
  (void)prepared;
  return 0;
}

static cost_run *choose_nothing(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  (void)a;
  (void)b;
  (void)query;
  return mode == COST_COLD ? run_nothing : NULL;
}

static void *prepare_nothing(const cost_pair *pair, cost_query query) {
  (void)pair;
  (void)query;
  return malloc(1);
}

static const cost_method nothing = {"nothing", "nothing", choose_nothing, prepare_nothing, free};
static cost_method_list nothing_methods = {&nothing, NULL};

static bool parse(int argc, char **argv, options *out) {
  const struct {
    const char *name;
    unsigned long *value;
  } known[] = {
      {"--pairs", &out->pairs}, {"--repetitions", &out->repetitions}, {"--seed", &out->seed}, {"--count", &out->count}};
  for (int i = 1; i < argc; i += 2) {
    bool found = false;
    for (size_t k = 0; k < sizeof known / sizeof known[0] && i + 1 < argc; k++) {
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
  return out->pairs > 0 && out->repetitions > 0;
}

static size_t find_methods(const cost_method *out[METHODS_MAX]) {
  const cost_method *const *const lists[] = {nothing_methods,     cost_gjk_methods, cost_ccd_methods,
                                             cost_bullet_methods, cost_fcl_methods, cost_ode_methods};
  size_t count = 0;
  for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
    for (const cost_method *const *m = lists[i]; m != NULL && *m != NULL && count < METHODS_MAX; m++) {
      out[count++] = *m;
    }
  }
  return count;
}

// A method in a mode, prepared for the pairs of a family.
typedef struct subject {
  const cost_method *method;
  cost_mode mode;
  cost_run *run;
  void **prepared;  // shared by the modes of a method
  double sum;       // of the answers
  double *least;    // ns, of each TIMED_TOGETHER pairs
} subject;

typedef struct work {
  const cost_family *family;
  cost_pair *pairs;
  size_t pair_count, count;
  subject subjects[METHODS_MAX * COST_MODES];
} work;

static void **prepare(const cost_method *method, const cost_family *family, const cost_pair *pairs, size_t count) {
  void **prepared = calloc(count, sizeof *prepared);
  for (size_t i = 0; i < count; i++) {
    if (prepared == NULL || (prepared[i] = method->prepare(&pairs[i], family->query)) == NULL) {
      fprintf(stderr, "gjk-cost: out of memory\n");
      exit(2);
    }
  }
  return prepared;
}

static double *make_least(size_t pairs) {
  const size_t count = (pairs + TIMED_TOGETHER - 1) / TIMED_TOGETHER;
  double *least = malloc(count * sizeof *least);
  for (size_t i = 0; i < count; i++) {
    if (least == NULL) {
      fprintf(stderr, "gjk-cost: out of memory\n");
      exit(2);
    }
    least[i] = INFINITY;
  }
  return least;
}

static void work_make(const cost_family *family, const options *asked, work *out) {
  const cost_method *methods[METHODS_MAX];
  const size_t method_count = find_methods(methods);
  out->family = family;
  out->pairs = cost_pairs_make(family, asked->seed, asked->pairs);
  out->pair_count = asked->pairs;
  out->count = 0;
  for (size_t m = 0; m < method_count; m++) {
    void **prepared = NULL;
    for (int mode = 0; mode < COST_MODES; mode++) {
      cost_run *run = methods[m]->choose(family->a, family->b, family->query, (cost_mode)mode);
      if (run != NULL) {
        prepared = prepared != NULL ? prepared : prepare(methods[m], family, out->pairs, asked->pairs);
        const subject s = {methods[m], (cost_mode)mode, run, prepared, NAN, make_least(asked->pairs)};
        out->subjects[out->count++] = s;
      }
    }
  }
}

static void work_free(work *w) {
  for (size_t s = 0; s < w->count; s++) {
    if (s == 0 || w->subjects[s].prepared != w->subjects[s - 1].prepared) {
      for (size_t i = 0; i < w->pair_count; i++) {
        w->subjects[s].method->release(w->subjects[s].prepared[i]);
      }
      free(w->subjects[s].prepared);
    }
  }
  for (size_t s = 0; s < w->count; s++) {
    free(w->subjects[s].least);
  }
  cost_pairs_free(w->pairs, w->pair_count);
}

// Answers all pairs: this is what is counted and timed.
__attribute__((noinline)) static double pass(cost_run *run, void *const *prepared, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; i++) {
    sum += run(prepared[i]);
  }
  return sum;
}

// Two passes, of which the second counts: so a method finds the processor's caches and branch prediction as it leaves
// them itself, not as a method before has left them.
static void measure_time(const work *w, subject *s) {
  s->sum = pass(s->run, s->prepared, w->pair_count);
  for (size_t i = 0; i < w->pair_count; i += TIMED_TOGETHER) {
    const size_t rest = w->pair_count - i, count = rest < TIMED_TOGETHER ? rest : TIMED_TOGETHER;
    struct timespec start, end;
    clock_gettime(CLOCK_MONOTONIC, &start);
    pass(s->run, &s->prepared[i], count);
    clock_gettime(CLOCK_MONOTONIC, &end);
    const double ns = (double)(end.tv_sec - start.tv_sec) * 1e9 + (double)(end.tv_nsec - start.tv_nsec);
    s->least[i / TIMED_TOGETHER] = fmin(s->least[i / TIMED_TOGETHER], ns);
  }
}

static double least_time(const work *w, const subject *s) {
  double sum = 0;
  for (size_t i = 0; i < w->pair_count; i += TIMED_TOGETHER) {
    sum += s->least[i / TIMED_TOGETHER];
  }
  return sum / (double)w->pair_count;
}

static void put(const work *w, const subject *s, const char *measure, double value) {
  printf("%s,%s,%s,%s,%s,%.9g\n", w->family->name, s->method->library, s->method->name, mode_names[s->mode], measure,
         value);
}

static void measure_times(work *works, const options *asked) {
  for (unsigned long r = 0; r < asked->repetitions; r++) {
    for (size_t f = 0; f < cost_family_count; f++) {
      for (size_t s = 0; s < works[f].count; s++) {
        measure_time(&works[f], &works[f].subjects[s]);
      }
    }
  }
  printf("family,library,method,mode,measure,value\n");
  for (size_t f = 0; f < cost_family_count; f++) {
    for (size_t s = 0; s < works[f].count; s++) {
      put(&works[f], &works[f].subjects[s], "sum", works[f].subjects[s].sum);
      put(&works[f], &works[f].subjects[s], "ns", least_time(&works[f], &works[f].subjects[s]));
    }
  }
}

// Callgrind's dump of a subject is named by the first columns of its rows. False: callgrind is not there.
static bool count_subject(const work *w, const subject *s) {
#ifdef HAVE_CALLGRIND
  if (RUNNING_ON_VALGRIND) {
    char label[160];
    snprintf(label, sizeof label, "%s,%s,%s,%s", w->family->name, s->method->library, s->method->name,
             mode_names[s->mode]);
    pass(s->run, s->prepared, w->pair_count);  // what is bound and allocated once is not a query's
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    pass(s->run, s->prepared, w->pair_count);
    CALLGRIND_DUMP_STATS_AT(label);
    CALLGRIND_STOP_INSTRUMENTATION;
    return true;
  }
#endif
  (void)w;
  (void)s;
  return false;
}

static bool count_all(const work *works) {
  for (size_t f = 0; f < cost_family_count; f++) {
    for (size_t s = 0; s < works[f].count; s++) {
      if (!count_subject(&works[f], &works[f].subjects[s])) {
        fprintf(stderr, "gjk-cost: not run by callgrind, or built without its header\n");
        return false;
      }
    }
  }
  return true;
}

int main(int argc, char **argv) {
  options asked = {1000, 15, 1, 0};
  if (!parse(argc, argv, &asked)) {
    fputs(usage, stderr);
    return 2;
  }
  work *works = calloc(cost_family_count, sizeof *works);
  if (works == NULL) {
    return 2;
  }
  for (size_t f = 0; f < cost_family_count; f++) {
    work_make(&cost_families[f], &asked, &works[f]);
  }
  bool done = true;
  if (asked.count != 0) {
    done = count_all(works);
  } else {
    measure_times(works, &asked);
  }
  for (size_t f = 0; f < cost_family_count; f++) {
    work_free(&works[f]);
  }
  free(works);
  if (fflush(stdout) != 0 || ferror(stdout) != 0) {
    fprintf(stderr, "gjk-cost: cannot write\n");
    return 2;
  }
  return done ? 0 : 1;
}
