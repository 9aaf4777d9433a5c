// Checks casts by exact integers, without looking at how they were found.
//
//   1. The bounding spheres settle it: the certificate is not looked at.
//   2. Polytopes without radius and margin: take the plane that the certificate names, and visit every vertex of both.
//        BESIDE, SHORT   all of A - B lies behind it
//        FACET           none of A - B lies before it, and the way passes through what the pairs span
//        INSIDE          a decision of the check's own, which it proves as gjk_check_decision does
//   3. Of a hit, compute each field afresh from the named vertices.
//   4. With a radius or margin: prove such decisions about A and B's places, at the start and on the whole way.
#include "gjk/check.h"

#include "gjk_cast_report.h"
#include "gjk_spheres.h"
#include "gjk_swept.h"

// Directions in certificates are at most this long.
#define DIRECTION_MAX (INT32_C(1) << 30)

// The vertex of a collider that is farthest along n, or against it. Visits all.
static gjk_vec3 farthest_along(const gjk_collider *c, const gjk_long3 *n, int sign) {
  gjk_vec3 best = {0, 0, 0}, offset;
  c->shape->type->vertex(c, 0, &best);
  for (uint16_t i = 1; c->shape->type->vertex(c, i, &offset); i++) {  // at most GJK_HULL_VERTICES_MAX vertices
    const gjk_vec3 step = gjk_sub(offset, best);
    if (gjk_dot_sign(n, &step) == sign) {
      gjk_set(&offset, &best);
    }
  }
  return best;
}

static gjk_vec3 farthest_difference(const gjk_portal *p) {
  const gjk_vec3 v = farthest_along(p->a, &p->n, 1), w = farthest_along(p->b, &p->n, -1);
  gjk_vec3 u;
  gjk_portal_scale(p, &v, &w, &u);
  return u;
}

// Is the direction short enough for products with the way?
static bool is_small(const gjk_vec3 *d) {
  return gjk_magnitude32(d->x) <= DIRECTION_MAX && gjk_magnitude32(d->y) <= DIRECTION_MAX &&
         gjk_magnitude32(d->z) <= DIRECTION_MAX && gjk_dot(d, d) <= gjk_mul32(DIRECTION_MAX, DIRECTION_MAX);
}

static bool is_beside(gjk_portal *p, const gjk_vec3 *direction) {
  gjk_portal_face(p, direction);
  const gjk_vec3 u = farthest_difference(p);
  return gjk_portal_beside(p, &u) < 0;
}

static bool is_behind_ends(const gjk_portal *p) {
  const gjk_vec3 u = farthest_difference(p);
  return gjk_portal_side(p, &u, &p->start) < 0 && gjk_portal_side(p, &u, &p->goal) < 0;
}

static bool is_entry_facet(gjk_portal *p) {
  const gjk_vec3 u = farthest_difference(p), step = gjk_sub(u, p->corner[0].u);
  return gjk_dot_sign(&p->n, &step) <= 0 && gjk_portal_is_entry(p);
}

static bool same_vector(const gjk_vec3 *v, const gjk_vec3 *w) {
  return v->x == w->x && v->y == w->y && v->z == w->z;
}

static bool same_normal(const gjk_unit3 *v, const gjk_unit3 *w) {
  return v->x == w->x && v->y == w->y && v->z == w->z;
}

// Step 3.
static bool same_report(const gjk_cast_result *r, const gjk_cast_result *s) {
  return r->inside == s->inside && r->fraction == s->fraction && r->saturated == s->saturated &&
         same_normal(&r->normal, &s->normal) && same_vector(&r->rest_a, &s->rest_a) &&
         same_vector(&r->rest_b, &s->rest_b) &&
         (r->inside || (same_vector(&r->point_a, &s->point_a) && same_vector(&r->point_b, &s->point_b)));
}

// OK: it is proven that the shapes are within the margin of each other, or that they are not. UNSUPPORTED: they are too far
// apart for an exact decision. Pre: both are polytopes, so that gjk_within has an answer.
static gjk_status prove_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, bool within) {
  gjk_decision decision;
  (void)gjk_within(a, b, margin, NULL, &decision);
  const gjk_status status = gjk_check_decision(a, b, margin, &decision);
  return status == GJK_OK && decision.yes != within ? GJK_ERROR_UNPROVEN : status;
}

static gjk_status prove_start(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin,
                              const gjk_cast_result *result) {
  gjk_cast_result start;
  gjk_cast_report_start(a, b, &start);
  return result->certificate.proof != GJK_CAST_PROOF_NONE && same_report(result, &start)
             ? prove_within(a, b, margin, true)
             : GJK_ERROR_UNPROVEN;
}

// Steps 2 and 3.
static bool is_proven(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, const gjk_cast_result *result) {
  const gjk_cast_certificate *c = &result->certificate;
  gjk_portal p;
  gjk_cast_result entry;
  if (result->hit && result->inside) {
    return c->proof == GJK_CAST_PROOF_INSIDE && prove_start(a, b, 0, result) == GJK_OK;
  }
  gjk_portal_start(&p, a, b, way);
  if (c->count > 3 || ((c->proof == GJK_CAST_PROOF_BESIDE || c->count < 3) && !is_small(&c->direction))) {
    return false;
  }
  if (!result->hit && c->proof == GJK_CAST_PROOF_BESIDE) {
    return is_beside(&p, &c->direction);
  }
  if (!gjk_portal_load(&p, c)) {
    return false;
  }
  if (!result->hit) {
    return c->proof == GJK_CAST_PROOF_SHORT && is_behind_ends(&p);
  }
  if (c->proof != GJK_CAST_PROOF_FACET || c->count < 1 || !is_entry_facet(&p)) {
    return false;
  }
  gjk_cast_report_entry(&p, way, &entry);
  return same_report(result, &entry);
}

// Step 4.
static gjk_status check_rounded(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, gjk_q16 margin,
                                const gjk_cast_result *result) {
  gjk_swept swept;
  if (!gjk_swept_set(&swept, a, b, way)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (result->hit && (result->fraction < 0 || result->fraction > GJK_Q30_ONE)) {
    return GJK_ERROR_UNPROVEN;
  }
  const gjk_status status = prove_within(&swept.still, &swept.swept, margin, result->hit);
  if (status != GJK_OK || !result->hit) {
    return status;
  }
  return result->inside ? prove_start(a, b, margin, result) : prove_within(a, b, margin, false);
}

gjk_status gjk_check_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                          const gjk_cast_result *result) {
  gjk_way way;
  gjk_status status = gjk_check_pair(a, b, result);
  if (status == GJK_OK) {
    status = gjk_way_set(&way, a, b, path);
  }
  if (status != GJK_OK) {
    return status;
  }
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + path->margin;
  if (gjk_spheres_part(a, b, &way, radius)) {
    return result->hit ? GJK_ERROR_UNPROVEN : GJK_OK;
  }
  if (gjk_is_curved(a->shape) || gjk_is_curved(b->shape)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (radius > 0) {
    return check_rounded(a, b, &way, path->margin, result);
  }
  return is_proven(a, b, &way, result) ? GJK_OK : GJK_ERROR_UNPROVEN;
}
