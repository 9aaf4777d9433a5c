// gjk-casts CASTS: what each method makes of casts whose answer is known, by family. Writes CSV:
// family,method,casts,hits,missed hits,false hits,median error,error of 99 in 100,largest error,ns
//
// Errors are those of fractions of hits that are found, times by how much the gap shrinks: LSB of the gap.
#define _POSIX_C_SOURCE 199309L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "cast.h"

static int ascending(const void *x, const void *y) {
  const double a = *(const double *)x, b = *(const double *)y;
  return (a > b) - (a < b);
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// The least time of a few passes over all casts, ns a cast.
static double cost(const cast_method *method, void **prepared, size_t count) {
  double least = 1e30, fraction;
  for (int pass = 0; pass < 5; pass++) {
    const double start = seconds();
    for (size_t i = 0; i < count; i++) {
      method->run(prepared[i], &fraction);
    }
    const double spent = seconds() - start;
    least = spent < least ? spent : least;
  }
  return 1e9 * least / (double)count;
}

static void measure(const cast_family *family, const cast_method *method, const cast_case *cases, size_t count) {
  void **prepared = malloc(count * sizeof *prepared);
  double *errors = malloc(count * sizeof *errors);
  size_t hits = 0, missed = 0, wrong = 0, found = 0;
  if (prepared == NULL || errors == NULL) {
    abort();
  }
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
  qsort(errors, found, sizeof *errors, ascending);
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
