// gjk-casts CASTS: what each method makes of casts whose answer is known, by family. Writes CSV:
// family,method,casts,hits,missed hits,false hits,median error,error of 99 in 100,largest error,ns
//
// Errors are those of fractions of hits that are found, times by how much the gap shrinks: LSB of the gap.
#define _POSIX_C_SOURCE 199309L
#include "../measuring.h"
#include "cast.h"

// The least time of a few passes over all casts, ns a cast.
static double cost(const cast_method *method, void **prepared, size_t count) {
  double least = INFINITY, fraction;
  for (int pass = 0; pass < 5; pass++) {
    const double start = measuring_ns(CLOCK_MONOTONIC);
    for (size_t i = 0; i < count; i++) {
      method->run(prepared[i], &fraction);
    }
    const double spent = measuring_ns(CLOCK_MONOTONIC) - start;
    least = spent < least ? spent : least;
  }
  return least / (double)count;
}

static void measure(const cast_family *family, const cast_method *method, const cast_case *cases, size_t count) {
  void **prepared = measuring_allocate(count, sizeof *prepared);
  double *errors = measuring_allocate(count, sizeof *errors);
  size_t hits = 0, missed = 0, wrong = 0, found = 0;
  for (size_t i = 0; i < count; i++) {
    const cast_case *c = &cases[i];
    double fraction = 0;
    prepared[i] = method->prepare(c);
    const bool hit = method->run(prepared[i], &fraction);
    hits += c->hit;
    missed += c->hit && !hit;
    wrong += !c->hit && hit;
    if (c->hit && hit) {
      errors[found++] = fabs(fraction - c->fraction) * c->rate;
    }
  }
  qsort(errors, found, sizeof *errors, measuring_ascending);
  printf("%s,%s,%zu,%zu,%zu,%zu,%.3g,%.3g,%.3g,%.0f\n", family->name, method->name, count, hits, missed, wrong,
         found > 0 ? errors[found / 2] : 0, found > 0 ? errors[found * 99 / 100] : 0, found > 0 ? errors[found - 1] : 0,
         cost(method, prepared, count));
  for (size_t i = 0; i < count; i++) {
    method->release(prepared[i]);
  }
  free(prepared);
  free(errors);
}

static void measure_list(const cast_family *family, cast_method_list methods, const cast_case *cases, size_t count) {
  for (size_t m = 0; methods[m] != NULL; m++) {
    measure(family, methods[m], cases, count);
    fflush(stdout);
  }
}

int main(int argc, char **argv) {
  const size_t count = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
  if (count == 0) {
    fputs("usage: gjk-casts CASTS\n", stderr);
    return 2;
  }
  for (size_t f = 0; f < cast_family_count; f++) {
    cast_case *cases = cast_make(&cast_families[f], count);
    measure_list(&cast_families[f], cast_own_methods, cases, count);
#ifdef CAST_BULLET
    measure_list(&cast_families[f], cast_bullet_methods, cases, count);
#endif
#ifdef CAST_FCL
    measure_list(&cast_families[f], cast_fcl_methods, cases, count);
#endif
    cast_release(cases, count);
  }
  return 0;
}
