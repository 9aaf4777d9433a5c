// The library against the reference in double, pair by pair. Where they differ, the exact oracle says who is right.
// test_reference [SEED [PAIRS]]
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "reference/reference.h"

typedef struct tally {
  unsigned pairs, together, decisions, distances;  // pairs; that intersect; where double decides, measures wrongly
  double error;                                    // of double, in LSB, at most, where both are apart
} tally;

// Of shapes apart, how far double may be from the rounded distance: 1 LSB, or 2^-28 of it where that is the contract.
static double tolerance(const gjk_distance_result *result) {
  return fmax(1.0, ldexp(result->distance, -28) * 2);
}

// Does the exact oracle side with the library? Called where double differs.
static void judge(const case_pair *pair, const case_collider *a, const case_collider *b,
                  const gjk_distance_result *result) {
  char why[200];
  const bool right = exact_check_distance(&a->collider, &b->collider, result, why, sizeof why);
  CHECK_MSG(right, "%s", why);
  if (!right) {
    case_print(stdout, pair);
  }
}

static void compare(const case_pair *pair, case_collider *a, case_collider *b, tally *t) {
  gjk_distance_result result;
  reference_result reference;
  if (!case_pair_build(pair, false, a, b) || gjk_distance(&a->collider, &b->collider, NULL, &result) != GJK_OK) {
    CHECK_MSG(false, "%s", pair->id);
    case_print(stdout, pair);
    return;
  }
  reference_query_posed(pair, a, b, &reference);
  t->pairs++;
  t->together += result.intersecting;
  if (result.intersecting != reference.intersecting) {
    t->decisions++;
    judge(pair, a, b, &result);
  } else if (!result.intersecting && !result.saturated) {
    const double error = fabs(reference.distance - result.distance);
    t->error = fmax(t->error, error);
    if (error > tolerance(&result)) {
      t->distances++;
      judge(pair, a, b, &result);
    } else {
      check_passed++;
    }
  } else {
    check_passed++;
  }
}

int main(int argc, char **argv) {
  const uint64_t seed = argc > 1 ? check_seeded(strtoull(argv[1], NULL, 0)) : check_seed(1);
  const unsigned pairs = argc > 2 ? (unsigned)strtoul(argv[2], NULL, 0) : 20000;
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  tally all = {0}, near = {0};
  printf("%u pairs a family\n", pairs);
  for (unsigned f = 0; f < generate_family_count; f++) {
    const generate_family *family = &generate_families[f];
    tally t = {0};
    for (unsigned i = 0; i < pairs; i++) {
      generate_pair(family, seed * 1000003 + i, &pair);
      compare(&pair, &a, &b, &t);
    }
    printf(
        "%-22s %5.1f %% intersect; double decides %5.2f %% wrongly, measures %5.2f %% wrongly, off by up to %.3g LSB\n",
        family->name, 100.0 * t.together / t.pairs, 100.0 * t.decisions / t.pairs, 100.0 * t.distances / t.pairs,
        t.error);
    CHECK_MSG(100 * t.together >= family->least * t.pairs, "%s", family->name);
    CHECK_MSG(100 * t.together <= family->most * t.pairs, "%s", family->name);
    tally *sums[2] = {&all, family->near > 0 ? &near : NULL};
    for (int k = 0; k < 2; k++) {
      if (sums[k] != NULL) {
        sums[k]->pairs += t.pairs;
        sums[k]->decisions += t.decisions;
        sums[k]->distances += t.distances;
      }
    }
  }
  printf("all families: double decides %u of %u wrongly; near touching %u of %u\n", all.decisions, all.pairs,
         near.decisions, near.pairs);
  // The reference must mostly be right, or it would check nothing.
  CHECK(near.pairs > 0);
  CHECK(near.pairs < all.pairs);
  CHECK(all.decisions + all.distances < all.pairs / 4);
  CHECK(all.decisions - near.decisions + all.distances - near.distances < (all.pairs - near.pairs) / 10);
  case_pair_release(&pair, &a, &b);
  return check_done("reference");
}
