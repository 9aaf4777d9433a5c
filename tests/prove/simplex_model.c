// Stands in for src/gjk/gjk_simplex.c under the queries: any answer that it may give, for every order of the slots at
// once.
#include "simplex_any.h"

void gjk_simplex_clear(gjk_simplex *s) {
  s->count = 0;
  for (uint8_t i = 0; i < 4; i++) {
    s->order[i] = i;
  }
}

// Takes what the first n slots hold, and gives them any other vertices in any order. Of three there is a normal.
static void any_feature(gjk_simplex *s, unsigned n) {
  for (unsigned i = 0; i < n; i++) {
    check_vertex(&s->slot[i]);
  }
  for (unsigned i = 0; i < n; i++) {
    any_vertex(&s->slot[i]);
  }
  if (n >= 3) {
    any_normal(&s->normal);
  }
}

gjk_step gjk_simplex_add(gjk_simplex *s) {
  const unsigned n = s->count + 1u;
  //@ assert n >= 1 && n <= 4;
  any_feature(s, n);
  gjk_step step = GJK_STEP_NEARER;
  if (n >= 2 && any_bool()) {
    step = GJK_STEP_NONE;
  } else if (n >= 3 && any_bool()) {
    s->count = (uint8_t)n;
    step = GJK_STEP_ENCLOSING;
  } else {
    s->count = (uint8_t)any_between(1, n < 3 ? (int32_t)n : 3);
  }
  //@ split s->count;
  return step;
}

// Only where the vertices are counts, and the slots keep what they hold; of three the order follows the origin's side.
bool gjk_simplex_set(gjk_simplex *s, unsigned n) {
  //@ assert n >= 1 && n <= 3;
  gjk_simplex_clear(s);
  for (unsigned i = 0; i < n; i++) {
    check_vec3(&s->slot[i].w, ANY_W);
  }
  s->count = (uint8_t)n;
  if (n == 3) {
    any_normal(&s->normal);
    if (any_bool()) {
      s->order[0] = 1;
      s->order[1] = 0;
    }
  }
  return any_bool();
}

bool gjk_simplex_widen(gjk_simplex *s) {
  //@ assert s->count == 2;
  any_feature(s, 3);
  const bool widened = any_bool();
  s->count = widened ? 3 : 2;
  return widened;
}

unsigned gjk_simplex_beyond(const gjk_simplex *s) {
  for (int i = 0; i < 3; i++) {
    check_vec3(&s->slot[i].w, ANY_W);
  }
  return (unsigned)any_between(0, 3);
}

bool gjk_simplex_encloses(gjk_simplex *s, unsigned n) {
  //@ assert n >= 1 && n <= 4;
  if (n < 4) {
    return gjk_simplex_set(s, n) && any_bool();
  }
  for (unsigned i = 0; i < 4; i++) {
    check_vec3(&s->slot[i].w, ANY_W);
  }
  return any_bool();
}

bool gjk_simplex_direction(const gjk_simplex *s, gjk_search_direction *out) {
  //@ assert s->count >= 1 && s->count <= 3;
  out->d = any_direction(s->count);
  out->exact = any_bool();
  return any_bool();
}

void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out) {
  //@ assert s->count >= 1 && s->count <= 3;
  out->a = &s->slot[s->order[0]].w;
  out->b = &s->slot[s->order[1]].w;
  out->n = &s->normal;
  if (s->count == 2) {
    out->ta = Frama_C_long_long_interval(1, ANY_TOWARD);
    out->tb = Frama_C_long_long_interval(1, ANY_TOWARD);
  }
  out->spanning = s->count;
  out->opposite = false;
  out->level = NULL;
}

static void any_limbs(gjk_u192 *x) {
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    x->limb[i] = (uint32_t)any_int32();
  }
}

void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_u192 *numerator, gjk_u192 *denominator) {
  //@ assert s->count >= 1 && s->count <= 3;
  any_limbs(numerator);
  any_limbs(denominator);
}

int gjk_compare_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t twice) {
  check_size(numerator->limb[0] & 1u, 1);
  check_size(denominator->limb[0] & 1u, 1);
  return (int)any_between(-1, 1);
}

int64_t gjk_round_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, int64_t low, int64_t high,
                           unsigned shift, gjk_round_to to) {
  check_size(numerator->limb[0] & 1u, 1);
  check_size(denominator->limb[0] & 1u, 1);
  check_size(low, INT64_C(1) << 34);
  check_size(high, INT64_C(1) << 34);
  check_size(to, GJK_ROUND_DOWN);
  //@ assert shift <= 29;
  const int64_t rounded = Frama_C_long_long_interval(0, INT64_C(1) << 34);
  return rounded >= low && rounded <= high ? rounded : low;
}

int32_t gjk_simplex_along_axis(const gjk_simplex *s) {
  //@ assert s->count >= 1 && s->count <= 3;
  return any_between(-1, ANY_W);
}

// Not negative, the sum below 2^126.
void gjk_simplex_parts(const gjk_simplex *s, gjk_u128 part[3]) {
  //@ assert s->count >= 2 && s->count <= 3;
  for (int i = 0; i < 3; i++) {
    part[i].high = (uint64_t)Frama_C_long_long_interval(0, INT64_C(1) << 62);
    part[i].low = (uint64_t)any_int32() << 32 | (uint32_t)any_int32();
  }
}

void gjk_simplex_weights(const gjk_simplex *s, bool fine, gjk_barycentric weight[2]) {
  //@ assert s->count >= 2 && s->count <= 3;
  for (int i = 0; i < 2; i++) {
    weight[i].high = any_between(0, INT32_MAX);
    weight[i].low = any_between(0, 0xFFFF);
  }
}
