// Makes a pair of small polytopes, a forged answer about it and changes of that answer from bytes. What the library's
// check accepts must be true. With GJK_FUZZ_PRINT set, the pair and each answer are printed first.
#include <stdlib.h>

#include "bytes.h"
#include "exact/claim.h"
#include "generate/forge.h"

// Most pairs of vertices, so that brute force is quick.
#define VERTICES 16

static case_pair pair;
static case_collider a, b;
static exact_claims claims;
static char why[160];

static uint64_t seed_of(fuzz_bytes *bytes) {
  const uint64_t high = (uint32_t)fuzz_i32(bytes);
  return high << 32 | (uint32_t)fuzz_i32(bytes);
}

static bool is_true(const forge_claim *claim) {
  switch (claim->kind) {
    case FORGE_DECISION: return exact_claims_decision(&claims, claim->asked, &claim->decision);
    case FORGE_DISTANCE: return exact_claims_distance(&claims, &claim->distance);
    default: return exact_claims_penetration(&claims, &claim->penetration);
  }
}

static void judge(const forge_claim *claim) {
  if (getenv("GJK_FUZZ_PRINT") != NULL) {
    case_print(stdout, &pair);
    forge_print(stdout, claim);
    fflush(stdout);
  }
  if (forge_check(&a.collider, &b.collider, claim) == GJK_OK && !is_true(claim)) {
    case_print(stderr, &pair);
    forge_print(stderr, claim);
    fprintf(stderr, "fuzz: %s\n", why);
    fuzz_fail("a false claim is OK");
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  random_state random = random_seed(seed_of(&bytes)), ways = random_seed(seed_of(&bytes));
  forge_claim other, claim;
  forge_pair(&random, VERTICES, &pair);
  if (!case_pair_build(&pair, false, &a, &b)) {
    return 0;
  }
  exact_claims_open(&a.collider, &b.collider, why, sizeof why, &claims);
  (void)forge_true(&a.collider, &b.collider, (forge_kind)(fuzz_u8(&bytes) % FORGE_KINDS), 0, &other);
  forge(&ways, &a.collider, &b.collider, &other, &claim);
  judge(&claim);
  while (bytes.at < bytes.end) {
    const uint32_t field = fuzz_u8(&bytes), how = fuzz_u8(&bytes);
    forge_edit(field, how, fuzz_i32(&bytes), &claim);
    if (how >= 192) {
      forge_fit(&a.collider, &b.collider, &claim);
    }
    judge(&claim);
  }
  return 0;
}
