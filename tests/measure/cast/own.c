// This library and the reference in double.
#include <stdio.h>
#include <stdlib.h>

#include "cast.h"
#include "gjk/cast.h"
#include "reference/reference.h"

static void *keep(const cast_case *c) {
  return (void *)(uintptr_t)c;
}

static void forget(void *prepared) {
  (void)prepared;
}

static bool run_gjk(void *prepared, double *fraction) {
  const cast_case *c = prepared;
  const case_shape *a = &c->pair->a, *b = &c->pair->b;
  const gjk_cast_path path = {a->moves ? &a->end.position : NULL, b->moves ? &b->end.position : NULL, 0};
  gjk_cast_result result;
  const gjk_status status = gjk_cast(&c->a->collider, &c->b->collider, &path, &result);
  if (status != GJK_OK) {
    fprintf(stderr, "gjk-casts: %s\n", gjk_status_name(status));
    case_print(stderr, c->pair);
    abort();
  }
  *fraction = result.hit ? (double)result.fraction / GJK_Q30_ONE : 0;
  return result.hit;
}

static bool run_reference(void *prepared, double *fraction) {
  const cast_case *c = prepared;
  const double way[3] = {c->way[0] * CAST_LSB_PER_UNIT, c->way[1] * CAST_LSB_PER_UNIT, c->way[2] * CAST_LSB_PER_UNIT};
  reference_cast_result result;
  reference_cast_posed(c->pair, c->a, c->b, way, 0, &result);
  *fraction = result.fraction;
  return result.hit;
}

static const cast_method gjk = {.name = "gjk", .prepare = keep, .run = run_gjk, .release = forget};
static const cast_method reference = {.name = "double", .prepare = keep, .run = run_reference, .release = forget};

cast_method_list cast_own_methods = {&gjk, &reference, NULL};
