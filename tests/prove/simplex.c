// Every function of src/gjk/gjk_simplex.h on any simplex, for every order of its slots: each leaves such a simplex
// behind, as tests/prove/simplex_model.c has it, and reads nothing of a slot that is not in use.
#include "simplex_any.h"

// What src/gjk/gjk_simplex.c may read of a feature: products of slots in use, positive between the two of an edge.
static void any_feature(gjk_simplex *s) {
  for (unsigned i = 0; i < s->count; i++) {
    const unsigned at = s->order[i];
    any_vertex(&s->slot[at]);
    for (unsigned k = 0; k < s->count; k++) {
      s->toward[at][s->order[k]] = any_long(ANY_TOWARD);
    }
    s->toward[at][at] = Frama_C_long_long_interval(0, ANY_SQUARE);
  }
  if (s->count == 2) {
    s->toward[s->order[0]][s->order[1]] = Frama_C_long_long_interval(1, ANY_TOWARD);
    s->toward[s->order[1]][s->order[0]] = Frama_C_long_long_interval(1, ANY_TOWARD);
  }
  if (s->count == 3) {
    any_normal(&s->normal);
  }
}

static void check_feature(const gjk_simplex *s, unsigned most) {
  unsigned seen = 0;
  check_size(s->count, (int64_t)most);
  for (unsigned i = 0; i < 4; i++) {
    check_size(s->order[i], 3);
    seen |= 1u << s->order[i];
    if (i < s->count) {
      check_vertex(&s->slot[s->order[i]]);
    }
  }
  //@ assert seen == 15;
  for (unsigned i = 0; i < s->count && s->count < 4; i++) {
    const unsigned at = s->order[i];
    for (unsigned k = 0; k < s->count; k++) {
      check_size(s->toward[at][s->order[k]], i == k ? ANY_SQUARE : ANY_TOWARD);
    }
  }
  if (s->count == 3) {
    check_size(s->normal.x, ANY_NORMAL);
    check_size(s->normal.y, ANY_NORMAL);
    check_size(s->normal.z, ANY_NORMAL);
  }
}

// The functions that look at a feature.
static void look(const gjk_simplex *s) {
  gjk_search_direction rounded;
  gjk_direction direction;
  gjk_u192 numerator, denominator;
  gjk_barycentric weight[2];
  const gjk_vec3 v = any_vec3(2 * ANY_OFFSET);
  (void)gjk_simplex_direction(s, &rounded);
  check_vec3(&rounded.d, ANY_W);
  gjk_simplex_exact_direction(s, &direction);
  (void)gjk_direction_sign(&direction, &v);
  gjk_simplex_squared_distance(s, &numerator, &denominator);
  (void)gjk_compare_distance(&numerator, &denominator, (uint64_t)any_long(INT64_MAX));
  const int64_t low = any_between(0, INT32_MAX), high = low + any_between(0, 128);
  const int64_t distance = gjk_round_distance(&numerator, &denominator, low, high, (unsigned)any_between(0, 29),
                                              (gjk_round_to)any_between(GJK_ROUND_UP, GJK_ROUND_DOWN));
  check_size(distance, INT64_C(1) << 32);
  if (s->count > 1) {
    gjk_simplex_weights(s, any_bool(), weight);
    check_size(weight[0].high, INT32_MAX);
    check_size(weight[1].high, INT32_MAX);
    check_size(weight[0].low, 0xFFFF);
    check_size(weight[1].low, 0xFFFF);
  }
}

// The simplex with its slots ordered i, j, k.
static void run(unsigned count, unsigned i, unsigned j, unsigned k) {
  gjk_simplex s;
  s.count = (uint8_t)count;
  s.order[0] = (uint8_t)i;
  s.order[1] = (uint8_t)j;
  s.order[2] = (uint8_t)k;
  s.order[3] = (uint8_t)(6 - i - j - k);
  any_feature(&s);
  if (count > 0 && any_bool()) {
    look(&s);
    return;
  }
  any_vertex(gjk_simplex_free(&s));
  if (count == 2 && any_bool()) {
    (void)gjk_simplex_widen(&s);
    check_feature(&s, 3);
    return;
  }
  const gjk_step step = gjk_simplex_add(&s);
  //@ split s.count;
  check_feature(&s, step == GJK_STEP_ENCLOSING ? 4 : 3);
}

// Certificates and facets fill the slots in order; of these, only where the vertices are is read.
static void named(unsigned n) {
  gjk_simplex s;
  gjk_simplex_clear(&s);
  for (unsigned i = 0; i < n; i++) {
    s.slot[i].w = any_vec3(ANY_W);
  }
  if (any_bool()) {
    (void)gjk_simplex_encloses(&s, n);
  } else if (n < 4) {
    (void)gjk_simplex_set(&s, n);
    if (n == 3) {
      (void)gjk_simplex_beyond(&s);
    }
    for (unsigned i = 0; i < n; i++) {
      s.slot[i].a.offset = any_vec3(ANY_OFFSET);
      s.slot[i].a.vertex = any_uint16();
      s.slot[i].b = any_uint16();
    }
    check_feature(&s, 3);
  }
}

int main(void) {
#if CASE == 4
  for (unsigned n = 1; n <= 4; n++) {
    named(n);
  }
#else
  for (unsigned i = 0; i < 4; i++) {
    for (unsigned j = 0; j < 4; j++) {
      for (unsigned k = 0; k < 4; k++) {
        if (i != j && j != k && k != i) {
          run(CASE, i, j, k);
        }
      }
    }
  }
#endif
  return 0;
}
