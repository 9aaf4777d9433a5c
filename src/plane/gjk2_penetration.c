// The penetration and the signed distance queries of the plane.
//
//   1. Find out how the cores lie. Of polygons whose bounding circles meet: by the edges of A - B, of which the nearest
//      to the origin gives the depth (gjk2_edges.h). Others: by GJK.
//   2. Cores apart, by less than the convex radii: the depth is the radii less that distance.
//   3. Cores that intersect: the depth is the radii plus the distance of the nearest edge of A - B, with a curved shape
//      that of the nearest line that touches A - B (gjk2_curved_depth.h).
//   4. Find the point of each shape on that feature, and name its vertices in the certificate.
//   5. Round the normal outwards (gjk2_outward.h).
//
// What is rounded:
//   posing   only there is geometry rounded; from then on shapes are integers
//   depth    up to the next LSB: step 2 rounds the distance of the cores down, step 3 the height up, both exactly. The
//            bounds of a curved pair leave 2 LSB above and below for the error of its support points
//   points   per component to the nearest LSB, within 1 LSB of the shape
//   normal   within 2^-29, then outward
#include "gjk2/penetration.h"

#include "gjk2_canonical.h"
#include "gjk2_edges.h"
#include "gjk2_outward.h"
#include "gjk2_report.h"
#include "gjk2_witness.h"

// An overlap while it is being measured.
typedef struct plane_overlap {
  gjk2_search s;
  gjk2_edge edge;  // of the cores, when they intersect
} plane_overlap;

// Steps 4 and 5, for the feature from p to q, or p alone, whose line n . w = height bounds A - B. core: the depth of the
// cores, rounded up.
static void report(plane_overlap *o, const gjk2_vertex *p, const gjk2_vertex *q, const gjk2_length *length, gjk2_vec n,
                   int64_t height, int64_t core, gjk2_penetration_result *out) {
  const gjk2_search *s = &o->s;
  const int32_t radii = gjk2_convex_radii(s);
  out->intersecting = true;
  out->iterations = s->iterations;
  out->depth = (gjk_q16)(core + radii);
  out->depth = out->depth > 0 ? out->depth : 0;
  out->lower = out->depth;
  out->upper = out->depth;
  gjk2_unit_set(&out->normal, length, n);
  gjk2_length own;
  const gjk2_length *edge = length;  // of polygons n is the edge turned by a quarter
  if (s->curved && q != NULL) {
    const gjk2_vec across = gjk2_sub(q->w, p->w);
    if (gjk2_norm1(across) != 0) {
      gjk2_length_set(&own, across);
      edge = &own;
    } else {
      q = NULL;
    }
  }
  (void)gjk2_witness_points(s, p, q, edge, &out->normal, &out->point_a, &out->point_b);
  out->certificate.count = 0;
  if (s->curved) {
    out->certificate.proof = GJK2_PROOF_NONE;
    return;
  }
  gjk2_outward_normal(n, height, radii, out->depth, &out->normal);
  out->certificate.direction = n;
  out->certificate.count = q != NULL ? 2 : 1;
  out->certificate.a[0] = p->a.vertex;
  out->certificate.b[0] = p->b.vertex;
  if (q != NULL) {
    out->certificate.a[1] = q->a.vertex;
    out->certificate.b[1] = q->b.vertex;
  }
}

// Step 2. Pre: the feature is nearest, within the convex radii.
static void report_gap(plane_overlap *o, gjk2_penetration_result *out) {
  const gjk2_search *s = &o->s;
  gjk2_length length;
  gjk2_length_set(&length, s->d);
  const int64_t gap = gjk2_round_distance(&length, GJK2_ROUND_DOWN, (uint64_t)-s->base);
  report(o, gjk2_search_vertex(s, 0), s->count == 2 ? gjk2_search_vertex(s, 1) : NULL, &length, s->d, s->base, -gap,
         out);
  if (s->curved) {
    out->upper = out->depth + GJK2_CURVED_ERROR;
    out->lower = out->depth > GJK2_CURVED_ERROR + 1 ? out->depth - (GJK2_CURVED_ERROR + 1) : 0;
  } else {
    out->certificate.proof = GJK2_PROOF_NEAREST;
  }
}

// Step 3 of polygons.
static void report_edge(plane_overlap *o, gjk2_penetration_result *out) {
  const gjk2_edge *edge = &o->edge;
  const gjk2_vec n = gjk2_outward(gjk2_sub(edge->q.w, edge->p.w));
  const int64_t core = gjk2_round_distance(&edge->length, GJK2_ROUND_UP, (uint64_t)edge->height);
  report(o, &edge->p, &edge->q, &edge->length, n, edge->height, core, out);
  out->certificate.proof = GJK2_PROOF_EDGE;
}

// Step 3 where A - B is a point, the origin: every direction is as good.
static void report_anywhere(plane_overlap *o, gjk2_penetration_result *out) {
  const gjk2_vec n = {1, 0};
  gjk2_length length;
  gjk2_length_set(&length, n);
  report(o, gjk2_search_vertex(&o->s, 0), NULL, &length, n, 0, 0, out);
  out->certificate.proof = GJK2_PROOF_LINE;
}

// Step 3 of a curved pair.
static gjk_status report_curved(plane_overlap *o, gjk2_penetration_result *out) {
  gjk2_search *s = &o->s;
  int64_t lower;
  const gjk2_shape_class *of_a = s->a->shape->type, *of_b = s->b->shape->type;
  const bool settled = (of_a->depth != NULL ? of_a : of_b)->depth(s, &o->edge, &lower, &s->iterations);
  const int64_t core = gjk2_round_distance(&o->edge.length, GJK2_ROUND_UP, (uint64_t)o->edge.height);
  report(o, &o->edge.p, &o->edge.q, &o->edge.length, s->d, o->edge.height, core, out);
  const int64_t least = lower + gjk2_convex_radii(s) - GJK2_CURVED_ERROR;
  out->lower = least > 0 ? (gjk_q16)least : 0;
  out->upper = out->depth + GJK2_CURVED_ERROR;
  out->depth = settled ? out->depth : out->upper;
  return settled ? GJK_OK : GJK_ERROR_CAPACITY;
}

// Reports the overlap that step 1 has found. Pre: NEAREST: the feature is within the convex radii. ENCLOSING: of
// polygons A - B is a point.
static gjk_status report_overlap(plane_overlap *o, gjk2_outcome outcome, gjk2_penetration_result *out) {
  if (outcome == GJK2_OUTCOME_NEAREST) {
    report_gap(o, out);
  } else if (o->s.curved) {
    return report_curved(o, out);
  } else {
    report_anywhere(o, out);
  }
  return GJK_OK;
}

// Step 1 by the edges of A - B. OVERLAP: edge is set. APART: s->d separates the cores. OPEN: not known, s->d is 0.
static gjk2_lie measure_edges(plane_overlap *o) {
  gjk2_search *s = &o->s;
  return s->curved || gjk2_search_is_point(s) ? GJK2_LIE_OPEN : gjk2_nearest_edge(s, &o->edge);
}

// Step 1 by GJK, from a direction that separates where the edges have found one.
static gjk2_outcome search_on(plane_overlap *o, gjk2_goal goal, gjk2_lie lie, const gjk2_cache *cache) {
  gjk2_search *s = &o->s;
  const gjk2_vec d = s->d;
  gjk2_outcome outcome = gjk2_search_close(s);
  if (outcome != GJK2_OUTCOME_LIMIT) {
    return outcome;
  }
  if (cache != NULL) {
    gjk2_search_aim(s, cache);
  }
  if (lie == GJK2_LIE_APART && s->count == 0) {
    s->d = d;
  }
  outcome = gjk2_search_feature(s, goal, GJK2_NO_LIMIT);
  if (outcome == GJK2_OUTCOME_LIMIT && !s->curved) {  // a far frame alone
    gjk2_search_direct(s);
    outcome = GJK2_OUTCOME_NEAREST;
  }
  return outcome;
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

gjk_status gjk2_penetration(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                            gjk2_penetration_result *out) {
  gjk_status status = gjk2_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  plane_overlap o;
  gjk2_search *s = &o.s;
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
  const gjk2_lie lie = measure_edges(&o);
  if (lie == GJK2_LIE_OVERLAP) {
    report_edge(&o, out);
    if (cache != NULL) {
      gjk2_search_keep(s, GJK2_OUTCOME_ENCLOSING, cache);
    }
    return GJK_OK;
  }
  if (lie == GJK2_LIE_APART && radius == 0) {
    return report_apart(s, GJK2_OUTCOME_SEPARATED, cache, out);
  }
  const gjk2_outcome outcome = search_on(&o, GJK2_GOAL_DEPTH, lie, cache);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  if (outcome == GJK2_OUTCOME_SEPARATED ||
      (outcome == GJK2_OUTCOME_NEAREST && !gjk2_is_within(-s->base, s->d, radius))) {
    return report_apart(s, outcome, cache, out);
  }
  status = report_overlap(&o, outcome, out);
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
  return status;
}

// A depth as a distance: negative, its bounds exchanged.
static void plane_report_signed(const gjk2_penetration_result *overlapping, gjk2_distance_result *out) {
  out->distance = -overlapping->depth;
  out->lower = -overlapping->upper;
  out->upper = -overlapping->lower;
  gjk2_copy(&out->point_a, &overlapping->point_a);
  gjk2_copy(&out->point_b, &overlapping->point_b);
  out->normal.x = overlapping->normal.x;
  out->normal.y = overlapping->normal.y;
  out->intersecting = true;
  out->saturated = false;
  out->iterations = overlapping->iterations;
  const gjk2_certificate *c = &overlapping->certificate;
  gjk2_copy(&out->certificate.direction, &c->direction);
  out->certificate.count = c->count;
  out->certificate.proof = c->proof;
  for (unsigned i = 0; i < c->count; i++) {
    out->certificate.a[i] = c->a[i];
    out->certificate.b[i] = c->b[i];
  }
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
  plane_overlap o;
  gjk2_search *s = &o.s;
  gjk2_penetration_result overlapping;
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  gjk2_lie lie = GJK2_LIE_OPEN;
  gjk2_outcome outcome = GJK2_OUTCOME_ENCLOSING;
  const bool meet = gjk2_search_start(s, a, b, true, (uint32_t)radius);
  if (!meet) {
    (void)gjk2_search_start(s, a, b, false, (uint32_t)radius);
  }
  // A cached feature is likely to be the nearest still, and cores with a radius are likely to be apart. Others that are near
  // are likely to overlap.
  const bool apart = radius > 0 || (cache != NULL && cache->count > 0);
  if (meet && !apart) {
    lie = measure_edges(&o);
  }
  if (lie != GJK2_LIE_OVERLAP) {
    outcome = search_on(&o, GJK2_GOAL_SIGNED, lie, cache);
    if (outcome == GJK2_OUTCOME_ENCLOSING && apart) {
      lie = measure_edges(&o);
    }
  }
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return report_limit(s, out);
  }
  if (outcome == GJK2_OUTCOME_NEAREST && !(radius > 0 && s->far == 0 && gjk2_is_within(-s->base, s->d, radius))) {
    gjk2_distance_report(s, outcome, cache, out);
    return GJK_OK;
  }
  if (lie == GJK2_LIE_OVERLAP) {
    report_edge(&o, &overlapping);
  } else {
    status = report_overlap(&o, outcome, &overlapping);
  }
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
  plane_report_signed(&overlapping, out);
  return status;
}
