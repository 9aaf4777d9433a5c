// Forged answers: if the library's check says OK, the answer is true of the pair, whatever its certificate.
//
//   test_claims [SEED [PAIRS]]
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact/claim.h"
#include "generate/forge.h"

#define PAIRS check_trials(600)
#define CLAIMS 400
#define FAILURES_SHOWN 5

typedef struct tally {
  unsigned long tried, proven, changed;  // changed: proven, though not the answer that the library gives
  unsigned long found_true[GJK_PROOF_PLANE + 1];
} tally;

typedef struct campaign {
  case_pair pair;
  case_collider a, b;
  exact_claims claims;
  random_state random;
  forge_claim other;
  tally tally[FORGE_KINDS];
  unsigned long failures;
  char why[160];
} campaign;

static bool is_true(const campaign *c, const forge_claim *claim) {
  switch (claim->kind) {
    case FORGE_DECISION: return exact_claims_decision(&c->claims, claim->asked, &claim->decision);
    case FORGE_DISTANCE: return exact_claims_distance(&c->claims, &claim->distance);
    default: return exact_claims_penetration(&c->claims, &claim->penetration);
  }
}

static void expect(campaign *c, bool holds, const forge_claim *claim, const char *what) {
  CHECK_MSG(holds, "%s: %s", what, c->why);
  if (!holds && c->failures++ < FAILURES_SHOWN) {
    case_print(stdout, &c->pair);
    forge_print(stdout, claim);
    fflush(stdout);
  }
}

static uint8_t proof_of(const forge_claim *claim) {
  return claim->kind == FORGE_DECISION   ? claim->decision.certificate.proof
         : claim->kind == FORGE_DISTANCE ? claim->distance.certificate.proof
                                         : claim->penetration.certificate.proof;
}

// The library's own answers are true, and the check accepts them.
static void check_answers(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  for (unsigned kind = 0; kind < FORGE_KINDS; kind++) {
    forge_claim claim;
    expect(c, forge_true(a, b, (forge_kind)kind, random_range(&c->random, 0, 9), &claim), &claim, "an answer");
    expect(c, forge_check(a, b, &claim) == GJK_OK, &claim, "an answer is proven");
    expect(c, is_true(c, &claim), &claim, "an answer is true");
    c->tally[kind].found_true[proof_of(&claim)]++;
    if (random_below(&c->random, FORGE_KINDS) == kind) {
      c->other = claim;
    }
  }
}

static bool same(const forge_claim *p, const forge_claim *q) {
  switch (p->kind) {
    case FORGE_DECISION: return memcmp(&p->decision, &q->decision, sizeof p->decision) == 0;
    case FORGE_DISTANCE: return memcmp(&p->distance, &q->distance, sizeof p->distance) == 0;
    default: return memcmp(&p->penetration, &q->penetration, sizeof p->penetration) == 0;
  }
}

static void check_forged(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  const forge_claim other = c->other;
  check_answers(c);
  for (int i = 0; i < CLAIMS; i++) {
    forge_claim claim, right;
    forge(&c->random, a, b, &other, &claim);
    tally *t = &c->tally[claim.kind];
    const gjk_status status = forge_check(a, b, &claim);
    t->tried++;
    expect(c, status == GJK_OK || status == GJK_ERROR_UNPROVEN || status == GJK_ERROR_NEGATIVE, &claim, "a status");
    if (status == GJK_OK) {
      (void)forge_true(a, b, claim.kind, claim.asked, &right);
      const bool changed = !same(&claim, &right);
      t->proven++;
      t->changed += changed;
      expect(c, !changed || is_true(c, &claim), &claim, "a forged answer");
    }
  }
}

int main(int argc, char **argv) {
  static campaign c;
  const uint64_t seed = argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(1);
  const unsigned long pairs = argc > 2 ? strtoul(argv[2], NULL, 10) : PAIRS;
  c.random = random_seed(seed);
  for (unsigned long i = 0; i < pairs && c.failures < FAILURES_SHOWN; i++) {
    forge_pair(&c.random, i % 16 == 0 ? EXACT_BRUTE_MAX : EXACT_BRUTE_MAX / 2, &c.pair);
    const bool built = case_pair_build(&c.pair, false, &c.a, &c.b);
    CHECK(built);
    if (built) {
      exact_claims_open(&c.a.collider, &c.b.collider, c.why, sizeof c.why, &c.claims);
      check_forged(&c);
    }
  }
  static const char *const name[FORGE_KINDS] = {"decisions", "distances", "depths"};
  for (int kind = 0; kind < FORGE_KINDS; kind++) {
    const tally *t = &c.tally[kind];
    printf("%s: %lu forged, %lu proven, %lu of these changed and true; answers by proof:", name[kind], t->tried,
           t->proven, t->changed);
    for (int proof = 0; proof <= GJK_PROOF_PLANE; proof++) {
      printf(" %lu", t->found_true[proof]);
    }
    printf("\n");
    if (pairs >= 100) {
      CHECK_MSG(t->proven * 50 > t->tried, "%s", name[kind]);
      CHECK_MSG(t->proven * 2 < t->tried, "%s", name[kind]);
      CHECK_MSG(t->changed * 200 > t->tried, "%s", name[kind]);
    }
  }
  case_pair_release(&c.pair, &c.a, &c.b);
  return check_done("claims");
}
