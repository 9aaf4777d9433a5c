// gjk_within_until: an answer is the exact one, however many iterations it may take, and more iterations do not change
// it. Otherwise the answer is open.
//
//   test_within_until [SEED]
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "placed.h"
#include "reference/random_shape.h"

#define PAIRS_PER_FAMILY ((int)check_trials(200))
#define CURVED_PAIRS ((int)check_trials(2000))
#define POISON 0xA5

typedef struct tally {
  unsigned long open, yes, no;
} tally;

typedef struct campaign {
  case_pair pair;
  case_collider a, b;
  random_state random;
  bool certain;  // polytopes, not far apart: each answer is proven
  tally few[4];  // by iterations
} campaign;

static bool is_open(const gjk_within_result *r) {
  gjk_decision untouched;
  memset(&untouched, POISON, sizeof untouched);
  untouched.iterations = r->decision.iterations;
  return memcmp(&r->decision, &untouched, sizeof untouched) == 0;
}

static bool is_same(const gjk_decision *a, const gjk_decision *b) {
  return a->yes == b->yes && a->iterations == b->iterations && a->certificate.proof == b->certificate.proof &&
         a->certificate.count == b->certificate.count;
}

// Without a cache, n iterations settle the question if the whole query needs no more. The whole query may need one
// more, which only proves what the feature told before: that it is near enough, by less than the rounding of the
// direction.
static void check_iterations(campaign *c, gjk_q16 distance, uint8_t iterations, const gjk_decision *full) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_within_result r, again;
  memset(&r, POISON, sizeof r);
  memset(&again, POISON, sizeof again);
  const gjk_status status = gjk_within_until(a, b, distance, iterations, NULL, &r);
  CHECK_MSG(status == GJK_OK, "%s, %d iterations: %s", c->pair.id, iterations, gjk_status_name(status));
  CHECK(gjk_within_until(a, b, distance, iterations, NULL, &again) == GJK_OK);
  CHECK(memcmp(&r, &again, sizeof r) == 0);
  const bool settled = r.answer != GJK_ANSWER_OPEN, enough = iterations == 0 || full->iterations <= iterations;
  CHECK_MSG(settled || !enough, "%s, %d iterations", c->pair.id, iterations);
  CHECK_MSG(!settled || enough || (full->yes && full->iterations == iterations + 1), "%s, %d iterations", c->pair.id,
            iterations);
  CHECK_MSG(iterations == 0 || r.decision.iterations <= iterations, "%s, %d iterations", c->pair.id, iterations);
  if (iterations > 0 && iterations < 4) {
    tally *t = &c->few[iterations];
    ++*(r.answer == GJK_ANSWER_OPEN ? &t->open : r.answer == GJK_ANSWER_YES ? &t->yes : &t->no);
  }
  if (!settled) {
    CHECK_MSG(is_open(&r), "%s, %d iterations: more than the iterations", c->pair.id, iterations);
    return;
  }
  CHECK_MSG((r.answer == GJK_ANSWER_YES) == full->yes, "%s, %d iterations", c->pair.id, iterations);
  CHECK_MSG(r.decision.yes == full->yes, "%s, %d iterations", c->pair.id, iterations);
  CHECK_MSG(!enough || is_same(&r.decision, full), "%s, %d iterations", c->pair.id, iterations);
  char why[160];
  if (c->certain) {
    CHECK_MSG(exact_check_decision(a, b, distance, &r.decision, why, sizeof why), "%s: %s", c->pair.id, why);
    CHECK_MSG(gjk_check_decision(a, b, distance, &r.decision) == GJK_OK, "%s", c->pair.id);
  }
}

// With any cache the answer is the same. An open answer leaves the cache as it is.
static void check_cache(campaign *c, gjk_q16 distance, uint8_t iterations, const gjk_decision *full) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_cache cache = generate_cache(&c->random), before;
  for (int i = 0; i < 3; i++) {
    gjk_within_result r;
    before = cache;
    CHECK(gjk_within_until(a, b, distance, iterations, &cache, &r) == GJK_OK);
    if (r.answer == GJK_ANSWER_OPEN) {
      CHECK(memcmp(&cache, &before, sizeof cache) == 0);
      (void)gjk_within_until(a, b, distance, 0, &cache, &r);
    }
    CHECK_MSG((r.answer == GJK_ANSWER_YES) == full->yes, "%s, warm, %d iterations", c->pair.id, iterations);
  }
}

static void check_distance(campaign *c, gjk_q16 distance) {
  gjk_decision full = {0};
  CHECK_MSG(gjk_within(&c->a.collider, &c->b.collider, distance, NULL, &full) == GJK_OK, "%s", c->pair.id);
  for (unsigned iterations = 0; iterations < full.iterations + 2u; iterations++) {
    check_iterations(c, distance, (uint8_t)iterations, &full);
  }
  check_iterations(c, distance, GJK_ITERATIONS_MAX, &full);
  check_iterations(c, distance, UINT8_MAX, &full);
  check_cache(c, distance, (uint8_t)(1 + random_below(&c->random, 3)), &full);
}

static void check_pair(campaign *c) {
  gjk_distance_result gap;
  if (!case_pair_build(&c->pair, false, &c->a, &c->b) ||
      gjk_distance(&c->a.collider, &c->b.collider, NULL, &gap) != GJK_OK) {
    CHECK_MSG(false, "%s", c->pair.id);
    return;
  }
  const unsigned long failed = check_failed;
  const gjk_q16 most = gap.distance < INT32_MAX ? gap.distance + 1 : gap.distance;
  check_distance(c, 0);
  check_distance(c, gap.distance > 0 ? gap.distance - 1 : 0);
  check_distance(c, gap.distance);
  check_distance(c, most);
  check_distance(c, random_range(&c->random, 0, INT32_MAX) >> random_below(&c->random, 31));
  if (check_failed > failed && failed < 5) {
    case_print(stdout, &c->pair);
  }
}

static void test_statuses(void) {
  static const gjk_shape ball = GJK_SPHERE(5);
  const gjk_collider a = placed_at(&ball, 0, 0, 0), b = {0};
  gjk_within_result out, poison;
  memset(&poison, POISON, sizeof poison);
  out = poison;
  CHECK(gjk_within_until(NULL, &a, 0, 1, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_within_until(&a, NULL, 0, 1, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_within_until(&a, &a, 0, 1, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_within_until(&a, &b, 0, 1, NULL, &out) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_within_until(&a, &a, -1, 1, NULL, &out) == GJK_ERROR_NEGATIVE);
  CHECK(memcmp(&out, &poison, sizeof out) == 0);
  CHECK(gjk_within_until(&a, &a, 0, 0, NULL, &out) == GJK_OK);
  CHECK(out.answer == GJK_ANSWER_YES);
  CHECK(out.decision.yes);
}

int main(int argc, char **argv) {
  static campaign c;
  const uint64_t seed = argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(1);
  c.random = random_seed(seed);
  test_statuses();
  for (unsigned f = 0; f < generate_family_count; f++) {
    for (int i = 0; i < PAIRS_PER_FAMILY; i++) {
      generate_pair(&generate_families[f], (seed << 32) + 9000 + (uint64_t)i, &c.pair);
      c.certain = true;
      if (case_pair_build(&c.pair, false, &c.a, &c.b)) {
        c.certain = !exact_is_far(&c.a.collider, &c.b.collider);
      }
      check_pair(&c);
    }
  }
  c.certain = false;
  for (int i = 0; i < CURVED_PAIRS; i++) {
    const gjk_q16 reach = random_reach(&c.random);
    random_shape(&c.random, CASE_CYLINDER + (case_kind)random_below(&c.random, 3), reach, &c.pair.a);
    random_shape(&c.random, (case_kind)random_below(&c.random, CASE_ELLIPSOID + 1), reach, &c.pair.b);
    c.pair.b.pose.position = random_vector(&c.random, 2 * random_unit(&c.random) * reach);
    snprintf(c.pair.id, sizeof c.pair.id, "curved-%d", i);
    check_pair(&c);
  }
  for (int iterations = 1; iterations < 4; iterations++) {
    const tally *t = &c.few[iterations];
    printf("%d iterations: %lu open, %lu yes, %lu no\n", iterations, t->open, t->yes, t->no);
    CHECK(CURVED_PAIRS < 2000 || t->open > 100);
    CHECK(CURVED_PAIRS < 2000 || t->no > 100);
    CHECK(CURVED_PAIRS < 2000 || iterations == 1 || t->yes > 100);
  }
  case_pair_release(&c.pair, &c.a, &c.b);
  return check_done("within-until");
}
