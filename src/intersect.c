// Yes-or-no queries: do two shapes touch, are they within a distance?
#include "gjk/intersect.h"

#include "pair_search.h"

static gjk_status decide(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                         gjk_decision *out) {
  gjk_iteration it;
  gjk_outcome outcome = GJK_OUTCOME_SEPARATED;
  // At most 2^31 + 2^29.
  const int64_t radius = (int64_t)a->shape->round + b->shape->round + distance;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_WITHIN, radius)) {
    out->yes = false;
    out->iterations = 0;
    out->certificate.proof = GJK_PROOF_SPHERES;
    out->certificate.count = 0;
    return GJK_OK;
  }
  outcome = gjk_search(&it, GJK_GOAL_WITHIN, cache, gjk_search_limit(&it));
  out->iterations = it.rounds;
  if (outcome == GJK_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->yes = outcome == GJK_OUTCOME_ENCLOSING || outcome == GJK_OUTCOME_NEAR;
  gjk_iteration_certify(&it, outcome, &out->certificate);
  if (cache != NULL) {
    gjk_iteration_keep(&it, outcome, cache);
  }
  return GJK_OK;
}

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out) {
  gjk_status status = gjk_check_pair(a, b, out);
  if (status == GJK_OK && distance < 0) {
    status = GJK_ERROR_NEGATIVE;
  }
  return status == GJK_OK ? decide(a, b, distance, cache, out) : status;
}

gjk_status gjk_intersect(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_decision *out) {
  return gjk_within(a, b, 0, cache, out);
}
