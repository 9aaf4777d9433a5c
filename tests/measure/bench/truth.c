// Finds the true answers to pairs.
#include "truth.h"

#include <math.h>
#include <stdio.h>

#include "case/case.h"
#include "exact/depth.h"
#include "reference/reference.h"

#define VERTICES 4096
#define CELLS GJK_EPA_CELLS(VERTICES)

// Most directions for brute force: what takes no time, and what takes a tenth of a second.
#define QUICK_DIRECTIONS 4000
#define THOROUGH_DIRECTIONS 500000

// LSB: the error of a depth in double here.
#define SLACK 1e-3

static double radii(const bench_pair *pair) {
  return (double)pair->a->collider.shape->convex_radius + pair->b->collider.shape->convex_radius;
}

// The distance of the line or plane of the named feature from the origin; negative: none is named.
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

// Finds the real depth by a trial of all directions. If the cores are apart, by the feature that the certificate proves
// nearest.
static bool find_exact(const bench_pair *pair, const gjk_certificate *certificate, bool thorough, double *depth) {
  const gjk_collider *a = &pair->a->collider, *b = &pair->b->collider;
  exact_plane plane;
  if (certificate->proof == GJK_PROOF_NEAREST) {
    *depth = radii(pair) - feature_distance(pair, certificate);
    return true;
  }
  if (exact_vertex_count(a) > EXACT_DEPTH_VERTICES || exact_vertex_count(b) > EXACT_DEPTH_VERTICES ||
      exact_depth_work(a, b) > (thorough ? THOROUGH_DIRECTIONS : QUICK_DIRECTIONS) || !exact_depth(a, b, &plane)) {
    return false;
  }
  *depth = radii(pair) + exact_plane_height(&plane);
  return true;
}

bench_depth_proof bench_find_depth(bench_pair *pair, bool thorough, char *why, size_t n) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  const gjk_collider *a = &pair->a->collider, *b = &pair->b->collider;
  gjk_penetration_result found;
  if (gjk_penetration(a, b, NULL, &workspace, &found) != GJK_OK || !found.intersecting ||
      !exact_check_penetration(a, b, &found, why, n)) {
    return BENCH_DEPTH_UNPROVEN;
  }
  double depth;
  const bool exact = find_exact(pair, &found.certificate, thorough, &depth);
  if (!exact) {
    // Takes the facet of the certificate. The reference must know of none that is lower by more than its rounding.
    reference_result reference;
    reference_signed_posed(pair->shapes, pair->a, pair->b, &reference);
    depth = radii(pair) + (found.certificate.proof == GJK_PROOF_PLANE ? 0 : feature_distance(pair, &found.certificate));
    depth = fmin(depth, -reference.distance);
  }
  pair->distance = -depth;
  snprintf(why, n, "depth %ld, but it is %.6f", (long)found.depth, depth);
  // The answer must be the real depth, rounded up, to within the error of double.
  const bool least = depth > found.depth - 1 - SLACK && depth <= found.depth + SLACK;
  return !least ? BENCH_DEPTH_UNPROVEN : exact ? BENCH_DEPTH_EXACT : BENCH_DEPTH_CERTIFIED;
}
