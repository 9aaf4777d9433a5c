// Stands in for src/simplex.c under the queries: any answer that it may give, for every order of the slots at once.
#include "simplex_any.h"

void gjk_simplex_clear(gjk_simplex *s) {
  s->count = 0;
  for (uint8_t i = 0; i < 4; i++) {
    s->order[i] = i;
  }
}

static void any_feature(gjk_simplex *s, unsigned n) {
  for (unsigned i = 0; i < n; i++) {
    check_vertex(&s->slot[i]);
  }
  for (unsigned i = 0; i < n; i++) {
    any_vertex(&s->slot[i]);
  }
}

gjk_step gjk_simplex_add(gjk_simplex *s) {
  const unsigned n = s->count + 1u;
  //@ assert n >= 1 && n <= 4;
  any_feature(s, n);
  if (n >= 2 && any_bool()) {
    return GJK_STEP_NONE;
  }
  if (n >= 3 && any_bool()) {
    s->count = (uint8_t)n;
    return GJK_STEP_ENCLOSING;
  }
  s->count = (uint8_t)any_between(1, n < 3 ? (int32_t)n : 3);
  return GJK_STEP_NEARER;
}

bool gjk_simplex_set(gjk_simplex *s, unsigned n) {
  //@ assert n >= 1 && n <= 3;
  any_feature(s, n);
  s->count = (uint8_t)n;
  return any_bool();
}

bool gjk_simplex_encloses(gjk_simplex *s, unsigned n) {
  //@ assert n >= 1 && n <= 4;
  any_feature(s, n);
  return any_bool();
}

bool gjk_simplex_direction(const gjk_simplex *s, gjk_rounded *out) {
  //@ assert s->count >= 1 && s->count <= 3;
  out->d = any_vec3(ANY_W);
  out->exact = any_bool();
  return any_bool();
}

void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out) {
  //@ assert s->count >= 1 && s->count <= 3;
  out->rank = s->count;
}

static void any_limbs(gjk_limbs *x) {
  for (int i = 0; i < GJK_LIMBS; i++) {
    x->limb[i] = (uint32_t)any_int32();
  }
}

void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_limbs *numerator, gjk_limbs *denominator) {
  //@ assert s->count >= 1 && s->count <= 3;
  any_limbs(numerator);
  any_limbs(denominator);
}

int gjk_compare_distance(const gjk_limbs *numerator, const gjk_limbs *denominator, uint64_t twice) {
  check_size(numerator->limb[0] & 1u, 1);
  check_size(denominator->limb[0] & 1u, 1);
  return (int)any_between(-1, 1);
}

void gjk_simplex_weights(const gjk_simplex *s, bool fine, gjk_share weight[2]) {
  //@ assert s->count >= 2 && s->count <= 3;
  for (int i = 0; i < 2; i++) {
    weight[i].high = any_between(0, INT32_MAX);
    weight[i].low = any_between(0, 0xFFFF);
  }
}
