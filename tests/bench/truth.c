// The true answers to pairs.
#include "truth.h"

#include <math.h>
#include <stdio.h>

#include "../case/case.h"
#include "../exact/depth.h"
#include "../reference/reference.h"

#define VERTICES 4096
#define CELLS GJK_POLYTOPE_CELLS(VERTICES)

// Directions that brute force tries in no time; and in a tenth of a second.
#define QUICK_DIRECTIONS 4000
#define THOROUGH_DIRECTIONS 500000

static double radii(const bench_pair *pair) {
  return (double)pair->a->collider.shape->round + pair->b->collider.shape->round;
}

// Of the named feature's line or plane from the origin; negative: it names none.
static double feature_distance(const bench_pair *pair, const gjk_certificate *certificate) {
  exact_feature feature;
  if (!exact_named_feature(&pair->a->collider, &pair->b->collider, certificate, &feature)) {
    return -1;
  }
  return sqrt(exact_to_double(&feature.squared) / exact_to_double(&feature.denominator));
}

bool bench_find_distance(bench_pair *pair, char *why, size_t n) {
  const gjk_collider *a = &pair->a->collider, *b = &pair->b->collider;
  gjk_distance_result gap;
  if (gjk_distance(a, b, NULL, &gap) != GJK_OK || !exact_check_distance(a, b, &gap, why, n)) {
    return false;
  }
  pair->intersecting = gap.intersecting;
  pair->distance = 0;
  if (!gap.intersecting) {
    const double cores = feature_distance(pair, &gap.certificate);
    pair->distance = cores - radii(pair);
    return cores >= 0 || snprintf(why, n, "no feature") < 0;
  }
  return true;
}

static double plane_depth(const bench_pair *pair, const gjk_certificate *certificate) {
  const double cores = certificate->proof == GJK_PROOF_PLANE ? 0 : feature_distance(pair, certificate);
  return radii(pair) + (certificate->proof == GJK_PROOF_NEAREST ? -cores : cores);
}

bench_depth_proof bench_find_depth(bench_pair *pair, bool thorough, char *why, size_t n) {
  static gjk_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  const gjk_collider *a = &pair->a->collider, *b = &pair->b->collider;
  gjk_penetration_result found;
  exact_overlap overlap;
  if (gjk_penetration(a, b, NULL, &workspace, &found) != GJK_OK || !found.intersecting ||
      !exact_check_penetration(a, b, &found, why, n)) {
    return BENCH_DEPTH_UNPROVEN;
  }
  pair->distance = -plane_depth(pair, &found.certificate);
  if (exact_depth_work(a, b) <= (thorough ? THOROUGH_DIRECTIONS : QUICK_DIRECTIONS) &&
      exact_overlap_find(a, b, &overlap)) {
    snprintf(why, n, "depth %ld, by brute force %ld", (long)found.depth, (long)overlap.depth);
    return overlap.intersecting && overlap.depth == found.depth ? BENCH_DEPTH_BRUTE : BENCH_DEPTH_UNPROVEN;
  }
  reference_result reference;
  reference_signed_posed(pair->shapes, pair->a, pair->b, &reference);
  snprintf(why, n, "depth %.4f, but double knows of %.4f", -pair->distance, -reference.distance);
  // What double's rounding may make of it.
  const double slack = 1e-3 - 1e-9 * pair->distance;
  return reference.distance <= pair->distance + slack ? BENCH_DEPTH_CERTIFIED : BENCH_DEPTH_UNPROVEN;
}
