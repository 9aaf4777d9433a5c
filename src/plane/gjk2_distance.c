// The distance query of the plane: how far apart, and where.
//
//   1. Search for the feature of A - B nearest to the origin (gjk2_search.h). The search stops where the cores come
//      within the convex radii, exactly: then the shapes intersect.
//   2. Round the feature's distance, exactly.
//   3. Find the nearest points.
// Out of iterations:
//   4. Bound the distance by the last support line and by the feature so far, and report the feature as in 2 and 3.
//
// What is rounded:
//   normal     each component within 2 LSB of Q2.30
//   step 2     to the nearest LSB, a tie up. Far pairs measure vertices that are rounded to 2^far LSB: 2^-28 relative
//   points     per component to the nearest LSB, within 1 LSB of the shape
//   step 4     outwards
#include "gjk2/distance.h"

#include "gjk2_canonical.h"
#include "gjk2_measure_inline.h"
#include "gjk2_recall.h"
#include "gjk2_report.h"
#include "gjk2_witness.h"

// h / |n| in LSB in a far frame, not exactly: the quotient's error is below 2^-28 of it.
GJK_OUT_OF_LINE static int64_t far_in_lsb(const gjk2_search *s, const gjk2_length *length, int64_t h,
                                          gjk2_round_to to) {
  unsigned shift;
  const uint64_t quotient = gjk2_quotient(length, &shift, (uint64_t)h);
  if (shift >= 62) {
    return 0;  // below 4 units of the frame
  }
  // Distances in far frames are 2^27 units at least, so shift is more than 4.
  const unsigned n = shift > s->far ? shift - s->far : 1;
  const int64_t nearest = (int64_t)((quotient + (UINT64_C(1) << (n - 1))) >> n);
  return nearest + (to == GJK2_ROUND_NEAREST ? 0 : to == GJK2_ROUND_UP ? gjk_shl32(8, s->far) : -gjk_shl32(8, s->far));
}

// h / |n| in LSB.
static inline int64_t in_lsb(const gjk2_search *s, const gjk2_length *length, int64_t h, gjk2_round_to to) {
  return s->far == 0 ? gjk2_quick_distance(length, to, (uint64_t)h) : far_in_lsb(s, length, h, to);
}

gjk2_outcome gjk2_distance_bounds(gjk2_search *s, int64_t *lower, int64_t *nearest, int64_t *upper) {
  const int64_t radii = gjk2_convex_radii(s);
  gjk2_length length;
  gjk2_length_set(&length, s->d);
  *lower = s->along < 0 ? in_lsb(s, &length, -s->along, GJK2_ROUND_DOWN) : -in_lsb(s, &length, s->along, GJK2_ROUND_UP);
  *lower -= radii + (s->curved ? GJK2_CURVED_ERROR : 0);
  gjk2_search_direct(s);
  if ((s->d.x | s->d.y) == 0) {
    *nearest = -radii;
    *upper = -radii;
    return GJK2_OUTCOME_ENCLOSING;
  }
  gjk2_length_set(&length, s->d);
  *nearest = in_lsb(s, &length, -s->base, GJK2_ROUND_NEAREST) - radii;
  *upper = in_lsb(s, &length, -s->base, GJK2_ROUND_UP) - radii;
  return *upper <= 0 ? GJK2_OUTCOME_NEAR : GJK2_OUTCOME_LIMIT;
}

// Step 3: normal and points of the feature. Returns whether a coordinate has saturated.
GJK_ONCE static bool report_feature(const gjk2_search *s, gjk2_length *length, gjk2_distance_result *out) {
  const gjk2_vertex *p = s->apex, *q = NULL;
  if (s->count == 2) {
    p = s->first;
    q = s->last;
  }
  gjk2_quick_normal(&out->normal, length, &s->d);
  return gjk2_witness_points(s, p, q, length, &out->normal, &out->point_a, &out->point_b);
}

// Step 2
static inline gjk_q16 round_gap(const gjk2_search *s, const gjk2_length *length, bool *saturated) {
  const int64_t core = in_lsb(s, length, -s->base, GJK2_ROUND_NEAREST);
  gjk_q16 distance;
  if (s->far == 0) {
    distance = (int32_t)core - s->radius;  // radius is that of both shapes;  0 <= core <= 3 2^29
  } else {
    distance = gjk_saturate_noting(core - gjk2_convex_radii(s), saturated);
  }
  return distance > 0 ? distance : 0;
}

gjk_q16 gjk2_distance_of(const gjk2_search *s, const gjk2_length *length, bool *saturated) {
  return round_gap(s, length, saturated);
}

void gjk2_distance_report(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache, gjk2_distance_result *out) {
  gjk_q16 distance = 0;
  bool saturated = false;
  if (outcome == GJK2_OUTCOME_NEAREST) {
    gjk2_length length;
    saturated = report_feature(s, &length, out);
    distance = round_gap(s, &length, &saturated);
  }
  out->distance = distance;
  out->lower = distance;
  out->upper = distance;
  out->intersecting = outcome != GJK2_OUTCOME_NEAREST;
  out->saturated = saturated;
  out->iterations = s->iterations;
  gjk2_search_certify(s, outcome, &out->certificate);
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
}

// Step 4: narrows the bounds by what the last iteration proves, which may settle the question.
static gjk2_outcome plane_narrow(gjk2_search *s, gjk2_distance_result *out) {
  int64_t lower, nearest, upper;
  const gjk2_outcome outcome = gjk2_distance_bounds(s, &lower, &nearest, &upper);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    out->lower = lower > out->lower ? gjk_saturate(lower) : out->lower;
    out->upper = gjk_saturate(upper);
    out->distance = s->far == 0 ? gjk_saturate(nearest > 0 ? nearest : 0) : out->upper;
  }
  return outcome;
}

// Step 1: what follows from the outcome LIMIT. Narrows the bounds.
GJK_OUT_OF_LINE static gjk2_outcome settle_limit(gjk2_search *s, gjk2_distance_result *out) {
  const gjk2_outcome narrowed = plane_narrow(s, out);
  const bool exhausted = !s->curved && s->iterations >= gjk2_search_limit(s);  // a far frame alone
  return narrowed == GJK2_OUTCOME_LIMIT && exhausted ? GJK2_OUTCOME_NEAREST : narrowed;
}

// Step 4: reports the nearest points so far, beside the bounds.
void gjk2_distance_stop(const gjk2_search *s, gjk2_distance_result *out) {
  gjk2_length length;
  out->saturated = report_feature(s, &length, out);
  out->intersecting = false;
  out->iterations = s->iterations;
  out->certificate.proof = GJK2_PROOF_NONE;
  out->certificate.count = 0;
}

static void plane_start_distance(gjk2_search *s, const gjk2_collider *a, const gjk2_collider *b) {
  (void)gjk2_search_start(s, a, b, false, (uint32_t)(a->shape->convex_radius + b->shape->convex_radius));
}

static void start_bounds(gjk2_distance_result *out) {
  out->lower = 0;
  out->upper = GJK2_DISTANCE_MAX;
}

gjk2_outcome gjk2_distance_settle(gjk2_search *s, gjk2_distance_result *out) {
  start_bounds(out);
  return settle_limit(s, out);
}

static inline gjk_status distance_by_search(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                            gjk2_distance_result *out) {
  gjk2_search s;
  plane_start_distance(&s, a, b);
  if (cache != NULL) {
    gjk2_search_aim(&s, cache);
  }
  gjk2_outcome outcome = gjk2_search_feature(&s, GJK2_GOAL_DISTANCE, GJK2_NO_LIMIT);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    outcome = gjk2_distance_settle(&s, out);
    if (outcome == GJK2_OUTCOME_LIMIT) {
      gjk2_distance_stop(&s, out);
      return GJK_ERROR_ITERATION_LIMIT;
    }
  }
  gjk2_distance_report(&s, outcome, cache, out);
  return GJK_OK;
}

gjk_status gjk2_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_distance_result *out) {
  const gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  if (gjk2_recalls(a, b, cache, GJK2_TOUCH_POINTS, out)) {
    return GJK_OK;
  }
  if (gjk2_touch_without_search(a, b, GJK2_TOUCH_POINTS, out)) {
    gjk2_touch_keep(out, cache);
    return GJK_OK;
  }
  return distance_by_search(a, b, cache, out);
}

gjk_status gjk2_distance_until(const gjk2_collider *a, const gjk2_collider *b, const gjk2_effort *effort,
                               gjk2_cache *cache, gjk2_distance_result *out) {
  const gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK || effort == NULL) {
    return status != GJK_OK ? status : GJK_ERROR_NULL;
  }
  if (effort->error < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  gjk2_search s;
  plane_start_distance(&s, a, b);
  start_bounds(out);
  s.walks = false;
  const uint32_t ceiling = gjk2_search_limit(&s);
  const bool limited = effort->iterations > 0 && effort->iterations < ceiling;
  const uint32_t most = limited ? effort->iterations : ceiling;
  bool spent;
  // Each turn is one iteration, so there are at most `most` turns.
  do {
    gjk2_outcome outcome = gjk2_search_feature(&s, GJK2_GOAL_DISTANCE, s.iterations + UINT32_C(1));
    outcome = outcome == GJK2_OUTCOME_LIMIT ? settle_limit(&s, out) : outcome;
    if (outcome != GJK2_OUTCOME_LIMIT) {
      gjk2_distance_report(&s, outcome, cache, out);
      return GJK_OK;
    }
    spent = effort->error > 0 && out->upper - out->lower <= effort->error;
  } while (!spent && s.iterations < most);
  gjk2_distance_stop(&s, out);
  return spent || limited ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}
