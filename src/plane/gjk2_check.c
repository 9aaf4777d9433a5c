// Checks answers of the plane by exact integers alone.
//
//   1. Find the vertices of A - B that the certificate names.
//   2. Prove the decision from them: a line that no vertex of A - B lies before, or a feature that comes near enough.
//      Each vertex is visited once.
//   3. Prove the distance: the named feature's exact distance rounds to it. Or the depth: the named edge's exact height,
//      and that no edge of A - B is lower.
//   4. Prove the normal, to 2^-28, and the points, to 1 LSB of their shapes (gjk2_claim.c).
//   5. Prove that moving B by the depth along the normal parts the shapes.
// Where a step searches for a certificate of its own, it proves that certificate in the same way.
#include "gjk2/check.h"

#include "gjk2_claim.h"
#include "gjk2_edges.h"
#include "gjk2_outward.h"

// The largest offset . d of the collider's vertices.
static int64_t plane_farthest(const gjk2_collider *c, gjk2_vec d) {
  int64_t largest = INT64_MIN;
  gjk2_vec offset;
  for (uint32_t i = 0; i < c->count; i++) {
    if (!c->shape->type->vertex(c, (uint16_t)i, &offset)) {
      break;  // not reached: there are count
    }
    const int64_t along = gjk2_dot(offset, d);
    largest = along > largest ? along : largest;
  }
  return largest;
}

// The largest d . w of A - B.
static int64_t support(const gjk2_search *s, gjk2_vec d) {
  return gjk2_dot(s->delta, d) + plane_farthest(s->a, d) + plane_farthest(s->b, gjk2_negate(d));
}

// Step 1. False when a named vertex does not exist, or more than most are named.
static bool load_named(gjk2_search *s, const gjk2_certificate *certificate, unsigned most) {
  if (certificate->count < 1 || certificate->count > most) {
    return false;
  }
  for (unsigned i = 0; i < certificate->count; i++) {
    if (!gjk2_search_place(s, certificate->a[i], certificate->b[i], &s->slot[i])) {
      return false;
    }
  }
  return true;
}

// Does the origin's foot on the edge from p to q lie between them?
static bool has_foot(const gjk2_vec *p, const gjk2_vec *q) {
  const gjk2_vec edge = gjk2_sub(*q, *p);
  return gjk2_dot(*p, edge) < 0 && gjk2_dot(*q, edge) > 0;
}

// Makes one or two named vertices the feature: its direction d and base. False: they are no feature, or at the origin.
static bool plane_set_feature(gjk2_search *s, const gjk2_certificate *certificate) {
  if (!load_named(s, certificate, 2)) {
    return false;
  }
  const gjk2_vec *p = &s->slot[0].w;
  s->count = certificate->count;
  if (s->count == 1) {
    s->d = gjk2_negate(*p);
    s->base = -gjk2_dot(*p, *p);
    return s->base < 0;
  }
  const gjk2_vec *q = &s->slot[1].w;
  s->d = gjk2_outward(gjk2_sub(*q, *p));
  s->base = gjk2_cross(*p, *q);
  return s->base < 0 && has_foot(p, q);
}

// Step 2: is the named feature the one of A - B nearest to the origin, and not at the origin?
static bool plane_is_nearest(gjk2_search *s, const gjk2_certificate *certificate) {
  return plane_set_feature(s, certificate) && support(s, s->d) == s->base;
}

// Does the segment from p to q hold the origin?
static bool holds_origin(const gjk2_vec *p, const gjk2_vec *q) {
  return gjk2_cross(*p, *q) == 0 && gjk2_dot(*p, *q) <= 0;
}

// Step 2: do the named vertices contain the origin?
static bool plane_is_enclosing(gjk2_search *s, const gjk2_certificate *certificate) {
  if (!load_named(s, certificate, 3)) {
    return false;
  }
  const gjk2_vec *p = &s->slot[0].w;
  const gjk2_vec *q = certificate->count > 1 ? &s->slot[1].w : p, *r = certificate->count > 2 ? &s->slot[2].w : p;
  if (holds_origin(p, q) || holds_origin(q, r) || holds_origin(r, p)) {
    return true;
  }
  const int a = gjk_sign64(gjk2_cross(*p, *q)), b = gjk_sign64(gjk2_cross(*q, *r)), c = gjk_sign64(gjk2_cross(*r, *p));
  return a != 0 && a == b && b == c;
}

// Step 2: does the named feature come within the radius?
static bool plane_proves_near(gjk2_search *s, const gjk2_certificate *certificate) {
  if (!load_named(s, certificate, 2)) {
    return false;
  }
  if (certificate->count == 2 && gjk2_cross(s->slot[0].w, s->slot[1].w) > 0) {
    gjk2_copy_vertex(&s->slot[2], &s->slot[0]);
    gjk2_copy_vertex(&s->slot[0], &s->slot[1]);
    gjk2_copy_vertex(&s->slot[1], &s->slot[2]);
  }
  const gjk2_vec *p = &s->slot[0].w, *q = &s->slot[1].w;
  if (certificate->count == 1) {
    const gjk2_vec d = gjk2_negate(*p);
    return gjk2_norm1(*p) == 0 || gjk2_is_within(gjk2_dot(d, d), d, s->radius);
  }
  return has_foot(p, q) && gjk2_is_within(-gjk2_cross(*p, *q), gjk2_outward(gjk2_sub(*q, *p)), s->radius);
}

// Step 2: does the line across direction keep all of A - B more than radius away from the origin?
//   direction   components beyond 3 2^29 and lengths from 2^31 on are never reported
//   along       |d| < 2^31, |w| <= 3 2^29:   below 2^62
static bool direction_separates(const gjk2_search *s, const gjk2_vec *direction, int64_t radius) {
  const gjk2_vec d = {direction->x, direction->y};
  const uint32_t limit = UINT32_C(3) << 29;
  if (gjk_magnitude32(d.x) > limit || gjk_magnitude32(d.y) > limit || (uint64_t)gjk2_dot(d, d) >= UINT64_C(1) << 62 ||
      radius > INT32_MAX) {
    return false;
  }
  const int64_t along = support(s, d);
  return along < 0 && !gjk2_is_within(-along, d, (int32_t)radius);
}

static bool plane_is_apart(gjk2_search *s, const gjk2_certificate *certificate, int64_t radius) {
  if (certificate->proof == GJK2_PROOF_DIRECTION) {
    return direction_separates(s, &certificate->direction, radius);
  }
  return certificate->proof == GJK2_PROOF_NEAREST && plane_is_nearest(s, certificate) &&
         !gjk2_is_within(-s->base, s->d, s->radius);
}

static bool plane_is_together(gjk2_search *s, const gjk2_certificate *certificate) {
  if (certificate->proof == GJK2_PROOF_NEAR) {
    return plane_proves_near(s, certificate);
  }
  return certificate->proof == GJK2_PROOF_ENCLOSING && plane_is_enclosing(s, certificate);
}

gjk_status gjk2_check_decision(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance,
                               const gjk2_decision *decision) {
  gjk2_search s;
  const gjk_status status = gjk2_check_pair(a, b, decision);
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  const gjk2_certificate *certificate = &decision->certificate;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + distance;
  if (!gjk2_search_start(&s, a, b, true, (uint32_t)radius)) {
    return decision->yes ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (!gjk2_search_is_exact(&s)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const bool proven = decision->yes ? plane_is_together(&s, certificate) : plane_is_apart(&s, certificate, radius);
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}

// May saturation explain points that are not where the certificate has them? At least one must have a coordinate at an
// end of Q16.16 that its named vertices reach. The other must be on its shape, or saturated too.
static bool plane_may_be_saturated(const gjk2_search *s, const gjk2_certificate *c, const gjk2_vec *a, bool on_a,
                                   const gjk2_vec *b, bool on_b) {
  const bool saturated_a = gjk2_claim_saturated(s->a, c->a, c->count, a),
             saturated_b = gjk2_claim_saturated(s->b, c->b, c->count, b);
  return (saturated_a || saturated_b) && (on_a || saturated_a) && (on_b || saturated_b);
}

// Step 4: are the points on their shapes and as far apart as the distance, or saturated? Pre: the certificate holds.
static bool plane_are_nearest(const gjk2_search *s, const gjk2_length *length, const gjk2_distance_result *result) {
  const gjk2_certificate *c = &result->certificate;
  const bool on_a = gjk2_claim_point(s->a, c->a, c->count, &result->point_a),
             on_b = gjk2_claim_point(s->b, c->b, c->count, &result->point_b);
  if (!result->saturated) {
    return on_a && on_b &&
           gjk2_claim_gap(length, (uint64_t)-s->base, gjk2_convex_radii(s), &result->point_a, &result->point_b);
  }
  return plane_may_be_saturated(s, c, &result->point_a, on_a, &result->point_b, on_b);
}

gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result) {
  gjk2_search s;
  const gjk_status status = gjk2_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const gjk2_certificate *certificate = &result->certificate;
  (void)gjk2_search_start(&s, a, b, false, (uint32_t)(a->shape->convex_radius + b->shape->convex_radius));
  if (!gjk2_search_is_exact(&s)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (result->lower != result->distance || result->upper != result->distance) {
    return GJK_ERROR_UNPROVEN;
  }
  bool proven;
  if (result->intersecting) {
    proven = result->distance == 0 && !result->saturated && plane_is_together(&s, certificate);
  } else {
    gjk2_length length;
    proven = certificate->proof == GJK2_PROOF_NEAREST && plane_is_nearest(&s, certificate) &&
             !gjk2_is_within(-s.base, s.d, s.radius);
    if (proven) {
      gjk2_length_set(&length, s.d);
      proven = gjk2_round_distance(&length, GJK2_ROUND_NEAREST, (uint64_t)-s.base) - gjk2_convex_radii(&s) ==
                   result->distance &&
               gjk2_claim_normal(s.d, &result->normal) && plane_are_nearest(&s, &length, result);
    }
  }
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}

// Do the cores intersect? Proven by a decision of the check's own.
static bool cores_intersect(gjk2_search *s) {
  gjk2_certificate own;
  gjk2_search_aim(s, NULL);
  const gjk2_outcome outcome = gjk2_search_run(s, GJK2_GOAL_SIGNED, GJK2_NO_LIMIT);
  gjk2_search_certify(s, outcome, &own);
  return outcome == GJK2_OUTCOME_ENCLOSING && plane_is_enclosing(s, &own);
}

// Step 3: the line that bounds A - B, n . w <= height, and the depth that follows from it.
static bool plane_is_depth(gjk2_search *s, const gjk2_penetration_result *result, gjk2_vec *n, int64_t *height) {
  const gjk2_certificate *c = &result->certificate;
  gjk2_length length;
  gjk2_edge lowest;
  const int64_t core = (int64_t)result->depth - gjk2_convex_radii(s);
  switch (c->proof) {
    case GJK2_PROOF_NEAREST:
      if (!plane_is_nearest(s, c) || !gjk2_is_within(-s->base, s->d, s->radius)) {
        return false;
      }
      gjk2_copy(n, &s->d);
      *height = s->base;
      gjk2_length_set(&length, *n);
      return -core == gjk2_round_distance(&length, GJK2_ROUND_DOWN, (uint64_t)-s->base);
    case GJK2_PROOF_LINE:
      gjk2_copy(n, &c->direction);
      *height = 0;
      return core == 0 && load_named(s, c, 1) && gjk2_norm1(s->slot[0].w) == 0 && gjk2_norm1(*n) != 0 &&
             gjk_magnitude32(n->x) <= UINT32_C(1) << 30 && gjk_magnitude32(n->y) <= UINT32_C(1) << 30 &&
             support(s, *n) == 0;
    case GJK2_PROOF_EDGE: break;
    default: return false;
  }
  if (c->count != 2 || !load_named(s, c, 2)) {
    return false;
  }
  const gjk2_vec *p = &s->slot[0].w, *q = &s->slot[1].w;
  *n = gjk2_outward(gjk2_sub(*q, *p));
  *height = gjk2_cross(*p, *q);
  if (gjk2_norm1(*n) == 0 || *height < 0 || support(s, *n) != *height || !cores_intersect(s)) {
    return false;
  }
  gjk2_length_set(&length, *n);
  return core == gjk2_round_distance(&length, GJK2_ROUND_UP, (uint64_t)*height) &&
         gjk2_nearest_edge(s, &lowest) == GJK2_LIE_OVERLAP && !gjk2_edge_is_lower(&lowest, (uint64_t)*height, &length);
}

// Step 4: are the points on their shapes and depth apart against the normal, or saturated?
static bool plane_coincide(const gjk2_search *s, const gjk2_penetration_result *result) {
  const gjk2_certificate *c = &result->certificate;
  const bool on_a = gjk2_claim_point(s->a, c->a, c->count, &result->point_a),
             on_b = gjk2_claim_point(s->b, c->b, c->count, &result->point_b);
  if (on_a && on_b && gjk2_claim_overlap(result->depth, &result->normal, &result->point_a, &result->point_b)) {
    return true;
  }
  return plane_may_be_saturated(s, c, &result->point_a, on_a, &result->point_b, on_b);
}

gjk_status gjk2_check_penetration(const gjk2_collider *a, const gjk2_collider *b,
                                  const gjk2_penetration_result *result) {
  gjk2_search s;
  gjk2_vec n;
  int64_t height;
  const gjk_status status = gjk2_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  if (!gjk2_search_start(&s, a, b, true, (uint32_t)radius)) {
    return result->intersecting ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (!gjk2_search_is_exact(&s)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  bool proven;
  if (!result->intersecting) {
    proven = plane_is_apart(&s, &result->certificate, radius);
  } else {
    proven = result->depth >= 0 && result->depth <= a->radius + b->radius && result->lower == result->depth &&
             result->upper == result->depth && plane_is_depth(&s, result, &n, &height) &&
             gjk2_claim_normal(n, &result->normal) && plane_coincide(&s, result) &&
             gjk2_outward_clears(n, height, radius, gjk2_outward_move(result->depth, result->normal));
  }
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}
