// gjk-decisions PAIRS: how often each method is wrong about whether two polytopes touch, by family. Writes CSV:
// family,method,pairs,wrong. The truth of each pair is proven first.
#include <stdio.h>
#include <stdlib.h>

#include "../bench/measure.h"

static const char *const families[] = {"near", "touching", "stacked", "slivers", "smallest"};

// The methods in the table: each library's own decision.
static bool is_shown(const bench_method *method) {
  static const char *const shown[] = {"gjk cold",  "reference double",     "libccd GJK",
                                      "FCL indep", "Bullet pair detector", "Bullet EPA2"};
  bool found = false;
  for (size_t i = 0; i < sizeof shown / sizeof shown[0]; i++) {
    found = found || strcmp(shown[i], method->name) == 0;
  }
  return found;
}

static const bench_family *find(const char *name) {
  const bench_family *found = NULL;
  for (size_t i = 0; i < bench_family_count; i++) {
    if (strcmp(bench_families[i].name, name) == 0) {
      found = &bench_families[i];
    }
  }
  return found;
}

static void decide(const bench_family *family, const bench_method *method, const bench_pair *pairs, size_t count) {
  bench_subject subject;
  bench_tally tally;
  bench_subject_make(method, pairs, count, &subject);
  bench_measure_errors(&subject, BENCH_INTERSECT, pairs, &tally);
  printf("%s,%s,%lu,%lu\n", family->name, method->name, tally.asked, tally.wrong + tally.undecided);
  bench_subject_free(&subject);
}

int main(int argc, char **argv) {
  const bench_method *methods[BENCH_METHODS_MAX];
  const size_t method_count = bench_methods(methods);
  const size_t count = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
  if (count == 0) {
    fputs("usage: gjk-decisions PAIRS\n", stderr);
    return 2;
  }
  for (size_t f = 0; f < sizeof families / sizeof families[0]; f++) {
    const bench_family *family = find(families[f]);
    size_t exact;
    if (family == NULL) {
      fprintf(stderr, "gjk-decisions: no family %s\n", families[f]);
      return 2;
    }
    bench_pair *pairs = bench_pairs_make(family, 1, count, &exact);
    for (size_t m = 0; m < method_count; m++) {
      if (is_shown(methods[m]) && bench_answers(methods[m], family, BENCH_INTERSECT)) {
        decide(family, methods[m], pairs, count);
      }
    }
    bench_pairs_free(pairs, count);
  }
  return 0;
}
