// A campaign of seeded random pairs in the plane: every decision, distance and
// depth is compared with the exact oracle, and every certificate is verified.
//
//   test_plane_certificates [SEED [PAIRS [FAMILY]]]    default: seed 1,
//   150,000 pairs over all families
//
#include "check.h"
#include "exact/claim2.h"
#include "generate/generate2.h"

#define PAIRS check_trials_least(150000, 3000)  // `make soak SOAK=test_plane_certificates` makes more
#define FAILURES_SHOWN 10

// So many pairs apart, a pair is also asked of lazy polygons and in the other
// order, and with wrong answers.
#define LAZY_EVERY 4
#define MUTATE_EVERY 8

typedef struct campaign {
  const generate2_family *family;
  case2_pair pair;
  case2_collider a, b, lazy;
  exact2_pair exact;
  gjk2_cache kept;  // of the pair before: rubbish for this one
  random_state random;
  unsigned long pairs, intersecting, near, touching, mutants, refused, failures;
  unsigned iterations;                           // largest
  unsigned long proofs[GJK2_PROOF_LINE + 1][5];  // by kind and count of named pairs, over all families
  char why[160];
} campaign;

#define case_print case2_print
#include "campaign.h"

static void count_proof(campaign *c, const gjk2_certificate *certificate) {
  if (certificate->proof <= GJK2_PROOF_LINE && certificate->count <= 3) {
    c->proofs[certificate->proof][certificate->count]++;
  }
}

static void count_answer(campaign *c, unsigned iterations, const gjk2_certificate *certificate) {
  const unsigned n = c->exact.a.shape.count, m = c->exact.b.shape.count;
  expect(c, iterations <= GJK2_ITERATIONS_OF(n, m), "more iterations than proven");
  c->iterations = iterations > c->iterations ? iterations : c->iterations;
  count_proof(c, certificate);
}

static gjk2_cache random_cache(random_state *random) {
  gjk2_cache cache;
  for (int i = 0; i < 2; i++) {
    cache.direction[i] = (int16_t)random_u32(random);
    cache.a[i] = (uint16_t)(random_u32(random) >> (16 + random_below(random, 17) / 2));
    cache.b[i] = (uint16_t)(random_u32(random) >> (16 + random_below(random, 17) / 2));
  }
  cache.count = (uint16_t)random_below(random, 4);
  return cache;
}

// The cache of this pair, of another pair, or of random bits.
static gjk2_cache any_cache(campaign *c, const gjk2_cache *own) {
  switch (random_below(&c->random, 3)) {
    case 0: return *own;
    case 1: return c->kept;
    default: return random_cache(&c->random);
  }
}

static void check_distance(campaign *c, const gjk2_distance_result *r, const char *what) {
  expect(c, exact2_check_distance(&c->exact, r, c->why, sizeof c->why), what);
  count_answer(c, r->iterations, &r->certificate);
}

// With any cache the decision and the distance stay the same, and are proven
// again.
static void check_distances(campaign *c, gjk2_distance_result *r, gjk2_cache *own) {
  const gjk2_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk2_distance_result warm;
  expect(c, gjk2_distance(a, b, own, r) == GJK_OK, "status of gjk2_distance");
  check_distance(c, r, "distance");
  gjk2_cache cache = any_cache(c, own);
  expect(c, gjk2_distance(a, b, &cache, &warm) == GJK_OK, "status of gjk2_distance with a cache");
  expect(c, warm.intersecting == r->intersecting && warm.distance == r->distance, "distance with a cache, the same");
  check_distance(c, &warm, "distance with a cache");
  const gjk_status status = gjk2_check_distance(a, b, r);
  expect(c, status == GJK_OK || (c->exact.far && status == GJK_ERROR_UNSUPPORTED), "gjk2_check_distance");
  c->kept = cache;
}

static void check_decision(campaign *c, gjk_q16 distance, const gjk2_cache *own) {
  const gjk2_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk2_cache cache = any_cache(c, own);
  gjk2_decision cold, warm;
  expect(c, gjk2_within(a, b, distance, NULL, &cold) == GJK_OK, "status of gjk2_within");
  expect(c, exact2_check_decision(&c->exact, distance, &cold, c->why, sizeof c->why), "decision");
  count_answer(c, cold.iterations, &cold.certificate);
  expect(c, gjk2_within(a, b, distance, &cache, &warm) == GJK_OK && warm.yes == cold.yes, "decision with a cache");
  expect(c, exact2_check_decision(&c->exact, distance, &warm, c->why, sizeof c->why), "decision with a cache");
  count_answer(c, warm.iterations, &warm.certificate);
  const gjk_status status = gjk2_check_decision(a, b, distance, &cold);
  expect(c, status == GJK_OK || (c->exact.far && status == GJK_ERROR_UNSUPPORTED), "gjk2_check_decision");
}

static void check_decisions(campaign *c, const gjk2_distance_result *r, const gjk2_cache *own) {
  gjk2_decision touch;
  expect(c, gjk2_intersect(&c->a.collider, &c->b.collider, NULL, &touch) == GJK_OK && touch.yes == r->intersecting,
         "gjk2_intersect");
  check_decision(c, 0, own);
  check_decision(c, random_range(&c->random, 0, INT32_MAX) >> random_below(&c->random, 31), own);
  if (!r->intersecting) {
    check_decision(c, r->distance, own);
    check_decision(c, r->distance > 0 ? r->distance - 1 : 0, own);
    check_decision(c, r->distance < INT32_MAX ? r->distance + 1 : r->distance, own);
  }
}

static void check_depth(campaign *c, const gjk2_distance_result *gap, const gjk2_cache *own) {
  const gjk2_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk2_penetration_result cold, warm;
  gjk2_distance_result both;
  gjk2_cache cache = any_cache(c, own);
  expect(c, gjk2_penetration(a, b, NULL, &cold) == GJK_OK, "status of gjk2_penetration");
  expect(c, exact2_check_penetration(&c->exact, &cold, c->why, sizeof c->why), "depth");
  count_proof(c, &cold.certificate);
  expect(c, gjk2_penetration(a, b, &cache, &warm) == GJK_OK, "status of gjk2_penetration with a cache");
  expect(c, exact2_check_penetration(&c->exact, &warm, c->why, sizeof c->why), "depth with a cache");
  expect(c, gjk2_signed_distance(a, b, NULL, &both) == GJK_OK, "status of gjk2_signed_distance");
  expect(c, both.intersecting == gap->intersecting, "gjk2_signed_distance, decision");
  expect(c, both.distance == (gap->intersecting ? -cold.depth : gap->distance), "gjk2_signed_distance");
  if (cold.intersecting) {
    expect(c, gjk2_check_penetration(a, b, &cold) == GJK_OK, "gjk2_check_penetration");
    c->touching += cold.depth == 0 ? 1 : 0;
  }
}

// A lazy polygon gives the same bits; B and A the same decision and distance.
static void check_variants(campaign *c, const gjk2_distance_result *r) {
  gjk2_distance_result lazy, swapped;
  gjk2_penetration_result deep, back;
  expect(c, case2_collider_build(&c->lazy, &c->pair.b, true) == GJK_OK, "lazy");
  expect(c,
         gjk2_distance(&c->a.collider, &c->lazy.collider, NULL, &lazy) == GJK_OK && lazy.distance == r->distance &&
             lazy.intersecting == r->intersecting && lazy.iterations == r->iterations &&
             (r->intersecting || (lazy.point_a.x == r->point_a.x && lazy.point_a.y == r->point_a.y &&
                                  lazy.normal.x == r->normal.x && lazy.normal.y == r->normal.y)),
         "a lazy polygon, the same bits");
  expect(c,
         gjk2_distance(&c->b.collider, &c->a.collider, NULL, &swapped) == GJK_OK &&
             swapped.intersecting == r->intersecting && (c->exact.far || swapped.distance == r->distance),
         "the other order");
  if (r->intersecting) {
    expect(c,
           gjk2_penetration(&c->a.collider, &c->lazy.collider, NULL, &deep) == GJK_OK &&
               deep.depth == c->exact.truth.depth,
           "depth of a lazy polygon");
    expect(
        c,
        gjk2_penetration(&c->b.collider, &c->a.collider, NULL, &back) == GJK_OK && back.depth == c->exact.truth.depth,
        "depth in the other order");
  }
}

// The library's check must refuse what the oracle refuses. It may refuse more.
static void check_refusal(campaign *c, const gjk2_distance_result *wrong, const char *what) {
  const bool valid = exact2_check_distance(&c->exact, wrong, c->why, sizeof c->why);
  const gjk_status status = gjk2_check_distance(&c->a.collider, &c->b.collider, wrong);
  expect(c, status == GJK_ERROR_UNPROVEN || (valid && status == GJK_OK), what);
  c->mutants++;
  c->refused += status == GJK_ERROR_UNPROVEN;
}

static void check_wrong_answers(campaign *c, const gjk2_distance_result *right) {
  gjk2_distance_result wrong = *right;
  wrong.distance = wrong.lower = wrong.upper = right->distance + 1;
  check_refusal(c, &wrong, "distance too large");
  wrong.distance = wrong.lower = wrong.upper = right->distance - 1;
  check_refusal(c, &wrong, "distance too small");
  wrong = *right;
  wrong.intersecting = !right->intersecting;
  wrong.distance = wrong.lower = wrong.upper = 0;
  check_refusal(c, &wrong, "intersecting flipped");
  gjk2_penetration_result deep;
  if (right->intersecting && gjk2_penetration(&c->a.collider, &c->b.collider, NULL, &deep) == GJK_OK) {
    for (int off = -1; off <= 1; off += 2) {
      gjk2_penetration_result other = deep;
      other.depth = other.lower = other.upper = deep.depth + off;
      expect(c, gjk2_check_penetration(&c->a.collider, &c->b.collider, &other) == GJK_ERROR_UNPROVEN, "wrong depth");
      c->mutants++;
      c->refused++;
    }
  }
}

static void check_pair(campaign *c) {
  gjk2_distance_result r;
  gjk2_cache own = {0};
  const bool built = case2_collider_build(&c->a, &c->pair.a, false) == GJK_OK &&
                     case2_collider_build(&c->b, &c->pair.b, false) == GJK_OK &&
                     exact2_pair_set(&c->a.collider, &c->b.collider, &c->exact);
  expect(c, built, "the pair can be posed");
  if (!built) {
    return;
  }
  check_distances(c, &r, &own);
  check_decisions(c, &r, &own);
  check_depth(c, &r, &own);
  c->pairs++;
  c->intersecting += r.intersecting ? 1 : 0;
  c->near += !r.intersecting && r.distance <= c->family->near ? 1 : 0;
  if (c->pairs % LAZY_EVERY == 0) {
    check_variants(c, &r);
  }
  if (c->pairs % MUTATE_EVERY == 0 && !c->exact.far) {
    check_wrong_answers(c, &r);
  }
  exact2_pair_free(&c->exact);
}

// Runs a family and returns its most iterations. The share of intersecting
// pairs must stay between the limits of the family.
static unsigned run_family(campaign *c, uint64_t seed, unsigned long pairs) {
  const generate2_family *family = c->family;
  c->random = random_seed(seed);
  c->pairs = c->intersecting = c->near = c->touching = c->mutants = c->refused = c->failures = 0;
  c->iterations = 0;
  for (unsigned long i = 0; i < pairs && c->failures < FAILURES_SHOWN; i++) {
    generate2_pair(family, (seed << 32) + i, &c->pair);
    check_pair(c);
  }
  const double all = (double)(c->pairs > 0 ? c->pairs : 1), share = 100.0 * (double)c->intersecting / all;
  printf(
      "%-18s %6lu pairs, %5.1f %% intersect, %4.1f %% touch, %2u iterations "
      "at most, %lu of %lu wrong answers "
      "refused\n",
      family->name, c->pairs, share, 100.0 * (double)c->touching / all, c->iterations, c->refused, c->mutants);
  fflush(stdout);
  if (pairs >= 1000) {
    campaign_check_share(family->name, share, family->least, family->most);
    CHECK_MSG(family->near == 0 || c->near * 10 >= (c->pairs - c->intersecting) * 9, "%s: %lu near", family->name,
              c->near);
  }
  return c->iterations;
}

static void check_proofs(campaign *c, unsigned long pairs) {
  static const campaign_proof kinds[] = {
      {GJK2_PROOF_CIRCLES, 0, 0, "circles", 1000},     {GJK2_PROOF_DIRECTION, 0, 0, "direction", 1000},
      {GJK2_PROOF_NEAREST, 1, 2, "nearest", 1000},     {GJK2_PROOF_NEAR, 1, 2, "near", 1000},
      {GJK2_PROOF_ENCLOSING, 1, 3, "enclosing", 1000}, {GJK2_PROOF_EDGE, 2, 2, "edge", 1000},
      {GJK2_PROOF_LINE, 1, 1, "line", 10000}};
  campaign_check_proofs(kinds, sizeof kinds / sizeof kinds[0], c->proofs, pairs);
}

int main(int argc, char **argv) {
  static campaign c;
  const campaign_request asked = campaign_requested(argc, argv, PAIRS, generate2_family_count);
  unsigned iterations = 0;
  unsigned long total = 0, refused = 0;
  for (unsigned i = 0; i < generate2_family_count; i++) {
    c.family = &generate2_families[i];
    if (campaign_includes(&asked, c.family->name)) {
      const unsigned needed = run_family(&c, asked.seed, asked.each);
      iterations = needed > iterations ? needed : iterations;
      total += c.pairs;
      refused += c.refused;
    }
  }
  printf("%lu pairs, %u iterations at most\n", total, iterations);
  CHECK(total >= asked.count);
  if (asked.name == NULL && asked.count >= 10000) {
    CHECK(refused > total / 4);
    check_proofs(&c, total);
  }
  case2_pair_free(&c.pair);
  case2_collider_free(&c.a);
  case2_collider_free(&c.b);
  case2_collider_free(&c.lazy);
  return check_done("plane certificates");
}
