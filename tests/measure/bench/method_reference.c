// The reference in double and in float, on the library's integers, relative to the centre of A.
#include <stdlib.h>

#include "method.h"
#include "reference/reference.h"

typedef void reference_function(const case_pair *pair, const case_collider *a, const case_collider *b,
                                reference_result *out);

static void *prepare(const bench_method *method, const bench_pair *pair) {
  bench_pair *p = malloc(sizeof *p);
  (void)method;
  if (p != NULL) {
    *p = *pair;
  }
  return p;
}

#define ANSWERS (BENCH_ASK(BENCH_DISTANCE) | BENCH_ASK(BENCH_INTERSECT) | BENCH_ASK(BENCH_DEPTH))

// A yes or no costs as much as a distance.
static void run(reference_function *query, const bench_pair *p, bench_answer *out) {
  reference_result result;
  query(p->shapes, p->a, p->b, &result);
  out->decision = result.intersecting ? BENCH_TOGETHER : BENCH_APART;
  out->distance = result.distance;
  out->iterations = (unsigned)result.iterations;
}

static void run_double(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  (void)method;
  run(query == BENCH_DEPTH ? reference_signed_posed : reference_query_posed, prepared, out);
}

static void run_float(const bench_method *method, void *prepared, bench_query query, bench_answer *out) {
  (void)method;
  run(query == BENCH_DEPTH ? reference_float_signed_posed : reference_float_query_posed, prepared, out);
}

static const bench_method in_double = {.name = "reference double",
                                       .series = "reference double",
                                       .answers = ANSWERS,
                                       .prepare = prepare,
                                       .run = run_double,
                                       .release = free};
static const bench_method in_float = {.name = "reference float",
                                      .series = "reference float",
                                      .answers = ANSWERS,
                                      .prepare = prepare,
                                      .run = run_float,
                                      .release = free};

bench_method_list bench_reference_methods = {&in_double, &in_float, NULL};
