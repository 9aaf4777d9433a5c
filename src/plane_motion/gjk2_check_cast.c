// Checks a cast of the plane by exact integers, without looking at how it was found.
//
//   1. A miss is proven by the bounding circles; by a vertex that the line of the way passes, with all others behind it; or by
//      a direction along which all of A - B stays behind the way, at its start and at its end.
//   2. A hit at the start is a decision, which gjk2_check_decision proves.
//   3. A hit later, without radius: the facet bounds A - B, and the way passes through it at the fraction, rounded down.
//   4. A hit later, with a radius: no miss by the line; not before the fraction, by the facet's direction; and at the fraction
//      the gap is at most 2 LSB. That it comes within the radius at all: the gap falls at the start. At the end it is within
//      the radius or grows, so that its least lies on the way; or the way has left the bounding circles.
//   5. Points, normal and resting places are what follows from the facet and the fraction.
// Vertices are visited one by one, whatever supports say.
#include "../plane/gjk2_claim.h"
#include "../plane/gjk2_measure.h"
#include "gjk2/check.h"
#include "gjk2_cast_report.h"

static bool plane_name_span(const gjk2_way *way, const gjk2_cast_certificate *c, unsigned i, gjk2_span *out) {
  out->a.vertex = c->a[i];
  out->b.vertex = c->b[i];
  if (!way->a->shape->type->vertex(way->a, c->a[i], &out->a.offset) ||
      !way->b->shape->type->vertex(way->b, c->b[i], &out->b.offset)) {
    return false;
  }
  out->o = gjk2_sub(out->a.offset, out->b.offset);
  return true;
}

// Step 1: does the line pass the outermost vertex on one side beyond radius? *side: t x w of it.
static bool plane_leaves_beside(const gjk2_way *way, bool left, int64_t radius, int64_t *side) {
  gjk2_span outer;
  gjk2_way_outermost_of(way->a, &way->t, left, &outer.a);
  gjk2_way_outermost_of(way->b, &way->t, !left, &outer.b);
  outer.o = gjk2_sub(outer.a.offset, outer.b.offset);
  *side = gjk2_way_side(way, outer.o);
  return (left ? *side < 0 : *side > 0) && gjk2_way_is_beside(way, outer.o, radius);
}

// Step 1: is the named vertex as near to the line as any?
static bool plane_passes_beside(const gjk2_way *way, const gjk2_cast_certificate *c, int64_t radius) {
  gjk2_span named;
  int64_t nearest;
  if (c->count != 1 || !plane_name_span(way, c, 0, &named)) {
    return false;
  }
  const int64_t side = gjk2_way_side(way, named.o);
  return plane_leaves_beside(way, side < 0, radius, &nearest) && side == nearest;
}

// Step 1: the most of n . w, and n . t. False: a direction that no query reports.
//   |n| < 2^30 + 4, or it is that of the way, which is short: both products are below 2^63
static bool plane_along(const gjk2_way *way, gjk2_vec n, int64_t *most, int64_t *ahead) {
  const gjk2_vec origin = {0, 0};
  const uint32_t limit = (UINT32_C(1) << 30) + 4;
  const bool own = gjk2_equal(n, gjk2_negate(way->d));
  if (gjk_magnitude32(n.x) > limit || gjk_magnitude32(n.y) > limit || gjk2_norm1(n) == 0 ||
      (!own && gjk2_dot(n, n) > (INT64_C(1) << 60) + (INT64_C(1) << 33))) {
    return false;
  }
  *most = gjk2_way_along(way, n, origin) + gjk2_claim_farthest(way->a, n) + gjk2_claim_farthest(way->b, gjk2_negate(n));
  *ahead = gjk2_way_ahead(way, n);
  return true;
}

// Is height / |n| below -radius? Exact.
static bool plane_is_behind(int64_t height, gjk2_vec n, int64_t radius) {
  return height < 0 && radius <= INT32_MAX && (radius == 0 || !gjk2_is_within(-height, n, (int32_t)radius));
}

static bool plane_stays_behind(const gjk2_way *way, const gjk2_vec *direction, int64_t radius) {
  const gjk2_vec n = {direction->x, direction->y};
  int64_t most, ahead;
  if (!plane_along(way, n, &most, &ahead)) {
    return false;
  }
  return plane_is_behind(most, n, radius) && plane_is_behind(most - ahead, n, radius);
}

// Step 2.
static gjk_status plane_check_inside(const gjk2_way *way, gjk_q16 margin, const gjk2_cast_result *r) {
  gjk2_decision decision;
  gjk2_distance_result gap;
  gjk2_cast_result expected;
  (void)gjk2_within(way->a, way->b, margin, NULL, &decision);
  const gjk_status status = gjk2_check_decision(way->a, way->b, margin, &decision);
  if (status != GJK_OK || !decision.yes) {
    return status != GJK_OK ? status : GJK_ERROR_UNPROVEN;
  }
  (void)gjk2_distance(way->a, way->b, NULL, &gap);
  gjk2_cast_inside(way, gap.intersecting ? NULL : &gap, &expected);
  return r->fraction == 0 && gjk2_equal(r->rest_a, expected.rest_a) && gjk2_equal(r->rest_b, expected.rest_b) &&
                 gjk2_equal(r->point_a, expected.point_a) && gjk2_equal(r->point_b, expected.point_b) &&
                 r->normal.x == expected.normal.x && r->normal.y == expected.normal.y &&
                 r->saturated == expected.saturated
             ? GJK_OK
             : GJK_ERROR_UNPROVEN;
}

// Step 5.
static bool plane_follows(const gjk2_way *way, const gjk2_contact_place *place, const gjk2_portion *portion,
                          const gjk2_cast_result *r) {
  gjk2_cast_result expected;
  gjk2_cast_hit(way, place, portion, &expected);
  return r->fraction == expected.fraction && gjk2_equal(r->rest_a, expected.rest_a) &&
         gjk2_equal(r->rest_b, expected.rest_b) && gjk2_equal(r->point_a, expected.point_a) &&
         gjk2_equal(r->point_b, expected.point_b) && r->normal.x == expected.normal.x &&
         r->normal.y == expected.normal.y && r->saturated == expected.saturated;
}

// Is the portion's fraction num / den, rounded down? Sets exact. By products alone, so that no query's rounding is believed.
// Pre: 0 <= num <= den < 2^63, 0 < den.
//   2^30 num - fraction den = 2^32 high + low; both parts of high are below 2^62
static bool plane_is_quotient(gjk2_portion *p) {
  if (p->fraction < 0) {
    return false;
  }
  const uint32_t den_high = (uint32_t)(p->den >> 32), den_low = (uint32_t)(p->den & UINT32_MAX);
  const uint64_t lower = gjk_umul32((uint32_t)p->fraction, den_low);
  const uint64_t upper = gjk_umul32((uint32_t)p->fraction, den_high) + (lower >> 32);
  const uint32_t num_low = (uint32_t)(p->num & 3u) << 30, take_low = (uint32_t)(lower & UINT32_MAX);
  const uint32_t low = num_low - take_low;
  const int64_t high = (int64_t)(p->num >> 2) - (int64_t)upper - (num_low < take_low ? 1 : 0);
  p->exact = high == 0 && low == 0;
  return high >= 0 && (high < (int64_t)den_high || (high == (int64_t)den_high && low < den_low));
}

// Step 3.
static bool plane_enters(const gjk2_way *way, const gjk2_span *p, const gjk2_span *q, const gjk2_cast_result *r) {
  const gjk2_vec n = {r->certificate.direction.x, r->certificate.direction.y};
  gjk2_contact_place place = {p, q, 0, n};
  int64_t most, ahead;
  bool exact;
  if (!plane_along(way, n, &most, &ahead) || ahead >= 0 || most >= 0 || most < ahead ||
      most != gjk2_way_along(way, n, p->o) || most != gjk2_way_along(way, n, q->o)) {
    return false;
  }
  const int64_t side_p = gjk2_way_side(way, p->o), side_q = gjk2_way_side(way, q->o);
  if (side_p > 0 || side_q < 0 || (p != q && side_q == side_p)) {
    return false;
  }
  if (p != q) {
    place.weight = gjk2_ratio((uint64_t)-side_p, (uint64_t)(side_q - side_p), &exact);
  }
  gjk2_portion portion = {(uint64_t)-most, (uint64_t)-ahead, r->fraction, false};
  return plane_is_quotient(&portion) && plane_follows(way, &place, &portion, r);
}

// Step 4: how the gap changes at the start or the end, by the sign of *slope. False: the nearest feature is not proven.
static bool plane_proves_slope(const gjk2_way *way, const gjk2_collider *at_a, const gjk2_collider *at_b, bool at_end,
                               int *slope) {
  gjk2_distance_result gap;
  gjk2_cast_certificate named;
  gjk2_span p, q;
  if (gjk2_distance(at_a, at_b, NULL, &gap) != GJK_OK || gjk2_check_distance(at_a, at_b, &gap) != GJK_OK ||
      gap.intersecting) {
    return false;
  }
  for (unsigned i = 0; i < 2; i++) {
    named.a[i] = gap.certificate.a[i];
    named.b[i] = gap.certificate.b[i];
  }
  if (!plane_name_span(way, &named, 0, &p)) {
    return false;
  }
  if (gap.certificate.count == 1) {
    *slope = -gjk2_way_is_ahead(way, p.o, at_end);
    return true;
  }
  if (!plane_name_span(way, &named, 1, &q)) {
    return false;
  }
  const gjk2_vec across = gjk2_outward(gjk2_sub(q.o, p.o)), normal = {gap.normal.x, gap.normal.y};
  const int64_t ahead = gjk2_way_ahead(way, across);
  *slope = gjk2_dot(across, normal) < 0 ? -gjk_sign64(ahead) : gjk_sign64(ahead);
  return true;
}

// Step 4: does the way come within the radius, once the line does?
static bool plane_comes_near(const gjk2_way *way, bool early, bool late, gjk_q16 margin) {
  gjk2_collider moved, at_b;
  gjk2_decision decision;
  int slope;
  if (early && (!plane_proves_slope(way, way->a, way->b, false, &slope) || slope >= 0)) {
    return false;
  }
  if (!late) {  // the way meets the bounding circles and ends beyond them, and all that its line meets lies within
    return true;
  }
  const gjk2_collider *at_a = gjk2_cast_places(way, GJK_Q30_ONE, &moved, &at_b);
  if (gjk2_within(at_a, &at_b, margin, NULL, &decision) != GJK_OK) {
    return false;
  }
  if (decision.yes) {
    return gjk2_check_decision(at_a, &at_b, margin, &decision) == GJK_OK;
  }
  return plane_proves_slope(way, at_a, &at_b, true, &slope) && slope >= 0;
}

// By how much less than another direction n may prove: bounds are off by radius / 2^29 of gap (gjk2_cast_bound), and
// gjk2_advance.c keeps the later fraction of two that are proven; where a step of it is longer than half an LSB, one step more.
//   2 radius < 2^32, an LSB of gap is 2^30 or less of the fraction:  below 2^62
static int64_t plane_slack(const gjk2_way *way, const gjk2_rate *rate, int64_t radius) {
  const bool slow = rate->length >= rate->closing;
  bool exact;
  const gjk_q30 lsb = slow ? GJK_Q30_ONE : gjk2_ratio((uint64_t)rate->length, (uint64_t)rate->closing, &exact);
  const int64_t step = gjk2_norm1(way->d) > UINT32_C(1) << 29 ? 1 : 0;  // d is the way: it is not wide
  return (int64_t)(gjk_umul32((uint32_t)radius << 1, (uint32_t)lsb) >> 30) + step;
}

// Step 4: is there no contact before the fraction, by n, and at most 2 LSB of gap at it? A place is rounded by up to 0.71
// LSB to be measured, and its distance by 1/2.
static bool plane_stops_at(const gjk2_way *way, gjk2_vec n, int64_t radius, gjk_q16 margin, gjk_q30 fraction) {
  gjk2_collider moved, at_b;
  gjk2_distance_result gap;
  gjk2_rate rate;
  int64_t most, ahead;
  gjk_q30 bound;
  if (fraction < 0 || fraction > GJK_Q30_ONE || !plane_along(way, n, &most, &ahead) ||
      gjk2_cast_bound(way, n, most, radius, 0, &bound, &rate) != GJK2_BOUND_AT ||
      fraction - bound > plane_slack(way, &rate, radius)) {
    return false;
  }
  const gjk2_collider *at_a = gjk2_cast_places(way, fraction, &moved, &at_b);
  if (gjk2_distance(at_a, &at_b, NULL, &gap) != GJK_OK) {
    return false;
  }
  return gap.intersecting || gap.distance <= (int64_t)margin + 3;
}

// Step 4.
static bool plane_rounds(const gjk2_way *way, bool early, bool late, const gjk2_span *p, const gjk2_span *q,
                         int64_t radius, gjk_q16 margin, const gjk2_cast_result *r) {
  const gjk2_vec n = {r->certificate.direction.x, r->certificate.direction.y};
  gjk2_contact_place place = {p, q, 0, n};
  const gjk2_portion portion = {0, 1, r->fraction, true};
  int64_t side;
  if (plane_leaves_beside(way, true, radius, &side) || plane_leaves_beside(way, false, radius, &side) ||
      !plane_stops_at(way, place.n, radius, margin, r->fraction) || !plane_comes_near(way, early, late, margin)) {
    return false;
  }
  if (p != q) {
    const int64_t foot = gjk2_cast_foot(way, p->o, q->o, r->fraction);
    place.weight = (gjk_q30)(foot < 0 ? 0 : foot > GJK_Q30_ONE ? GJK_Q30_ONE : foot);
  }
  return plane_follows(way, &place, &portion, r);
}

static bool plane_check_hit(const gjk2_way *way, bool early, bool late, int64_t radius, gjk_q16 margin,
                            const gjk2_cast_result *r) {
  const gjk2_cast_certificate *c = &r->certificate;
  gjk2_span p, q;
  if (r->inside || c->proof != GJK2_CAST_PROOF_FACET || c->count < 1 || c->count > 2 ||
      !plane_name_span(way, c, 0, &p) || (c->count == 2 && !plane_name_span(way, c, 1, &q))) {
    return false;
  }
  const gjk2_span *other = c->count == 2 ? &q : &p;
  return radius > 0 ? plane_rounds(way, early, late, &p, other, radius, margin, r) : plane_enters(way, &p, other, r);
}

static bool plane_check_miss(const gjk2_way *way, int64_t radius, const gjk2_cast_certificate *c) {
  switch (c->proof) {
    case GJK2_CAST_PROOF_BESIDE: return plane_passes_beside(way, c, radius);
    case GJK2_CAST_PROOF_SHORT: return plane_stays_behind(way, &c->direction, radius);
    default: return false;
  }
}

gjk_status gjk2_check_cast(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                           const gjk2_cast_result *result) {
  gjk2_way way;
  bool early, late;
  const gjk_status status = gjk2_way_set(&way, a, b, path, result);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + path->margin;
  if (!gjk2_way_may_meet(&way, radius, &early, &late)) {
    return result->hit ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape) || (radius > 0 && (way.wide || radius > INT32_MAX))) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (result->hit && result->inside && result->certificate.proof == GJK2_CAST_PROOF_INSIDE) {
    return plane_check_inside(&way, path->margin, result);
  }
  const bool proven = result->hit ? plane_check_hit(&way, early, late, radius, path->margin, result)
                                  : plane_check_miss(&way, radius, &result->certificate);
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}
