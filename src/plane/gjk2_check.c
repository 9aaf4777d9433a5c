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

// The largest d . w of A - B.
static int64_t support(const gjk2_search *s, gjk2_vec d) {
  return gjk2_dot(s->delta, d) + gjk2_claim_farthest(s->a, d) + gjk2_claim_farthest(s->b, gjk2_negate(d));
}

// The vertex of A - B with these offsets from the centres. Pre: a near frame.
static gjk2_vec plane_difference(gjk2_vec delta, gjk2_vec of_a, gjk2_vec of_b) {
  return gjk2_add(delta, gjk2_sub(of_a, of_b));
}

// The vertex of A - B of this name. False when it does not exist.
static bool plane_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vec *out) {
  gjk2_vec of_a, of_b;
  if (!s->a->shape->type->vertex(s->a, a, &of_a) || !s->b->shape->type->vertex(s->b, b, &of_b)) {
    return false;
  }
  const gjk2_vec w = plane_difference(s->delta, of_a, of_b);
  out->x = w.x;
  out->y = w.y;
  return true;
}

// Step 1: writes the named vertices. False when one of them does not exist, or more than most are named.
static bool load_named(const gjk2_search *s, const gjk2_certificate *certificate, unsigned most, gjk2_vec *out) {
  if (certificate->count < 1 || certificate->count > most) {
    return false;
  }
  for (unsigned i = 0; i < certificate->count; i++) {
    if (!plane_place(s, certificate->a[i], certificate->b[i], &out[i])) {
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
  gjk2_vec w[2];
  if (!load_named(s, certificate, 2, w)) {
    return false;
  }
  // d is written by component: after a whole vector is written, the proof has lost what lies beside it.
  if (certificate->count == 1) {
    s->d.x = -w[0].x;
    s->d.y = -w[0].y;
    s->base = -gjk2_dot(w[0], w[0]);
    return s->base < 0;
  }
  s->d.x = w[1].y - w[0].y;
  s->d.y = w[0].x - w[1].x;
  s->base = gjk2_cross(w[0], w[1]);
  return s->base < 0 && has_foot(&w[0], &w[1]);
}

// Step 2: is the named feature the one of A - B nearest to the origin, and not at the origin?
static bool plane_is_nearest(gjk2_search *s, const gjk2_certificate *certificate) {
  return plane_set_feature(s, certificate) && support(s, s->d) == s->base;
}

// Does the segment from p to q hold the origin?
static bool holds_origin(const gjk2_vec *p, const gjk2_vec *q) {
  return gjk2_cross(*p, *q) == 0 && gjk2_dot(*p, *q) <= 0;
}

// Does the triangle hold the origin?
static bool triangle_holds_origin(const gjk2_vec *p, const gjk2_vec *q, const gjk2_vec *r) {
  if (holds_origin(p, q) || holds_origin(q, r) || holds_origin(r, p)) {
    return true;
  }
  const int a = gjk_sign64(gjk2_cross(*p, *q)), b = gjk_sign64(gjk2_cross(*q, *r)), c = gjk_sign64(gjk2_cross(*r, *p));
  return a != 0 && a == b && b == c;
}

// Step 2: do the named vertices contain the origin?
static bool plane_is_enclosing(const gjk2_search *s, const gjk2_certificate *certificate) {
  gjk2_vec w[3];
  return load_named(s, certificate, 3, w) &&
         triangle_holds_origin(&w[0], &w[certificate->count > 1 ? 1 : 0], &w[certificate->count > 2 ? 2 : 0]);
}

// Does the edge come within the radius, and not only its ends?
static bool edge_is_near(const gjk2_vec *p, const gjk2_vec *q, int32_t radius) {
  return has_foot(p, q) && gjk2_is_within(gjk_int64(gjk_magnitude64(gjk2_cross(*p, *q))), gjk2_sub(*q, *p), radius);
}

// Does the vertex come within the radius?
static bool vertex_is_near(const gjk2_vec *p, int32_t radius) {
  return gjk2_is_within(gjk2_dot(*p, *p), *p, radius);
}

// Step 2: does the named feature come within the radius?
static bool plane_proves_near(const gjk2_search *s, const gjk2_certificate *certificate) {
  gjk2_vec w[2];
  if (!load_named(s, certificate, 2, w)) {
    return false;
  }
  return certificate->count == 1 ? vertex_is_near(&w[0], s->radius) : edge_is_near(&w[0], &w[1], s->radius);
}

// Is the line across d, of the points w with d . w = height, more than radius before the origin?
GJK_ONE_COPY static bool line_is_clear(gjk2_vec d, int64_t height, int32_t radius) {
  return height < 0 && !gjk2_is_within(-height, d, radius);
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
  return line_is_clear(d, along, (int32_t)radius);
}

static bool plane_is_apart(gjk2_search *s, const gjk2_certificate *certificate, int64_t radius) {
  if (certificate->proof == GJK2_PROOF_DIRECTION) {
    return direction_separates(s, &certificate->direction, radius);
  }
  if (certificate->proof != GJK2_PROOF_NEAREST || !plane_is_nearest(s, certificate)) {
    return false;
  }
  const gjk2_vec d = {s->d.x, s->d.y};
  return line_is_clear(d, s->base, s->radius);
}

static bool plane_is_together(const gjk2_search *s, const gjk2_certificate *certificate) {
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

// Step 4: are both points on their shapes? Or, where they may be saturated, is at least one so: has it a coordinate at an
// end of Q16.16 that its named vertices reach? Then the other must be on its shape, or saturated too.
static bool plane_points_hold(const gjk2_search *s, const gjk2_certificate *c, const gjk2_vec *a, const gjk2_vec *b,
                              bool saturated) {
  const bool on_a = gjk2_claim_point(s->a, c->a, c->count, a), on_b = gjk2_claim_point(s->b, c->b, c->count, b);
  if (!saturated) {
    return on_a && on_b;
  }
  const bool end_a = gjk2_claim_saturated(s->a, c->a, c->count, a),
             end_b = gjk2_claim_saturated(s->b, c->b, c->count, b);
  return (end_a || end_b) && (on_a || end_a) && (on_b || end_b);
}

// Does height / |n| round to distance, a tie up? Exact. Pre: height < 2^62, squared = |n|^2 < 2^62, distance < 2^31.
//   (distance -+ 1/2)^2 = distance^2 -+ distance + 1/4
static bool plane_rounds_to(uint64_t height, uint64_t squared, uint32_t distance) {
  const uint64_t x = gjk_umul32(distance, distance), quarter = (squared + 3) >> 2;
  return (distance == 0 || gjk2_reaches(height, squared, x - distance, quarter)) &&
         !gjk2_reaches(height, squared, x + distance, quarter);
}

// Steps 2 and 3, of a distance.
static bool plane_proves_distance(gjk2_search *s, const gjk2_distance_result *result) {
  const gjk2_certificate *c = &result->certificate;
  if (result->intersecting) {
    return result->distance == 0 && plane_is_together(s, c);
  }
  const uint32_t exact = (uint32_t)result->distance + (uint32_t)gjk2_convex_radii(s);
  if (result->distance < 0 || exact > INT32_MAX || c->proof != GJK2_PROOF_NEAREST || !plane_is_nearest(s, c)) {
    return false;
  }
  const gjk2_vec d = {s->d.x, s->d.y};
  return line_is_clear(d, s->base, s->radius) && plane_rounds_to((uint64_t)-s->base, (uint64_t)gjk2_dot(d, d), exact);
}

// Step 4, of a distance that is proven.
static bool plane_proves_points(const gjk2_search *s, const gjk2_distance_result *result) {
  if (result->intersecting) {
    return !result->saturated;
  }
  return gjk2_claim_normal(s->d, &result->normal) &&
         plane_points_hold(s, &result->certificate, &result->point_a, &result->point_b, result->saturated) &&
         (result->saturated || gjk2_claim_gap(s, result->distance, &result->point_a, &result->point_b));
}

gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result) {
  gjk2_search s;
  const gjk_status status = gjk2_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  (void)gjk2_search_start(&s, a, b, false, (uint32_t)(a->shape->convex_radius + b->shape->convex_radius));
  if (!gjk2_search_is_exact(&s)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const bool exact = result->lower == result->distance && result->upper == result->distance;
  const bool proven = exact && plane_proves_distance(&s, result) && plane_proves_points(&s, result);
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

// Is h / |n| at least low, and less than low + 1? With more = 1: more than low, and at most low + 1. Exact.
// Pre: h < 2^62, squared = |n|^2 < 2^62, more is 0 or 1.
static bool plane_lies_from(uint64_t h, uint64_t squared, int64_t low, unsigned more) {
  if (low < -1 || low >= INT32_MAX) {
    return false;
  }
  const uint32_t from = (uint32_t)low, to = (uint32_t)(low + 1);
  return (low < 0 || gjk2_reaches(h, squared, gjk_umul32(from, from), more)) &&
         !gjk2_reaches(h, squared, gjk_umul32(to, to), more);
}

// Step 3 of cores that are apart: is the nearest feature -core from the origin, rounded down, and within the radii?
static bool feature_is_depth(gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                             int64_t *height) {
  if (!plane_is_nearest(s, certificate)) {
    return false;
  }
  const gjk2_vec d = {s->d.x, s->d.y};
  n->x = d.x;
  n->y = d.y;
  *height = s->base;
  return gjk2_is_within(-s->base, d, s->radius) &&
         plane_lies_from((uint64_t)-s->base, (uint64_t)gjk2_dot(d, d), -core, 0);
}

// Step 3 of cores that touch: is the named vertex at the origin, and all of A - B behind the line there?
static bool line_is_depth(const gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                          int64_t *height) {
  gjk2_vec w[1];
  const gjk2_vec d = {certificate->direction.x, certificate->direction.y};
  n->x = d.x;
  n->y = d.y;
  *height = 0;
  return core == 0 && load_named(s, certificate, 1, w) && gjk2_norm1(w[0]) == 0 &&
         gjk_magnitude32(d.x) <= UINT32_C(1) << 30 && gjk_magnitude32(d.y) <= UINT32_C(1) << 30 && gjk2_norm1(d) != 0 &&
         support(s, d) == 0;
}

// Step 3 of cores that overlap: is the named edge core from the origin, rounded up, and no other edge nearer?
static bool edge_is_depth(gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                          int64_t *height) {
  gjk2_vec w[2];
  gjk2_length length;
  gjk2_edge lowest;
  if (!load_named(s, certificate, 2, w) || certificate->count != 2) {
    return false;
  }
  const gjk2_vec d = gjk2_outward(gjk2_sub(w[1], w[0]));
  const int64_t along = gjk2_cross(w[0], w[1]);
  n->x = d.x;
  n->y = d.y;
  *height = along;
  if (gjk2_norm1(d) == 0 || along < 0 || support(s, d) != along || !cores_intersect(s) ||
      !plane_lies_from((uint64_t)along, (uint64_t)gjk2_dot(d, d), core - 1, 1)) {
    return false;
  }
  gjk2_length_set(&length, d);
  return gjk2_nearest_edge(s, &lowest) == GJK2_LIE_OVERLAP && !gjk2_edge_is_lower(&lowest, (uint64_t)along, &length);
}

// Step 3: the line that bounds A - B, n . w <= height, and the depth that follows from it.
static bool plane_is_depth(gjk2_search *s, const gjk2_penetration_result *result, gjk2_vec *n, int64_t *height) {
  const gjk2_certificate *c = &result->certificate;
  const int64_t core = (int64_t)result->depth - gjk2_convex_radii(s);
  switch (c->proof) {
    case GJK2_PROOF_NEAREST: return feature_is_depth(s, c, core, n, height);
    case GJK2_PROOF_LINE: return line_is_depth(s, c, core, n, height);
    case GJK2_PROOF_EDGE: return edge_is_depth(s, c, core, n, height);
    default: return false;
  }
}

// Step 4: are the points on their shapes and depth apart against the normal, or saturated?
static bool plane_coincide(const gjk2_search *s, const gjk2_penetration_result *result) {
  const gjk2_certificate *c = &result->certificate;
  const gjk2_vec *a = &result->point_a, *b = &result->point_b;
  return (plane_points_hold(s, c, a, b, false) && gjk2_claim_overlap(result->depth, &result->normal, a, b)) ||
         plane_points_hold(s, c, a, b, true);
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
