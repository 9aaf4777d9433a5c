// gjk-cost: measures what queries cost and writes CSV, one value a line.
//
// Times are taken in one process, all methods in turn; of each few pairs the least of the repetitions counts. Under
// callgrind it writes a dump for each family, method and mode instead.
#define _POSIX_C_SOURCE 200112L
#include "../measuring.h"
#include "families.h"

static const char usage[] =
    "usage: gjk-cost [option VALUE]...  writes CSV: family,library,method,mode,measure,value\n"
    "  --pairs N        pairs of each family (1000)\n"
    "  --repetitions N  times that all are measured, the least counts (15)\n"
    "  --seed N         of the pairs (1)\n"
    "  --count 1        under callgrind: nothing but its dumps, one of each family,library,method,mode\n";

static const char *const mode_names[COST_MODES] = {"cold", "warm", "posed", "posed warm"};

#define METHODS_MAX 32

typedef struct options {
  unsigned long pairs, repetitions, seed, count;
} options;

// A peer that is not linked has no list.
__attribute__((weak)) extern cost_method_list cost_ccd_methods, cost_bullet_methods, cost_fcl_methods, cost_ode_methods;

static cost_run *choose_nothing(cost_kind a, cost_kind b, cost_query query, cost_mode mode) {
  (void)a;
  (void)b;
  (void)query;
  return mode == COST_COLD ? measuring_nothing : NULL;
}

static void *prepare_nothing(const cost_pair *pair, cost_query query) {
  (void)pair;
  (void)query;
  return malloc(1);
}

static const cost_method nothing = {"nothing", "nothing", choose_nothing, prepare_nothing, free};
static cost_method_list nothing_methods = {&nothing, NULL};

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
  measuring_pairs pairs;  // prepared is shared by the modes of a method
  double sum;             // of the answers
} subject;

typedef struct work {
  const cost_family *family;
  cost_pair *pairs;
  size_t pair_count, count;
  subject subjects[METHODS_MAX * COST_MODES];
} work;

static void **prepare(const cost_method *method, const cost_family *family, const cost_pair *pairs, size_t count) {
  void **prepared = measuring_allocate(count, sizeof *prepared);
  for (size_t i = 0; i < count; i++) {
    prepared[i] = method->prepare(&pairs[i], family->query);
    if (prepared[i] == NULL) {
      exit(2);
    }
  }
  return prepared;
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
        const subject s = {methods[m], (cost_mode)mode, measuring_start(run, prepared, asked->pairs), NAN};
        out->subjects[out->count++] = s;
      }
    }
  }
}

static void work_free(work *w) {
  for (size_t s = 0; s < w->count; s++) {
    void **prepared = w->subjects[s].pairs.prepared;
    if (s + 1 == w->count || prepared != w->subjects[s + 1].pairs.prepared) {
      for (size_t i = 0; i < w->pair_count; i++) {
        w->subjects[s].method->release(prepared[i]);
      }
      free(prepared);
    }
    free(w->subjects[s].pairs.least);
  }
  cost_pairs_free(w->pairs, w->pair_count);
}

static void put(const work *w, const subject *s, const char *measure, double value) {
  printf("%s,%s,%s,%s,%s,%.9g\n", w->family->name, s->method->library, s->method->name, mode_names[s->mode], measure,
         value);
}

static void measure_times(work *works, const options *asked) {
  for (unsigned long r = 0; r < asked->repetitions; r++) {
    for (size_t f = 0; f < cost_family_count; f++) {
      for (size_t s = 0; s < works[f].count; s++) {
        works[f].subjects[s].sum = measuring_time(&works[f].subjects[s].pairs);
      }
    }
  }
  printf("family,library,method,mode,measure,value\n");
  for (size_t f = 0; f < cost_family_count; f++) {
    for (size_t s = 0; s < works[f].count; s++) {
      put(&works[f], &works[f].subjects[s], "sum", works[f].subjects[s].sum);
      put(&works[f], &works[f].subjects[s], "ns", measuring_least(&works[f].subjects[s].pairs));
    }
  }
}

// Callgrind's dump of a subject is named by the first columns of its rows. False: callgrind is not there.
static bool count_subject(const work *w, const subject *s) {
  char label[160];
  snprintf(label, sizeof label, "%s,%s,%s,%s", w->family->name, s->method->library, s->method->name,
           mode_names[s->mode]);
  return measuring_count_pass(&s->pairs, label);
}

static bool count_all(const work *works) {
  for (size_t f = 0; f < cost_family_count; f++) {
    for (size_t s = 0; s < works[f].count; s++) {
      if (!count_subject(&works[f], &works[f].subjects[s])) {
        return false;
      }
    }
  }
  return true;
}

int main(int argc, char **argv) {
  options asked = {1000, 15, 1, 0};
  const measuring_option known[] = {{"--pairs", &asked.pairs},
                                    {"--repetitions", &asked.repetitions},
                                    {"--seed", &asked.seed},
                                    {"--count", &asked.count}};
  if (!measuring_options(argc, argv, known, sizeof known / sizeof known[0]) || asked.pairs == 0 ||
      asked.repetitions == 0) {
    fputs(usage, stderr);
    return 2;
  }
  work *works = measuring_allocate(cost_family_count, sizeof *works);
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
