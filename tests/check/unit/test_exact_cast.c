// The exact oracle of casts: against cases with answers worked out elsewhere, by hand, and by brute force at points of
// the way.
#include <inttypes.h>
#include <string.h>

#include "case/parse.h"
#include "check.h"
#include "exact/cast.h"
#include "generate/polytope.h"
#include "random.h"

#define SEED 31011
#define PAIRS check_trials(1000)

static exact_difference difference;
static case_collider a, b;

static exact_point way_of(const case_shape *shape) {
  const gjk_vec3 *p = &shape->pose.position, *q = &shape->end.position;
  return (exact_point){{(int64_t)q->x - p->x, (int64_t)q->y - p->y, (int64_t)q->z - p->z}};
}

static const exact_point nowhere = {{0, 0, 0}};

static bool cast_of(const case_pair *pair, exact_cast_truth *out) {
  if (!case_pair_build(pair, false, &a, &b) || !exact_difference_find(&a.collider, &b.collider, &difference)) {
    return false;
  }
  const exact_point by_a = way_of(&pair->a), by_b = way_of(&pair->b), way = exact_subtract(&by_b, &by_a);
  exact_cast_find(&difference, &nowhere, &way, out);
  return true;
}

// Writes an answer as the file of answers has it.
static void write_answer(const case_pair *pair, const exact_cast_truth *truth, char text[96]) {
  if (truth->hit) {
    snprintf(text, 96, "%s hit fraction=%ld dim=%u\n", pair->id, (long)truth->fraction, difference.dimension);
  } else {
    snprintf(text, 96, "%s miss dim=%u\n", pair->id, difference.dimension);
  }
}

// tests/data/cast.txt and cast.exact: fractions rounded down to 2^-30, and the dimension of A - B.
static void test_known(void) {
  FILE *cases = fopen("tests/data/cast.txt", "r"), *answers = fopen("tests/data/cast.exact", "r");
  static case_pair pair;
  case_reader reader;
  unsigned count = 0, hits = 0;
  CHECK(cases != NULL && answers != NULL);
  if (cases == NULL || answers == NULL) {
    return;
  }
  case_reader_open(&reader, cases, "cast.txt");
  while (case_reader_next(&reader, &pair)) {
    char expected[96] = "", found[96] = "";
    exact_cast_truth truth = {0};
    CHECK(fgets(expected, sizeof expected, answers) != NULL);
    CHECK_MSG(cast_of(&pair, &truth), "%s", pair.id);
    write_answer(&pair, &truth, found);
    CHECK_MSG(strcmp(expected, found) == 0, "%sinstead of %s", found, expected);
    count++;
    hits += truth.hit;
  }
  CHECK(reader.errors == 0 && count == 26 && hits > 15);
  case_pair_free(&pair);
  fclose(cases);
  fclose(answers);
}

// By the oracle of distances: do the shapes share a point when B is moved by a whole vector?
static bool is_together(const gjk_collider *first, const gjk_collider *second, const exact_point *by) {
  gjk_collider moved = *second;
  const gjk_vec3 to = {(gjk_q16)(second->position.x + by->x[0]), (gjk_q16)(second->position.y + by->x[1]),
                       (gjk_q16)(second->position.z + by->x[2])};
  exact_truth truth;
  CHECK(gjk_collider_move(&moved, &to) == GJK_OK);
  exact_brute(first, &moved, &truth);
  return truth.enclosing;
}

static void make_pair(random_state *random, case_pair *pair) {
  const gjk_q16 reach = random_below(random, 2) == 0 ? 4 : (gjk_q16)(100 << random_below(random, 8));
  case_shape *const shape[2] = {&pair->a, &pair->b};
  for (int i = 0; i < 2; i++) {
    case_shape_reset(shape[i]);
    shape[i]->kind = random_below(random, 8) == 0 ? CASE_POINT : CASE_HULL;
    case_shape_set_count(shape[i], shape[i]->kind == CASE_POINT ? 0 : 1 + random_below(random, 5));
    for (size_t k = 0; k < shape[i]->count; k++) {
      gjk_vec3 *v = &shape[i]->vertices[k];
      v->x = random_range(random, -reach, reach);
      v->y = random_range(random, -reach, reach);
      v->z = random_below(random, 4) == 0 ? 0 : random_range(random, -reach, reach);
    }
  }
  pair->b.pose.position.x = random_range(random, -3 * reach, 3 * reach);
  pair->b.pose.position.y = random_range(random, -3 * reach, 3 * reach);
  pair->b.pose.position.z = random_range(random, -reach, reach);
}

// A way of n equal whole steps: at each the shapes share a point exactly if the step lies between the first fraction
// and the last one.
static void check_steps(random_state *random, const case_pair *pair) {
  const int32_t steps = 1 + (int32_t)random_below(random, 12);
  const gjk_vec3 *p = &pair->b.pose.position;
  const exact_point step = {{(-p->x + random_range(random, -4, 4)) / steps * 2,
                             (-p->y + random_range(random, -4, 4)) / steps * 2,
                             (-p->z + random_range(random, -4, 4)) / steps * 2}};
  const exact_point way = {{steps * step.x[0], steps * step.x[1], steps * step.x[2]}};
  exact_cast_truth truth, back;
  const exact_point opposite = exact_subtract(&nowhere, &way);
  exact_cast_find(&difference, &nowhere, &way, &truth);
  exact_cast_find(&difference, &way, &opposite, &back);
  CHECK(truth.hit == back.hit);
  CHECK(truth.fraction >= 0 && truth.fraction <= GJK_Q30_ONE);
  for (int32_t k = 0; k <= steps; k++) {
    const exact_point by = {{k * step.x[0], k * step.x[1], k * step.x[2]}};
    const bool between = truth.hit && exact_compare_products(k, truth.denominator, steps, truth.numerator) >= 0 &&
                         exact_compare_products(steps - k, back.denominator, steps, back.numerator) >= 0;
    const bool together = is_together(&a.collider, &b.collider, &by);
    CHECK_MSG(together == between, "step %ld of %ld", (long)k, (long)steps);
    CHECK(together == (exact_difference_side(&difference, &by, &way, 0, 1) >= 0));
    CHECK(together == (exact_difference_side(&difference, &nowhere, &way, k, steps) >= 0));
    CHECK(!together || truth.fraction <= (int64_t)k * GJK_Q30_ONE / steps);
  }
  CHECK(truth.inside == is_together(&a.collider, &b.collider, &nowhere));
}

static void test_random(random_state *random) {
  static case_pair pair;
  unsigned long dimension[4] = {0, 0, 0, 0};
  for (unsigned long i = 0; i < PAIRS; i++) {
    exact_cast_truth truth;
    make_pair(random, &pair);
    check_trial(i, case_show, &pair);
    CHECK(cast_of(&pair, &truth));
    dimension[difference.dimension]++;
    check_steps(random, &pair);
  }
  for (int i = 0; i < 4; i++) {
    CHECK_MSG(dimension[i] > PAIRS / 200, "%lu of dimension %d", dimension[i], i);
  }
  case_pair_free(&pair);
}

static void test_arithmetic(random_state *random) {
  for (int i = 0; i < 10000; i++) {
    const exact_wide p = (exact_wide)random_u64(random) << random_below(random, 62), q = random_range(random, -50, 50);
    const exact_int wide_p = exact_from_wide(-p), small = exact_from((int64_t)q), product = exact_mul(&wide_p, &small);
    const exact_int wide_product = exact_from_wide(-p / 128 * q), at_most = exact_from_wide(p / 128);
    const exact_int part = exact_mul(&at_most, &small), negated = exact_negate(part);
    CHECK(exact_compare(&wide_product, &negated) == 0);
    CHECK(product.sign == -(q > 0) + (q < 0) || p == 0);
    CHECK(exact_compare_products(p, q, q, p) == 0);
    CHECK(p < 4 || exact_compare_products(p, p, p + 1, p - 1) == 1);
    CHECK(p < 4 || exact_compare_products(p + 1, p - 1, p, p) == -1);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  test_known();
  test_arithmetic(&random);
  test_random(&random);
  exact_difference_free(&difference);
  case_collider_free(&a);
  case_collider_free(&b);
  return check_done("exact_cast");
}
