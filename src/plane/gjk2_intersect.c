// Yes-or-no queries of the plane: do two shapes touch, are they within a distance?
//
// Every decision is a sign computed exactly, on posed shapes. Rounded before it are the centres of shapes more than
// 16384 units apart, to 2^-28 of their distance (gjk2_search.h), and support points of curved shapes, to an LSB.
#include "gjk2/intersect.h"

#include "gjk2_search.h"

// Does the feature of the last iteration settle the decision without another support scan? Pre: at least one iteration.
static gjk2_outcome plane_settle_decision(gjk2_search *s) {
  gjk2_search_direct(s);
  if ((s->d.x | s->d.y) == 0) {
    return GJK2_OUTCOME_ENCLOSING;
  }
  return s->radius > 0 && gjk2_is_within(-s->base, s->d, s->radius) ? GJK2_OUTCOME_NEAR : GJK2_OUTCOME_LIMIT;
}

// Runs at most `most` iterations; 0: as many as it takes. With a limit the search starts cold, so that the cache does
// not decide what the iterations settle.
// OPEN: only out->iterations is set, and the cache is as it was.
static gjk2_answer plane_decide(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, uint8_t most,
                                gjk2_cache *cache, gjk2_decision *out) {
  gjk2_search s;
  // Convex radii are below 2^28 each, distance is below 2^31: radius < 2^31 + 2^29.
  const uint32_t radius = (uint32_t)a->shape->convex_radius + (uint32_t)b->shape->convex_radius + (uint32_t)distance;
  if (!gjk2_search_start(&s, a, b, true, radius)) {
    out->yes = false;
    out->iterations = 0;
    out->certificate.proof = GJK2_PROOF_CIRCLES;
    out->certificate.count = 0;
    return GJK2_ANSWER_NO;
  }
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && cache != NULL && most == 0) {
    gjk2_search_aim(&s, cache);
  }
  const bool limited = most > 0 && most < gjk2_search_limit(&s);
  s.walks = s.walks && !limited;
  gjk2_outcome outcome = gjk2_search_run(&s, GJK2_GOAL_WITHIN, limited ? most : GJK2_NO_LIMIT);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    outcome = plane_settle_decision(&s);
  }
  if (outcome == GJK2_OUTCOME_LIMIT && !s.curved && s.iterations >= gjk2_search_limit(&s)) {
    outcome = GJK2_OUTCOME_NEAREST;  // a far frame alone
  }
  out->iterations = s.iterations;
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return GJK2_ANSWER_OPEN;
  }
  out->yes = outcome == GJK2_OUTCOME_ENCLOSING || outcome == GJK2_OUTCOME_NEAR;
  gjk2_search_certify(&s, outcome, &out->certificate);
  if (cache != NULL) {
    gjk2_search_keep(&s, outcome, cache);
  }
  return out->yes ? GJK2_ANSWER_YES : GJK2_ANSWER_NO;
}

static gjk_status plane_check(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, const void *out) {
  const gjk_status status = gjk2_check_pair(a, b, out);
  return status == GJK_OK && distance < 0 ? GJK_ERROR_NEGATIVE : status;
}

gjk_status gjk2_within(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, gjk2_cache *cache,
                       gjk2_decision *out) {
  const gjk_status status = plane_check(a, b, distance, out);
  if (status != GJK_OK) {
    return status;
  }
  return plane_decide(a, b, distance, 0, cache, out) == GJK2_ANSWER_OPEN ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk2_within_until(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, uint8_t iterations,
                             gjk2_cache *cache, gjk2_within_result *out) {
  const gjk_status status = plane_check(a, b, distance, out);
  if (status != GJK_OK) {
    return status;
  }
  out->answer = plane_decide(a, b, distance, iterations, cache, &out->decision);
  const bool spent = iterations > 0 && out->decision.iterations == iterations;
  return out->answer == GJK2_ANSWER_OPEN && !spent ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk2_intersect(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_decision *out) {
  return gjk2_within(a, b, 0, cache, out);
}
