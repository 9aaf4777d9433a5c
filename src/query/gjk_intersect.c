// Yes-or-no queries: do two shapes touch, are they within a distance?
//
// Every decision is a sign computed exactly, on posed shapes. Rounded before it are the centres of shapes more than
// 16384 units apart, to 2^-28 of their distance (gjk_frame.h), and support points of curved shapes, to an LSB.
#include "gjk/intersect.h"

#include "../gjk/gjk_search.h"

// Does the feature of the last iteration settle the decision without another support scan? Pre: at least one iteration.
static gjk_outcome settle_decision(gjk_iteration *it) {
  if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
    return GJK_OUTCOME_ENCLOSING;
  }
  return it->radius > 0 && gjk_iteration_near(it) ? GJK_OUTCOME_NEAR : GJK_OUTCOME_LIMIT;
}

// Runs at most `most` iterations. With a limit below GJK_NO_LIMIT the search starts cold, so that the cache does not
// decide what the iterations settle.
// OPEN: only out->iterations is set, and the cache is as it was.
GJK_ONCE static gjk_answer decide(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, uint8_t most,
                                  gjk_cache *cache, gjk_decision *out) {
  gjk_iteration it;
  gjk_outcome outcome = GJK_OUTCOME_SEPARATED;
  // Convex radii are below 2^28 each, distance is below 2^31: radius < 2^31 + 2^29.
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + distance;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_WITHIN, radius)) {
    out->yes = false;
    out->iterations = 0;
    out->certificate.proof = GJK_PROOF_SPHERES;
    out->certificate.count = 0;
    return GJK_ANSWER_NO;
  }
  outcome = gjk_search_any(&it, GJK_GOAL_WITHIN, most == GJK_NO_LIMIT ? cache : NULL, most);
  if (outcome == GJK_OUTCOME_LIMIT) {
    outcome = settle_decision(&it);
  }
  out->iterations = it.iterations;
  if (outcome == GJK_OUTCOME_LIMIT) {
    return GJK_ANSWER_OPEN;
  }
  out->yes = outcome == GJK_OUTCOME_ENCLOSING || outcome == GJK_OUTCOME_NEAR;
  gjk_iteration_certify(&it, outcome, &out->certificate);
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && cache != NULL) {
    gjk_iteration_keep(&it, outcome, cache);
  }
  return out->yes ? GJK_ANSWER_YES : GJK_ANSWER_NO;
}

static gjk_status check(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, const void *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  return status == GJK_OK && distance < 0 ? GJK_ERROR_NEGATIVE : status;
}

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out) {
  const gjk_status status = check(a, b, distance, out);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_answer answer = decide(a, b, distance, GJK_NO_LIMIT, cache, out);
  return answer == GJK_ANSWER_OPEN ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_within_until(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, uint8_t iterations,
                            gjk_cache *cache, gjk_within_result *out) {
  const gjk_status status = check(a, b, distance, out);
  if (status != GJK_OK) {
    return status;
  }
  out->answer = decide(a, b, distance, iterations > 0 ? iterations : GJK_NO_LIMIT, cache, &out->decision);
  const bool spent = iterations > 0 && out->decision.iterations == iterations;
  return out->answer == GJK_ANSWER_OPEN && !spent ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out) {
  return gjk_within(a, b, 0, cache, out);
}
