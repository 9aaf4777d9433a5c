// gjk-plane: decisions and costs in the plane, this library beside others. Writes CSV.
//
//   gjk-plane decisions PAIRS          family,method,pairs,wrong; the truth of each pair is proven first
//   gjk-plane costs PAIRS REPETITIONS  family,method,measure,value: the sum of the answers, and ns a query, all methods
//                                      in turn in one process, of each few pairs the least of the repetitions
//   gjk-plane count PAIRS              under callgrind: a dump for each family and method
#define _POSIX_C_SOURCE 200112L
#include "../measuring.h"
#include "families.h"

#define METHODS_MAX 16
#define SEED 1

// A peer that is not linked has no list.
__attribute__((weak)) extern plane_method_list plane_box2d_methods, plane_chipmunk_methods;

// A method, prepared for the pairs of a family.
typedef struct subject {
  const plane_method *method;
  measuring_pairs pairs;
} subject;

typedef struct work {
  const plane_family *family;
  plane_pair *pairs;
  size_t pair_count, count;
  subject subjects[METHODS_MAX];
} work;

static plane_run *choose_nothing(plane_query query) {
  (void)query;
  return measuring_nothing;
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
  plane_run *run = method->choose(out->family->query);
  if (run == NULL || out->count == METHODS_MAX) {
    return;
  }
  s->method = method;
  s->pairs = measuring_start(run, measuring_allocate(out->pair_count, sizeof(void *)), out->pair_count);
  for (size_t i = 0; i < out->pair_count; i++) {
    s->pairs.prepared[i] = method->prepare(&out->pairs[i]);
    if (s->pairs.prepared[i] == NULL) {
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
      w->subjects[s].method->release(w->subjects[s].pairs.prepared[i]);
    }
    free(w->subjects[s].pairs.prepared);
    free(w->subjects[s].pairs.least);
  }
  plane_pairs_free(w->pairs, w->pair_count);
}

static void decide(const work *w) {
  for (size_t s = 0; s < w->count; s++) {
    const measuring_pairs *p = &w->subjects[s].pairs;
    size_t wrong = 0;
    for (size_t i = 0; i < w->pair_count; i++) {
      wrong += (p->run(p->prepared[i]) != 0) != w->pairs[i].intersecting;
    }
    if (w->subjects[s].method != &nothing) {
      printf("%s,%s,%zu,%zu\n", w->family->name, w->subjects[s].method->name, w->pair_count, wrong);
    }
  }
}

static void put_costs(const work *w) {
  for (size_t k = 0; k < w->count; k++) {
    const subject *s = &w->subjects[k];
    const double sum = measuring_pass(s->pairs.run, s->pairs.prepared, w->pair_count);
    printf("%s,%s,sum,%.9g\n", w->family->name, s->method->name, sum);
    printf("%s,%s,ns,%.9g\n", w->family->name, s->method->name, measuring_least(&s->pairs));
  }
}

// False: callgrind is not there.
static bool count_work(const work *w) {
  bool fine = true;
  for (size_t k = 0; k < w->count && fine; k++) {
    char label[160];
    snprintf(label, sizeof label, "%s,%s", w->family->name, w->subjects[k].method->name);
    fine = measuring_count_pass(&w->subjects[k].pairs, label);
  }
  return fine;
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
        (void)measuring_time(&w.subjects[s].pairs);
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
