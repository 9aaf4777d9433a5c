// The penetration and the signed distance queries of the plane: reports of how two shapes meet (gjk2_meeting.h).
#include "gjk2/penetration.h"

#include "gjk2_canonical.h"
#include "gjk2_meeting.h"
#include "gjk2_recall.h"
#include "gjk2_report.h"

static void report_plane_depth(const gjk2_meeting *m, gjk2_penetration_result *out) {
  out->intersecting = true;
  out->iterations = m->s.iterations;
  out->depth = -m->distance;
  out->lower = -m->upper;
  out->upper = -m->lower;
  out->normal.x = m->normal.x;
  out->normal.y = m->normal.y;
  (void)gjk2_meeting_points(m, &out->point_a, &out->point_b);
  gjk2_meeting_certify(m, &out->certificate);
}

// Does the cached direction separate the shapes?
static bool separates(gjk2_search *s, const gjk2_cache *cache, int32_t radius) {
  gjk2_vertex x;
  if (cache == NULL || s->curved || (cache->direction[0] | cache->direction[1]) == 0) {
    return false;
  }
  s->d.x = cache->direction[0];
  s->d.y = cache->direction[1];
  gjk2_search_scan(s, s->d, &x);
  s->iterations++;
  s->along = gjk2_dot(s->d, x.w);
  return s->along < 0 && (radius == 0 || !gjk2_is_within(-s->along, s->d, radius));
}

static gjk_status report_apart(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache,
                               gjk2_penetration_result *out) {
  out->intersecting = false;
  out->iterations = s->iterations;
  gjk2_search_certify(s, outcome, &out->certificate);
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
  return GJK_OK;
}

static void report_touch_depth(const gjk2_distance_result *touch, gjk2_penetration_result *out) {
  const gjk2_certificate *c = &touch->certificate;
  out->intersecting = touch->intersecting;
  out->iterations = 1;
  gjk2_copy(&out->certificate.direction, &c->direction);
  out->certificate.count = c->count;
  out->certificate.proof = c->proof;
  for (unsigned i = 0; i < c->count; i++) {
    out->certificate.a[i] = c->a[i];
    out->certificate.b[i] = c->b[i];
  }
  if (touch->intersecting) {
    out->depth = -touch->distance;
    out->lower = out->depth;
    out->upper = out->depth;
    out->normal.x = touch->normal.x;
    out->normal.y = touch->normal.y;
    gjk2_copy(&out->point_a, &touch->point_a);
    gjk2_copy(&out->point_b, &touch->point_b);
  }
}

gjk_status gjk2_penetration(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                            gjk2_penetration_result *out) {
  gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  gjk2_distance_result touch;
  if (gjk2_touch_without_search(a, b, GJK2_TOUCH_DEPTH, &touch)) {
    gjk2_touch_keep(&touch, cache);
    report_touch_depth(&touch, out);
    return GJK_OK;
  }
  gjk2_meeting m;
  gjk2_search *s = &m.s;
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  if (!gjk2_search_start(s, a, b, true, (uint32_t)radius)) {
    out->intersecting = false;
    out->iterations = 0;
    out->certificate.proof = GJK2_PROOF_CIRCLES;
    out->certificate.count = 0;
    return GJK_OK;
  }
  if (separates(s, cache, radius)) {
    return report_apart(s, GJK2_OUTCOME_SEPARATED, cache, out);
  }
  const gjk2_lie lie = gjk2_meeting_edges(&m);
  if (lie == GJK2_LIE_APART && radius == 0) {
    return report_apart(s, GJK2_OUTCOME_SEPARATED, cache, out);
  }
  const gjk2_outcome outcome =
      lie == GJK2_LIE_OVERLAP ? GJK2_OUTCOME_ENCLOSING : gjk2_meeting_search(&m, GJK2_GOAL_DEPTH, lie, cache);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  if (outcome == GJK2_OUTCOME_SEPARATED || (outcome == GJK2_OUTCOME_NEAREST && !gjk2_meeting_gap(&m))) {
    return report_apart(s, outcome, cache, out);
  }
  if (outcome == GJK2_OUTCOME_ENCLOSING) {
    status = gjk2_meeting_overlap(&m, lie);
  }
  report_plane_depth(&m, out);
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
  return status;
}

static gjk_status report_limit(gjk2_search *s, gjk2_distance_result *out) {
  int64_t lower, nearest, upper;
  (void)gjk2_distance_bounds(s, &lower, &nearest, &upper);
  out->lower = gjk_saturate(lower);
  out->upper = gjk_saturate(upper);
  out->iterations = s->iterations;
  return GJK_ERROR_ITERATION_LIMIT;
}

gjk_status gjk2_signed_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                gjk2_distance_result *out) {
  gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  if (gjk2_recalls(a, b, cache, GJK2_TOUCH_ALL, out)) {
    return GJK_OK;
  }
  if (gjk2_touch_without_search(a, b, GJK2_TOUCH_ALL, out)) {
    gjk2_touch_keep(out, cache);
    return GJK_OK;
  }
  gjk2_meeting m;
  status = gjk2_meet(&m, a, b, cache);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return report_limit(&m.s, out);
  }
  out->distance = m.distance;
  out->lower = m.lower;
  out->upper = m.upper;
  out->normal.x = m.normal.x;
  out->normal.y = m.normal.y;
  out->intersecting = m.overlaps;
  const bool beyond = gjk2_meeting_points(&m, &out->point_a, &out->point_b);
  out->saturated = !m.overlaps && (beyond || m.saturated);
  out->iterations = m.s.iterations;
  if (m.overlaps) {
    gjk2_meeting_certify(&m, &out->certificate);
  } else {
    gjk2_search_certify(&m.s, GJK2_OUTCOME_NEAREST, &out->certificate);
  }
  return status;
}
