// How two shapes of the plane meet.
//
//   1. Find out how the cores lie. Of polygons whose bounding circles meet: by the edges of A - B, of which the nearest
//      to the origin gives the depth (gjk2_edges.h). Others: by GJK. Points, segments and boxes that are apart
//      need neither, and do not come here (gjk2_close.c).
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
#include "gjk2_meeting.h"

#include "gjk2_canonical.h"
#include "gjk2_outward.h"
#include "gjk2_report.h"
#include "gjk2_witness.h"

// Steps 2 and 3: depth and normal, where length, n and height are known. core: the depth of the cores, rounded up.
static void set_overlap(gjk2_meeting *m, const gjk2_vertex *p, const gjk2_vertex *q, int64_t core, uint8_t proof) {
  const gjk2_search *s = &m->s;
  const int32_t radii = gjk2_convex_radii(s), depth = (int32_t)core + radii;
  m->overlaps = true;
  m->saturated = false;
  m->p = p;
  m->q = q;
  m->proof = proof;
  m->distance = depth > 0 ? -depth : 0;
  m->lower = m->distance;
  m->upper = m->distance;
  // Components one by one: GCC copies a vector by a call of memcpy at -Os on ARMv6-M.
  const gjk2_vec n = {m->n.x, m->n.y};
  gjk2_quick_unit(&m->across, &m->length, n);
  m->normal.x = m->across.x;
  m->normal.y = m->across.y;
  if (s->curved) {
    m->proof = GJK2_PROOF_NONE;
  } else if (depth > 0 && (!GJK2_IN_LINE ||
                           !gjk2_outward_is_clear(m->n, m->height, radii, &m->length, depth, &m->normal))) {  // Step 5
    gjk2_outward_normal(m->n, m->height, radii, &m->length, depth, &m->normal);
  }
}

bool gjk2_meeting_points(const gjk2_meeting *m, gjk2_vec *point_a, gjk2_vec *point_b) {
  const gjk2_search *s = &m->s;
  const gjk2_vertex *q = m->q;
  const gjk2_length *edge = &m->length;  // of polygons n is the edge turned by a quarter
  gjk2_length own;
#if GJK2_IN_LINE
  if (q == NULL) {
    bool saturated = false;
    gjk2_witness_corner(s->a, m->p->a.offset, &m->across, 1, point_a, &saturated);
    gjk2_witness_corner(s->b, m->p->b.offset, &m->across, -1, point_b, &saturated);
    return saturated;
  }
#endif
  if (GJK_SHAPES >= GJK_SHAPES_ALL && m->overlaps && s->curved && q != NULL) {
    const gjk2_vec across = gjk2_sub(q->w, m->p->w);
    if (gjk2_norm1(across) != 0) {
      gjk2_length_set(&own, across);
      edge = &own;
    } else {
      q = NULL;
    }
  }
  return gjk2_witness_points(s, m->p, q, edge, &m->across, point_a, point_b);
}

void gjk2_meeting_certify(const gjk2_meeting *m, gjk2_certificate *out) {
  out->count = 0;
  out->proof = m->proof;
  if (m->proof == GJK2_PROOF_NONE) {
    return;
  }
  gjk2_copy(&out->direction, &m->n);
  out->count = m->q != NULL ? 2 : 1;
  out->a[0] = m->p->a.vertex;
  out->b[0] = m->p->b.vertex;
  if (m->q != NULL) {
    out->a[1] = m->q->a.vertex;
    out->b[1] = m->q->b.vertex;
  }
}

gjk2_lie gjk2_meeting_edges(gjk2_meeting *m) {
  gjk2_search *s = &m->s;
  return GJK_SHAPES <= GJK_SHAPES_POINTS || s->curved || gjk2_search_is_point(s) ? GJK2_LIE_OPEN
                                                                                 : gjk2_nearest_edge(s, &m->edge);
}

gjk2_outcome gjk2_meeting_search(gjk2_meeting *m, gjk2_goal goal, gjk2_lie lie, const gjk2_cache *cache) {
  gjk2_search *s = &m->s;
  const gjk2_vec d = s->d;
  if (cache != NULL) {
    gjk2_search_aim(s, cache);
  }
  if (lie == GJK2_LIE_APART && s->count == 0) {
    s->d = d;
  }
  gjk2_outcome outcome = gjk2_search_feature(s, goal, GJK2_NO_LIMIT);
  if (outcome == GJK2_OUTCOME_LIMIT && !s->curved) {  // a far frame alone
    gjk2_search_direct(s);
    outcome = GJK2_OUTCOME_NEAREST;
  }
  return outcome;
}

static bool measure_plane_gap(gjk2_meeting *m) {
  gjk2_search *s = &m->s;
  const int32_t radius = gjk2_convex_radii(s);
  const uint64_t h = (uint64_t)-s->base;
  const gjk2_vec d = {s->d.x, s->d.y};
  gjk2_quick_length(&m->length, d);
  if (radius == 0 || s->far != 0) {
    return false;
  }
  const int64_t gap = gjk2_quick_distance(&m->length, GJK2_ROUND_DOWN, h);
  if (gap > radius || (gap == radius && !gjk2_is_within(-s->base, d, radius))) {
    return false;
  }
  gjk2_copy(&m->n, &s->d);
  m->height = s->base;
  set_overlap(m, gjk2_search_vertex(s, 0), s->count == 2 ? gjk2_search_vertex(s, 1) : NULL, -gap, GJK2_PROOF_NEAREST);
  if (s->curved) {
    m->lower -= GJK2_CURVED_ERROR;
    m->upper = m->distance < -(GJK2_CURVED_ERROR + 1) ? m->distance + (GJK2_CURVED_ERROR + 1) : 0;
  }
  return true;
}

bool gjk2_meeting_gap(gjk2_meeting *m) {
  return measure_plane_gap(m);
}

// Step 3 of a curved pair.
static gjk_status overlap_curved(gjk2_meeting *m) {
  gjk2_search *s = &m->s;
  int64_t lower;
  const gjk2_shape_class *of_a = s->a->shape->type, *of_b = s->b->shape->type;
  const bool settled = (of_a->depth != NULL ? of_a : of_b)->depth(s, &m->edge, &lower, &s->iterations);
  const int64_t core = gjk2_round_distance(&m->edge.length, GJK2_ROUND_UP, (uint64_t)m->edge.height);
  gjk2_copy_length(&m->length, &m->edge.length);
  gjk2_copy(&m->n, &s->d);
  m->height = m->edge.height;
  set_overlap(m, &m->edge.p, &m->edge.q, core, GJK2_PROOF_NONE);
  const int64_t least = lower + gjk2_convex_radii(s) - GJK2_CURVED_ERROR;
  m->upper = least > 0 ? (gjk_q16)-least : 0;
  m->lower = m->distance - GJK2_CURVED_ERROR;
  m->distance = settled ? m->distance : m->lower;
  return settled ? GJK_OK : GJK_ERROR_CAPACITY;
}

gjk_status gjk2_meeting_overlap(gjk2_meeting *m, gjk2_lie lie) {
  gjk2_edge *edge = &m->edge;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && lie == GJK2_LIE_OVERLAP) {
    gjk2_copy_length(&m->length, &edge->length);
    m->n = gjk2_outward(gjk2_sub(edge->q.w, edge->p.w));
    m->height = edge->height;
    const int64_t core = gjk2_round_distance(&m->length, GJK2_ROUND_UP, (uint64_t)edge->height);
    set_overlap(m, &edge->p, &edge->q, core, GJK2_PROOF_EDGE);
    return GJK_OK;
  }
  if (GJK_SHAPES >= GJK_SHAPES_ALL && m->s.curved) {
    return overlap_curved(m);
  }
  // A - B is a point, the origin: every direction is as good.
  m->n.x = 1;
  m->n.y = 0;
  m->height = 0;
  gjk2_length_set(&m->length, m->n);
  set_overlap(m, gjk2_search_vertex(&m->s, 0), NULL, 0, GJK2_PROOF_LINE);
  return GJK_OK;
}

// The shapes are apart. Pre: length is that of s.d.
static void set_plane_apart(gjk2_meeting *m) {
  gjk2_search *s = &m->s;
  m->overlaps = false;
  m->saturated = false;
  m->p = gjk2_search_vertex(s, 0);
  m->q = s->count == 2 ? gjk2_search_vertex(s, 1) : NULL;
  const gjk2_vec d = {s->d.x, s->d.y};
  gjk2_quick_unit(&m->across, &m->length, d);
  m->normal.x = m->across.x;
  m->normal.y = m->across.y;
  m->distance = gjk2_distance_of(s, &m->length, &m->saturated);
  m->lower = m->distance;
  m->upper = m->distance;
}

// Do the bounding circles meet? Pre: started.
static bool circles_meet(const gjk2_search *s) {
  const int32_t limit = s->a->radius + s->b->radius;  // each at most 2^28 + 4
  return s->far == 0 && gjk2_dot(s->delta, s->delta) <= gjk_mul32(limit, limit);
}

gjk_status gjk2_meet(gjk2_meeting *m, const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache) {
  gjk2_search *s = &m->s;
  gjk_status status = GJK_OK;
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  (void)gjk2_search_start(s, a, b, false, (uint32_t)radius);
  // A cached feature is likely to be the nearest still, and cores with a radius are likely to be apart. Others that are near
  // are likely to overlap.
  const bool apart = radius > 0 || (cache != NULL && (cache->count == 1 || cache->count == 2)) || !circles_meet(s);
  gjk2_lie lie = apart ? GJK2_LIE_OPEN : gjk2_meeting_edges(m);
  gjk2_outcome outcome = GJK2_OUTCOME_ENCLOSING;
  if (lie != GJK2_LIE_OVERLAP) {
    outcome = gjk2_meeting_search(m, GJK2_GOAL_SIGNED, lie, cache);
    if (outcome == GJK2_OUTCOME_ENCLOSING && apart) {
      lie = gjk2_meeting_edges(m);
    }
  }
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  if (outcome == GJK2_OUTCOME_ENCLOSING) {
    status = gjk2_meeting_overlap(m, lie);
  } else if (!measure_plane_gap(m)) {
    set_plane_apart(m);
  }
  if (cache != NULL) {
    gjk2_search_keep(s, outcome, cache);
  }
  return status;
}
