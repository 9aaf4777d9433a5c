// Checks answers by exact integers alone.
//
//   1. Fill the simplex with the vertices that the certificate names.
//   2. Prove the decision from them: a plane that no vertex of A - B lies before, or a feature that comes near enough.
//      Each vertex is visited once.
//   3. Prove the distance: the named feature's exact distance rounds to it. Or the depth: the named facet's exact
//      height.
//   4. Prove the normal, to 2^-28, and the points, to 1 LSB of their shapes (gjk_claim.c).
//   5. Prove that moving B by the depth along the normal parts the shapes.
// Where a step searches for a certificate of its own, it proves that certificate in the same way. It trusts no search.
#include "gjk/check.h"

#include "../gjk/gjk_search.h"
#include "gjk_claim.h"
#include "gjk_distance.h"
#include "gjk_outward.h"

// Step 1. False when a named vertex does not exist.
static bool load(gjk_iteration *it, const gjk_certificate *certificate) {
  gjk_simplex *s = &it->simplex;
  gjk_simplex_clear(s);
  for (uint8_t i = 0; i < certificate->count; i++) {
    s->count = i;
    if (!gjk_iteration_place(it, certificate->a[i], certificate->b[i])) {
      return false;
    }
  }
  s->count = 0;
  return true;
}

// Visits all vertices of a collider. They are numbered from 0 without gaps, and none has the number UINT16_MAX.
typedef struct visit {
  const gjk_collider *collider;
  uint16_t number;
} visit;

static bool next(visit *v, gjk_vec3 *offset) {
  return v->collider->shape->type->vertex(v->collider, v->number++, offset);
}

// Does no vertex of the collider lie before vertex `origin` along the exact direction? Pre: vertex `origin` exists.
static bool none_before(const gjk_collider *c, const gjk_direction *direction, uint16_t origin) {
  gjk_vec3 base, offset;
  visit v = {c, 0};
  const bool exists = c->shape->type->vertex(c, origin, &base);
  //@ assert exists;
  (void)exists;
  while (next(&v, &offset)) {  // at most GJK_HULL_VERTICES_MAX vertices
    const gjk_vec3 step = gjk_sub(offset, base);
    if (gjk_direction_sign(direction, &step) > 0) {
      return false;
    }
  }
  return true;
}

// The largest offset . d of the collider's vertices.
static int64_t farthest(const gjk_collider *c, const gjk_vec3 *d) {
  gjk_vec3 offset;
  visit v = {c, 0};
  int64_t largest = INT64_MIN;
  while (next(&v, &offset)) {  // at most GJK_HULL_VERTICES_MAX of them
    const int64_t along = gjk_dot(&offset, d);
    largest = along > largest ? along : largest;
  }
  return largest;
}

// Does no vertex of A - B lie before the certificate's first one along the direction?
static bool is_support(const gjk_iteration *it, const gjk_certificate *certificate, gjk_direction *direction) {
  direction->opposite = false;
  if (!none_before(it->a, direction, certificate->a[0])) {
    return false;
  }
  direction->opposite = true;
  return none_before(it->b, direction, certificate->b[0]);
}

// Step 2: is the named feature the one of A - B nearest to the origin, and not at the origin?
static bool is_nearest(gjk_iteration *it, const gjk_certificate *certificate) {
  gjk_direction direction;
  gjk_search_direction rounded;
  gjk_simplex *s = &it->simplex;
  if (certificate->count < 1 || certificate->count > 3 || !load(it, certificate) ||
      !gjk_simplex_set(s, certificate->count) || !gjk_simplex_direction(s, &rounded)) {
    return false;
  }
  gjk_simplex_exact_direction(s, &direction);
  if (s->count == 3 && gjk_dot_sign(&s->normal, &s->slot[0].w) == 0) {
    return false;
  }
  return is_support(it, certificate, &direction);
}

// Step 2: do the named vertices contain the origin?
static bool is_enclosing(gjk_iteration *it, const gjk_certificate *certificate) {
  return certificate->count >= 1 && certificate->count <= 4 && load(it, certificate) &&
         gjk_simplex_encloses(&it->simplex, certificate->count);
}

// Step 2: does the named feature come within the radius?
static bool proves_near(gjk_iteration *it, const gjk_certificate *certificate) {
  return certificate->count >= 1 && certificate->count <= 3 && load(it, certificate) &&
         gjk_simplex_set(&it->simplex, certificate->count) && gjk_iteration_near(it);
}

// Step 2: does the plane across direction keep all of A - B more than radius away from the origin?
//   direction   components beyond 3 2^29 and lengths from 2^31 on are never reported
//   radius      from 2^31 on it exceeds every vertex of A - B
//   along       |d| < 2^31, |w| <= 3 2^29:   below 2^62
static bool is_separating(const gjk_iteration *it, const gjk_vec3 *direction, int64_t radius) {
  const gjk_vec3 d = *direction;
  const uint32_t x = gjk_magnitude32(d.x), y = gjk_magnitude32(d.y), z = gjk_magnitude32(d.z);
  const uint32_t limit = UINT32_C(3) << 29;
  if (x > limit || y > limit || z > limit || radius > INT32_MAX ||
      gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z) >= UINT64_C(1) << 62) {
    return false;
  }
  const gjk_vec3 opposite = gjk_negate(d);
  const gjk_vec3 delta = gjk_sub(it->a->centre, it->b->centre);
  const int64_t along = gjk_dot(&delta, &d) + farthest(it->a, &d) + farthest(it->b, &opposite);
  return along < 0 && gjk_sum_of_products_sign(along, along, -(radius * radius), gjk_dot(&d, &d)) > 0;
}

static bool is_apart(gjk_iteration *it, const gjk_certificate *certificate, int64_t radius) {
  if (certificate->proof == GJK_PROOF_DIRECTION) {
    return is_separating(it, &certificate->direction, radius);
  }
  return certificate->proof == GJK_PROOF_NEAREST && is_nearest(it, certificate) && !gjk_iteration_near(it);
}

static bool is_together(gjk_iteration *it, const gjk_certificate *certificate) {
  if (certificate->proof == GJK_PROOF_NEAR) {
    return proves_near(it, certificate);
  }
  return certificate->proof == GJK_PROOF_ENCLOSING && is_enclosing(it, certificate);
}

gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision) {
  gjk_iteration it;
  gjk_status status = gjk_check_pair(a, b, decision);
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  const gjk_certificate *certificate = &decision->certificate;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + distance;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_WITHIN, radius)) {
    return decision->yes ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (gjk_pair_is_curved(&it) || it.shift < 0) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const bool proven = decision->yes ? is_together(&it, certificate) : is_apart(&it, certificate, radius);
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}

// Step 3: is the distance that of the feature, rounded to the nearest LSB, a tie up? With d = distance + radius:
//   2 d - 1 <= 2 (exact distance of the cores) < 2 d + 1      the left inequality for d > 0
static bool is_rounded(const gjk_iteration *it, gjk_q16 distance, int64_t radius) {
  const uint64_t twice = 2 * (uint64_t)((int64_t)distance + radius);
  if (twice > UINT64_C(1) << (33 - it->shift)) {  // no distance in the frame exceeds 2^31
    return false;
  }
  gjk_u192 numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (twice + 1) << it->shift) < 0 &&
         (twice == 0 || gjk_compare_distance(&numerator, &denominator, (twice - 1) << it->shift) >= 0);
}

// May saturation explain points that are not where the certificate has them? At least one must have a coordinate at an
// end of Q16.16 that its named vertices reach. The other must be on its shape, or saturated too.
static bool may_be_saturated(const gjk_iteration *it, const gjk_certificate *c, const gjk_vec3 *a, bool on_a,
                             const gjk_vec3 *b, bool on_b) {
  const bool saturated_a = gjk_claim_saturated(it->a, c->a, c->count, a),
             saturated_b = gjk_claim_saturated(it->b, c->b, c->count, b);
  return (saturated_a || saturated_b) && (on_a || saturated_a) && (on_b || saturated_b);
}

// Step 4: are the points on their shapes and as far apart as the distance, or saturated? Pre: the certificate holds.
static bool are_nearest(const gjk_iteration *it, const gjk_distance_result *result, int64_t radius) {
  const gjk_certificate *c = &result->certificate;
  const bool on_a = gjk_claim_point(it->a, c->a, c->count, &result->point_a),
             on_b = gjk_claim_point(it->b, c->b, c->count, &result->point_b);
  if (!result->saturated) {
    return on_a && on_b && gjk_claim_gap(it, result->distance, radius, &result->point_a, &result->point_b);
  }
  return may_be_saturated(it, c, &result->point_a, on_a, &result->point_b, on_b);
}

gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result) {
  gjk_iteration it;
  gjk_status status = gjk_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const gjk_certificate *certificate = &result->certificate;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  gjk_iteration_start(&it, a, b, GJK_GOAL_DISTANCE, radius);
  if (gjk_pair_is_curved(&it) || it.shift < 0) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (result->lower != result->distance || result->upper != result->distance || result->distance < 0) {
    return GJK_ERROR_UNPROVEN;
  }
  if (result->intersecting) {
    const bool zero = result->distance == 0 && !result->saturated;
    return zero && is_together(&it, certificate) ? GJK_OK : GJK_ERROR_UNPROVEN;
  }
  gjk_long3 direction;
  if (certificate->proof != GJK_PROOF_NEAREST || !is_apart(&it, certificate, radius) ||
      !is_rounded(&it, result->distance, radius)) {
    return GJK_ERROR_UNPROVEN;
  }
  gjk_claim_direction(&it.simplex, &direction);
  return gjk_claim_normal(&direction, &result->normal) && are_nearest(&it, result, radius) ? GJK_OK
                                                                                           : GJK_ERROR_UNPROVEN;
}

// The sign of (exact distance of the simplex's feature) - d, d in LSB.
static int compare_to(const gjk_iteration *it, int64_t d) {
  gjk_u192 numerator, denominator;
  // No distance in the frame exceeds 2^31.
  if (d < 0 || d > (int64_t)(UINT32_MAX >> it->shift)) {
    return d < 0 ? 1 : -1;
  }
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)((uint32_t)d << it->shift) * 2);
}

// Step 3: do three pairs span a plane that no vertex of A - B lies beyond, whose exact height over the origin rounds up
// to depth? *n is its outward normal.
static bool is_facet(gjk_iteration *it, const gjk_certificate *certificate, int64_t depth, gjk_long3 *n) {
  const gjk_simplex *s = &it->simplex;
  if (certificate->count != 3 || !load(it, certificate)) {
    return false;
  }
  gjk_triangle_normal(&s->slot[0].w, &s->slot[1].w, &s->slot[2].w, n);
  gjk_direction outwards = {NULL, NULL, n, 0, 0, 3, false, NULL, 0};
  gjk_simplex_set(&it->simplex, 3);
  return (n->x | n->y | n->z) != 0 && gjk_dot_sign(n, &s->slot[0].w) >= 0 && is_support(it, certificate, &outwards) &&
         compare_to(it, depth) <= 0 && compare_to(it, depth - 1) > 0;
}

// Step 3: does the plane across direction through the origin bound A - B and touch it?
//   |d| <= sqrt(3) 2^31, |w| <= 2^30 in LSB:  products below 2^62
static bool is_level(const gjk_iteration *it, const gjk_vec3 *direction) {
  const gjk_vec3 d = *direction;
  if ((d.x | d.y | d.z) == 0 || d.x < -INT32_MAX || d.y < -INT32_MAX || d.z < -INT32_MAX) {
    return false;
  }
  const gjk_vec3 opposite = gjk_negate(d), delta = gjk_sub(it->a->centre, it->b->centre);
  return gjk_dot(&delta, &d) + farthest(it->a, &d) + farthest(it->b, &opposite) == 0;
}

// Step 3: does the certificate prove the depth of shapes that intersect? *direction is the way out that it names.
static bool is_depth(gjk_iteration *it, const gjk_penetration_result *result, gjk_long3 *direction) {
  const gjk_certificate *certificate = &result->certificate;
  const int64_t depth = result->depth - gjk_convex_radii(it);
  if (certificate->proof == GJK_PROOF_FACET) {
    return is_facet(it, certificate, depth, direction);
  }
  if (certificate->proof == GJK_PROOF_PLANE) {
    const gjk_vec3 *d = &certificate->direction;
    direction->x = d->x;
    direction->y = d->y;
    direction->z = d->z;
    return depth == 0 && certificate->count >= 1 && certificate->count <= 3 && is_level(it, d) && load(it, certificate);
  }
  // Cores that are apart: -depth is their distance, rounded down.
  if (certificate->proof != GJK_PROOF_NEAREST || !is_nearest(it, certificate) || compare_to(it, -depth) < 0 ||
      compare_to(it, 1 - depth) >= 0) {
    return false;
  }
  gjk_claim_direction(&it->simplex, direction);
  return true;
}

// Step 2: do the shapes intersect? The check searches for a certificate of its own, and believes what that proves.
static bool intersect(const gjk_collider *a, const gjk_collider *b, int64_t radius) {
  gjk_iteration it;
  gjk_certificate certificate;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_WITHIN, radius)) {  // not reached: the caller has asked the same
    return false;
  }
  const gjk_outcome outcome = gjk_search_any(&it, GJK_GOAL_WITHIN, NULL, GJK_NO_LIMIT);
  gjk_iteration_certify(&it, outcome, &certificate);
  return is_together(&it, &certificate);
}

// Step 5 for convex radii: are the cores at least radius > 0 apart when B has moved by t? Searched and proven as above,
// in a frame of shift 0.
//   centres   of shapes that intersect: at most 2^29 - 2^17 + 8 apart
//   t         at most that, and 1 LSB per component:                     |delta| < 2^30
static bool proves_apart_when_moved(const gjk_collider *a, const gjk_collider *b, int64_t radius, const gjk_vec3 *t) {
  gjk_iteration it;
  gjk_certificate certificate;
  gjk_iteration_start(&it, a, b, GJK_GOAL_SIGNED, radius);
  it.shift = 0;
  it.radius = (int32_t)radius;
  it.delta = gjk_sub(gjk_sub(a->centre, b->centre), *t);
  const gjk_outcome outcome = gjk_search_any(&it, GJK_GOAL_SIGNED, NULL, GJK_NO_LIMIT);
  gjk_iteration_certify(&it, outcome, &certificate);
  return outcome == GJK_OUTCOME_NEAREST && is_nearest(&it, &certificate) && compare_to(&it, radius) >= 0;
}

// Step 5: does moving B by depth along the normal part the shapes? Without convex radii they may be left touching,
// which the facet's plane proves.
// Pre: depth and normal are proven, depth <= 2^29 - 2^17 + 8, the simplex is the certificate's.
static bool proves_parting(const gjk_iteration *it, const gjk_penetration_result *result, const gjk_long3 *direction) {
  const gjk_vec3 t = gjk_outward_move(result->depth, &result->normal);
  const int64_t radius = gjk_convex_radii(it);
  if (radius > 0) {
    return proves_apart_when_moved(it->a, it->b, radius, &t);
  }
  return result->certificate.proof == GJK_PROOF_PLANE ||
         gjk_outward_clears(&it->simplex.slot[0].w, it->shift, direction, &t);
}

// Step 4: do the points coincide when B has moved by the depth, or are they saturated? Pre: the certificate holds.
static bool coincide(const gjk_iteration *it, const gjk_penetration_result *result) {
  const gjk_certificate *c = &result->certificate;
  const bool on_a = gjk_claim_point(it->a, c->a, c->count, &result->point_a),
             on_b = gjk_claim_point(it->b, c->b, c->count, &result->point_b);
  if (on_a && on_b && gjk_claim_overlap(result->depth, &result->normal, &result->point_a, &result->point_b)) {
    return true;
  }
  return may_be_saturated(it, c, &result->point_a, on_a, &result->point_b, on_b);
}

gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result) {
  gjk_iteration it;
  gjk_long3 direction;
  const gjk_status status = gjk_check_pair(a, b, result);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  if (!gjk_iteration_start(&it, a, b, GJK_GOAL_DEPTH, radius)) {
    return result->intersecting ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (gjk_pair_is_curved(&it)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  // The bounding spheres meet, so the centres are near enough for a frame of shift >= 0.
  //@ assert it.shift >= 0;
  bool proven = false;
  if (!result->intersecting) {
    proven = is_apart(&it, &result->certificate, radius);
  } else if (result->depth >= 0 && result->depth <= a->radius + b->radius && result->lower == result->depth &&
             result->upper == result->depth) {  // no least depth exceeds the sum of the radii
    proven = intersect(a, b, radius) && is_depth(&it, result, &direction) &&
             gjk_claim_normal(&direction, &result->normal) && coincide(&it, result) &&
             proves_parting(&it, result, &direction);
  }
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}
