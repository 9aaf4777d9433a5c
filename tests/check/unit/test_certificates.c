// A campaign of seeded random pairs: every decision and every distance is proven in exact integers.
//
//   test_certificates [SEED [PAIRS [FAMILY]]]    default: seed 1, 150,000 pairs over all families
#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "iterations.h"

#define PAIRS check_trials_least(150000, 4000)  // `make soak` makes more
#define FAILURES_SHOWN 10
#define CACHES 3

// So many pairs apart, a pair is also checked by the library, with wrong answers, and by brute force: often for up to
// 16 pairs of vertices, rarely for up to EXACT_BRUTE_MAX.
#define CHECK_EVERY 4
#define MUTATE_EVERY 8
#define BRUTE_EVERY 16
#define BRUTE_VERTICES 16
#define BRUTE_LARGE_EVERY 4096

typedef struct campaign {
  const generate_family *family;
  case_pair pair;
  case_collider a, b;
  gjk_cache kept;  // of the pair before: rubbish for this one
  random_state random;
  unsigned long pairs, intersecting, near, brute, mutants, refused, failures;
  unsigned iterations;                               // largest
  unsigned long proofs[GJK_PROOF_ENCLOSING + 1][5];  // by kind and count of named pairs, over all families
  char why[160];
} campaign;

#include "campaign.h"

static void count_answer(campaign *c, unsigned iterations, const gjk_certificate *certificate) {
  expect(c, iterations <= iterations_bound(&c->a.collider, &c->b.collider), "more iterations than proven");
  c->iterations = iterations > c->iterations ? iterations : c->iterations;
  if (certificate->proof <= GJK_PROOF_ENCLOSING && certificate->count <= 4) {
    c->proofs[certificate->proof][certificate->count]++;
  }
}

static void check_decision(campaign *c, gjk_q16 distance, const gjk_decision *d) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  expect(c, exact_check_decision(a, b, distance, d, c->why, sizeof c->why), "decision");
  count_answer(c, d->iterations, &d->certificate);
}

// Asks with the caches of this pair, of another pair, and of random bits. Each answer must be that without a cache.
static void check_within(campaign *c, gjk_q16 distance, gjk_cache *own) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_decision cold, warm;
  gjk_cache caches[CACHES];
  caches[0] = *own;
  caches[1] = c->kept;
  caches[2] = generate_cache(&c->random);
  gjk_cache *chosen = &caches[random_below(&c->random, CACHES)];
  const gjk_status status = gjk_within(a, b, distance, NULL, &cold);
  expect(c, status == GJK_OK, "status of within");
  if (status != GJK_OK) {
    return;
  }
  check_decision(c, distance, &cold);
  expect(c, gjk_within(a, b, distance, chosen, &warm) == GJK_OK && warm.yes == cold.yes, "decision with a cache");
  check_decision(c, distance, &warm);
  if (c->pairs % CHECK_EVERY == 0 && !exact_is_far(a, b)) {
    expect(c, gjk_check_decision(a, b, distance, &cold) == GJK_OK, "gjk_check_decision, cold");
    expect(c, gjk_check_decision(a, b, distance, &warm) == GJK_OK, "gjk_check_decision, warm");
  }
  c->kept = *chosen;
}

static void check_intersect(campaign *c, bool intersecting, gjk_cache *own) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_decision cold, warm;
  expect(c, gjk_intersect(a, b, NULL, &cold) == GJK_OK && cold.yes == intersecting, "gjk_intersect");
  check_decision(c, 0, &cold);
  expect(c, gjk_intersect(a, b, own, &warm) == GJK_OK && warm.yes == intersecting, "gjk_intersect with a cache");
  check_decision(c, 0, &warm);
}

static void check_decisions(campaign *c, const gjk_distance_result *r, gjk_cache *own) {
  const gjk_q16 distance = r->distance;
  check_intersect(c, r->intersecting, own);
  check_within(c, random_range(&c->random, 0, INT32_MAX) >> random_below(&c->random, 31), own);
  if (!r->intersecting) {
    check_within(c, distance, own);
    check_within(c, distance > 0 ? distance - 1 : 0, own);
    check_within(c, distance < INT32_MAX ? distance + 1 : distance, own);
  }
}

// With any cache the decision and the distance stay the same, and are proven again.
static void check_warm(campaign *c, const gjk_distance_result *cold, gjk_cache cache, const char *what) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_distance_result r;
  expect(
      c,
      gjk_distance(a, b, &cache, &r) == GJK_OK && r.intersecting == cold->intersecting && r.distance == cold->distance,
      what);
  expect(c, exact_check_distance(a, b, &r, c->why, sizeof c->why), what);
  count_answer(c, r.iterations, &r.certificate);
}

// Names another vertex in one pair of the certificate.
static void rename_vertex(random_state *random, gjk_certificate *certificate) {
  const unsigned pair = certificate->count > 1 ? random_below(random, certificate->count) : 0;
  uint16_t *vertex = random_below(random, 2) == 0 ? &certificate->a[pair] : &certificate->b[pair];
  *vertex = (uint16_t)(*vertex ^ 1u << random_below(random, 9));
}

// The library's check must refuse what the oracle refuses. It may refuse more: simplices with a vertex that is not
// needed.
static void check_refusal(campaign *c, const gjk_distance_result *wrong, const char *what) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  const bool valid = exact_check_gap(a, b, wrong, c->why, sizeof c->why);
  const gjk_status status = gjk_check_distance(a, b, wrong);
  expect(c, status == GJK_ERROR_UNPROVEN || (valid && status == GJK_OK), what);
  c->mutants++;
  c->refused += status == GJK_ERROR_UNPROVEN;
}

static void check_wrong_distances(campaign *c, const gjk_distance_result *right) {
  gjk_distance_result wrong = *right;
  wrong.distance = wrong.lower = wrong.upper = right->distance + 1;
  check_refusal(c, &wrong, "distance too large");
  wrong.distance = wrong.lower = wrong.upper = right->distance - 1;
  check_refusal(c, &wrong, "distance too small");
  wrong = *right;
  wrong.intersecting = !right->intersecting;
  wrong.distance = wrong.lower = wrong.upper = 0;
  check_refusal(c, &wrong, "intersecting flipped");
  wrong = *right;
  rename_vertex(&c->random, &wrong.certificate);
  check_refusal(c, &wrong, "vertex renamed");
  wrong = *right;
  wrong.certificate.proof = (uint8_t)random_below(&c->random, 8);
  wrong.certificate.count = (uint8_t)random_below(&c->random, 6);
  check_refusal(c, &wrong, "proof changed");
}

// A flipped decision must always be refused. Another vertex or direction must be refused if the oracle refuses it. One
// exception: where bounding spheres settle the question, the library does not read the certificate.
static void check_wrong_decision(campaign *c, gjk_q16 distance) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_decision right, wrong;
  if (gjk_within(a, b, distance, NULL, &right) != GJK_OK) {
    return;
  }
  wrong = right;
  wrong.yes = !right.yes;
  expect(c, gjk_check_decision(a, b, distance, &wrong) == GJK_ERROR_UNPROVEN, "decision flipped");
  wrong = right;
  rename_vertex(&c->random, &wrong.certificate);
  wrong.certificate.direction.x ^= 1 << random_below(&c->random, 31);
  if (right.certificate.proof != GJK_PROOF_SPHERES) {
    const bool valid = exact_check_decision(a, b, distance, &wrong, c->why, sizeof c->why);
    const gjk_status status = gjk_check_decision(a, b, distance, &wrong);
    expect(c, status == GJK_ERROR_UNPROVEN || (valid && status == GJK_OK), "certificate of a decision changed");
    c->mutants++;
    c->refused += status == GJK_ERROR_UNPROVEN;
  }
}

// The feature that proves a distance also proves the right decision about each smaller and larger distance, and never
// the wrong one.
static void check_borrowed_proof(campaign *c, const gjk_distance_result *r, gjk_q16 distance, bool yes) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_decision d = {0};
  d.yes = yes;
  d.certificate = r->certificate;
  d.certificate.proof = yes ? GJK_PROOF_NEAR : GJK_PROOF_NEAREST;
  const bool valid = exact_check_decision(a, b, distance, &d, c->why, sizeof c->why);
  expect(c, valid == (yes ? distance > r->distance : distance < r->distance), "borrowed proof, oracle");
  expect(c, gjk_check_decision(a, b, distance, &d) == (valid ? GJK_OK : GJK_ERROR_UNPROVEN), "borrowed proof");
}

static void check_borrowed_proofs(campaign *c, const gjk_distance_result *r) {
  if (!r->intersecting && r->distance > 0 && r->distance < INT32_MAX) {
    check_borrowed_proof(c, r, r->distance - 1, false);
    check_borrowed_proof(c, r, r->distance - 1, true);
    check_borrowed_proof(c, r, r->distance + 1, false);
    check_borrowed_proof(c, r, r->distance + 1, true);
  }
}

static void check_brute(campaign *c, const gjk_distance_result *r) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  exact_truth truth;
  exact_brute(a, b, &truth);
  const bool together = exact_truth_within(&truth, a, b, 0);
  expect(c, together == r->intersecting, "decision against brute force");
  expect(c, together || exact_truth_distance(&truth, a, b) == r->distance, "distance against brute force");
  c->brute++;
}

static void check_pair(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_distance_result r;
  gjk_cache own = {0};
  const bool built = case_pair_build(&c->pair, false, &c->a, &c->b);
  expect(c, built, "the pair can be posed");
  const gjk_status status = built ? gjk_distance(a, b, &own, &r) : GJK_ERROR_RANGE;
  expect(c, status == GJK_OK, gjk_status_name(status));
  if (status != GJK_OK) {
    return;
  }
  const bool far = exact_is_far(a, b);
  expect(c, exact_check_distance(a, b, &r, c->why, sizeof c->why), "distance");
  count_answer(c, r.iterations, &r.certificate);
  c->pairs++;
  c->intersecting += r.intersecting;
  c->near += !r.intersecting && r.distance <= c->family->near;
  check_warm(c, &r, own, "distance with its own cache");
  check_warm(c, &r, random_below(&c->random, 2) == 0 ? c->kept : generate_cache(&c->random), "distance with any cache");
  check_decisions(c, &r, &own);
  if (c->pairs % CHECK_EVERY == 0) {
    expect(c, gjk_check_distance(a, b, &r) == (far ? GJK_ERROR_UNSUPPORTED : GJK_OK), "gjk_check_distance");
  }
  if (c->pairs % MUTATE_EVERY == 0 && !far) {
    check_wrong_distances(c, &r);
    check_wrong_decision(c, r.distance);
    check_wrong_decision(c, r.distance > 0 ? r.distance - 1 : 0);
    check_borrowed_proofs(c, &r);
  }
  const unsigned vertices = exact_vertex_count(a) * exact_vertex_count(b);
  if (!far && ((c->pairs % BRUTE_EVERY == 0 && vertices <= BRUTE_VERTICES) ||
               (c->pairs % BRUTE_LARGE_EVERY == 0 && vertices <= EXACT_BRUTE_MAX))) {
    check_brute(c, &r);
  }
}

// Runs a family and returns its most iterations. The share of intersecting pairs must stay between the limits of the
// family.
static unsigned run_family(campaign *c, uint64_t seed, unsigned long pairs) {
  const generate_family *family = c->family;
  c->random = random_seed(seed);
  c->pairs = c->intersecting = c->near = c->brute = c->mutants = c->refused = c->failures = 0;
  c->iterations = 0;
  for (unsigned long i = 0; i < pairs && c->failures < FAILURES_SHOWN; i++) {
    generate_pair(family, (seed << 32) + i, &c->pair);
    check_pair(c);
  }
  const double share = 100.0 * (double)c->intersecting / (double)(c->pairs > 0 ? c->pairs : 1);
  printf(
      "%-22s %6lu pairs, %5.1f %% intersect, %2u iterations at most, %4lu by brute force, %lu of %lu wrong answers "
      "refused\n",
      family->name, c->pairs, share, c->iterations, c->brute, c->refused, c->mutants);
  fflush(stdout);
  if (pairs >= 1000) {
    campaign_check_share(family->name, share, family->least, family->most);
    CHECK_MSG(family->near == 0 || c->near * 10 >= (c->pairs - c->intersecting) * 9, "%s: %lu near", family->name,
              c->near);
  }
  return c->iterations;
}

static void check_proofs(campaign *c, unsigned long pairs) {
  static const campaign_proof kinds[] = {{GJK_PROOF_SPHERES, 0, 0, "spheres", 1000},
                                         {GJK_PROOF_DIRECTION, 0, 0, "direction", 1000},
                                         {GJK_PROOF_NEAREST, 1, 3, "nearest", 1000},
                                         {GJK_PROOF_NEAR, 1, 3, "near", 1000},
                                         {GJK_PROOF_ENCLOSING, 1, 4, "enclosing", 1000}};
  campaign_check_proofs(kinds, sizeof kinds / sizeof kinds[0], c->proofs, pairs);
}

int main(int argc, char **argv) {
  static campaign c;
  const campaign_request asked = campaign_requested(argc, argv, PAIRS, generate_family_count);
  unsigned iterations = 0;
  unsigned long total = 0, refused = 0, brute = 0;
  for (unsigned i = 0; i < generate_family_count; i++) {
    c.family = &generate_families[i];
    if (campaign_includes(&asked, c.family->name)) {
      const unsigned needed = run_family(&c, asked.seed, asked.each);
      iterations = needed > iterations ? needed : iterations;
      total += c.pairs;
      refused += c.refused;
      brute += c.brute;
    }
  }
  printf("%lu pairs, %u iterations at most\n", total, iterations);
  CHECK(total >= asked.count);
  // A guard of speed, for the sample of `make test` alone: among millions of slivers some need 21. The proven bound of each
  // pair is checked with its answers.
  CHECK_MSG(argc > 1 || iterations <= 18 || GJK_PLAIN_ITERATIONS != 16, "%u", iterations);
  if (asked.name == NULL && asked.count >= 10000) {
    CHECK(refused > total / 4);
    CHECK(brute > total / 1000);
    check_proofs(&c, total);
  }
  case_pair_release(&c.pair, &c.a, &c.b);
  return check_done("certificates");
}
