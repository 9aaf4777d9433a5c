// Casts of rounded and curved shapes in the plane, and with a margin.
//
// Let gap(s) be the distance of the cores at fraction s less radius, the convex radii and the margin. It is convex.
//
//   1. Polygons: if the line of the way passes the cores farther away than radius, the shapes miss: exact.
//   2. At the start, where the bounding circles meet: a gap of 0 or less is a hit. If it does not fall there, a miss.
//   3. At the end, likewise: a gap of 0 or less is a hit. If it falls there, a miss. Otherwise its least is on the way,
//      and after 1 that is 0 or less: a hit.
//   4. Newton's iteration from below. The shapes' nearest points at a fraction give a direction n. No point of A - B lies
//      beyond h, so there is no contact before the fraction at which n . (s t) = h + radius |n|: the next one.
//   5. Stop when that is less than an LSB of gap ahead. Then the gap there is at most 2 LSB, of curved shapes 4.
//
// Step 3 is put off until 5. Mostly the face that is met then shows that the way comes within radius before its end, exactly:
// the line crosses the edge and the way ends behind it, or is nearest to the vertex before its end; or the end is within radius.
//
// Steps 2 and 3 measure places that are integers. Places between are rounded to the nearest LSB to find n; that does not
// matter, since any n gives a true bound.
//
// Two shortcuts spare the last round. An edge whose span holds the next place is what is touched there. Where a vertex is
// nearest, the direction in which the line meets the circle around it is tried as n.
//
// Rounds: of a convex function each step of Newton's iteration halves the gap or the slope. The gap is below 2^33 LSB and
// above 1, and the slope is not below the gap that is left, so 66 rounds are never reached.
#include "../arith/gjk_ceilings.h"
#include "../plane/gjk2_measure.h"
#include "gjk2_advance_face.h"

// Supports of curved shapes are up to 2 LSB below the true ones.
#define PLANE_CURVED_SLACK 2

// The most gap at a hit of curved shapes.
#define PLANE_CURVED_GAP 4

// Does the gap fall along the way (-1), keep (0) or grow (1), by the last feature, at the start or the end? Exact of
// polygons with centres at most 2^30 apart.
static int plane_advance_slope(const gjk2_advancing *s, const gjk2_face *face, bool at_end) {
  if (!gjk2_face_is_edge(face) && !s->curved) {
    return -gjk2_way_is_ahead(s->way, face->p.o, at_end);
  }
  return gjk_sign64(gjk2_way_ahead(s->way, face->n));
}

static gjk2_bound plane_advance_bound(gjk2_advancing *s, gjk2_vec n, uint32_t near, gjk2_span *support,
                                      gjk_q30 *fraction, gjk2_rate *rate) {
  if (!GJK_SMALL &&
      (s->point || (s->nearest && s->face.count == 2))) {  // no vertex is farther along n than the nearest edge
    gjk2_copy_span(support, &s->face.p);
  } else {
    gjk2_way_scan(s->way, n, support);
  }
  return gjk2_cast_bound(s->way, n, gjk2_way_along(s->way, n, support->o), s->radius, near, fraction, rate);
}

// Does that much more of the fraction change the gap by less than 1 LSB?
static bool plane_is_step(const gjk2_rate *rate, gjk_q30 more) {
  bool exact;
  if (more <= 1 || rate->length >= rate->closing) {
    return true;
  }
  return more - 1 <= gjk2_ratio((uint64_t)rate->length, (uint64_t)rate->closing, &exact);
}

// The direction in which the line meets the circle of radius around the vertex p. False: it does not, or one that is too
// large for this.
//   along a unit vector of the way: v = -sqrt(radius^2 - side^2), and side across it
static bool plane_advance_disc(const gjk2_advancing *s, gjk2_vec *n, uint32_t *near) {
  const gjk2_way *way = s->way;
  const int64_t side = gjk2_way_side(way, s->face.p.o);
  const uint64_t size = gjk_magnitude64(side);
  if (way->wide || s->radius >> 29 != 0 || s->radius == 0 ||
      (GJK_SMALL ? gjk2_way_is_beside(way, s->face.p.o, s->radius)
                 : size > gjk_umul32(gjk2_length_bound(way->d), (uint32_t)s->radius))) {
    return false;
  }
  gjk2_length length;
  gjk2_unit u;
  gjk2_normal_set(&u, &length, &way->d);
  // In parts of an LSB, as fine as 30 bits allow: a radius of an LSB has directions, too.
  const unsigned up = gjk_clz32((uint32_t)s->radius) - 2, room = gjk_clz64(size | 1) - 3;
  const unsigned fine = up < room ? up : room;
  const int64_t radius = gjk_shl64(s->radius, up);  // from 2^29 to below 2^30
  const int64_t beside = gjk_shl64(gjk2_round_distance(&length, GJK2_ROUND_NEAREST, size << fine), up - fine);
  // beside <= 9/8 2^30, and off by at most half of what it was shifted by.
  if (beside > radius ||
      (!GJK_SMALL && beside + gjk_shl64(1, up - fine) > radius && gjk2_way_is_beside(way, s->face.p.o, s->radius))) {
    return false;
  }
  const int32_t back = -(int32_t)gjk2_root((uint64_t)(radius * radius - beside * beside), 0);
  const int32_t right = side > 0 ? (int32_t)beside : -(int32_t)beside;
  //   n = back u + right (u turned to the right), both at most 2^30, |u| <= 2^30 + 3: below 2^61
  *near = (uint32_t)radius;  // twice as long as n
  n->x = (int32_t)gjk_sar64(gjk_mac32(gjk_mul32(back, u.x), right, u.y), 31);
  n->y = (int32_t)gjk_sar64(gjk_mac32(gjk_mul32(back, u.y), -right, u.x), 31);
  return gjk2_norm1(*n) != 0;
}

// Of two fractions without contact before, takes the one that n proves if it is at most half an LSB of the way earlier.
static void plane_advance_settle(gjk2_advancing *s, gjk_q30 proven) {
  const uint64_t way = gjk_magnitude64(s->way->t.x) + gjk_magnitude64(s->way->t.y);  // below 2^33
  if (proven < s->fraction && (uint64_t)(s->fraction - proven) * way <= UINT64_C(1) << 29) {
    s->fraction = proven;
  }
}

// Where rounding the place of the fraction has closed a gap of less than an LSB.
static void plane_advance_touch(gjk2_advancing *s) {
  gjk2_face_touch(s);
  gjk_q30 next;
  gjk2_span support;
  if (plane_advance_bound(s, s->face.n, 0, &support, &next, NULL) == GJK2_BOUND_AT) {
    plane_advance_settle(s, next);
  }
}

// Polygons are known to hit, but the gap does not fall at the place: the way but grazes them, at a gap of at most 1.5 LSB.
// Half an LSB of the way before the gap is at most 2 LSB, and it falls.
static void plane_advance_graze(gjk2_advancing *s) {
  const uint64_t way = gjk_magnitude64(s->way->t.x) + gjk_magnitude64(s->way->t.y);
  const gjk_q30 back = (gjk_q30)((UINT32_C(1) << 29) / (way < UINT32_MAX ? (uint32_t)way : UINT32_MAX));
  s->fraction = s->fraction > back ? s->fraction - back : 0;
  plane_advance_touch(s);
}

// Curved shapes are within an LSB of the bound along a direction, but a grazing way goes far for that, and may have left them
// again by then. Then the last place that was measured is the answer: the gap there is as small.
static void plane_advance_stay(gjk2_advancing *s, gjk_q30 before) {
  const uint64_t way = gjk_magnitude64(s->way->t.x) + gjk_magnitude64(s->way->t.y);  // below 2^33
  if ((uint64_t)(s->fraction - before) * way >> 30 <= PLANE_CURVED_GAP) {
    return;
  }
  (void)gjk2_face_is_near(s, s->fraction);
  if (!s->gap.intersecting && s->gap.distance > (int64_t)s->margin + PLANE_CURVED_GAP) {
    s->fraction = before;
  }
}

static void plane_advance_hit(gjk2_advancing *s, gjk2_cast_result *out) {
  const gjk2_portion portion = {0, 1, s->fraction, true};
  gjk2_contact_place place = {&s->face.p, &s->face.p, 0, s->face.n};
  if (gjk2_face_is_edge(&s->face)) {
    const int64_t foot =
        !GJK_SMALL && s->at == s->fraction ? s->foot : gjk2_cast_foot(s->way, s->face.p.o, s->face.q.o, s->fraction);
    place.q = &s->face.q;
    place.weight = (gjk_q30)(foot < 0 ? 0 : foot > GJK_Q30_ONE ? GJK_Q30_ONE : foot);
  }
  gjk2_cast_hit(s->way, &place, &portion, out);
}

// The line meets the circle of radius R around a vertex p at s, in the direction n from p. Takes n in place of the direction d
// from p where n surely bounds more. theta is between n and d; v is the speed at which the way leads against n:
//   d's bound    is R (1 - cos theta) / |t| or more before s:  at least R 2^-21 / |t|
//   n's bound    is before s by three parts:
//                  an LSB of |n|       R 2^-29 / v
//                  its own rounding    2^-30
//                  the rounding of n   less than R 2^-40 / v
//                For v >= |t| / 32 and R >= |t| / 128 all three are less than R 2^-22 / |t|.
// False: it is not known, or another vertex is farther along n.
static bool plane_advance_direct(gjk2_advancing *s) {
  const gjk2_way *way = s->way;
  const gjk2_vec d = {s->face.n.x, s->face.n.y};
  const uint32_t size = gjk2_norm1(way->d), scans = way->scans;
  const int64_t closing = -gjk2_way_ahead(way, d);
  gjk2_vec n;
  uint32_t near;
  gjk_q30 closer;
  gjk2_rate rate;
  if (way->wide || s->radius >> 29 != 0 || s->radius << 7 < size ||
      closing <= (int64_t)(gjk_umul32(gjk2_norm1(d), size) >> 10) || !plane_advance_disc(s, &n, &near)) {
    return false;
  }
  const uint64_t turn = gjk_magnitude64(gjk2_cross(n, d));
  if (turn <= gjk_umul32(gjk2_norm1(n), gjk2_norm1(d)) >> 10 ||
      gjk2_cast_bound(way, n, gjk2_way_along(way, n, s->face.p.o), s->radius, near, &closer, &rate) != GJK2_BOUND_AT ||
      rate.closing < (int64_t)((uint64_t)rate.length * size >> 5) || closer < s->fraction) {
    return false;
  }
  if (!s->point) {
    gjk2_span support;
    gjk2_way_scan(s->way, n, &support);
    if (!gjk2_equal(support.o, s->face.p.o)) {
      s->way->scans = scans;
      return false;
    }
    s->way->scans++;  // and for d
  }
  s->fraction = closer;
  s->face.n = n;
  return true;
}

// The sum of the bounding circles' radii, and the margin.
static inline int64_t plane_advance_radius(const gjk2_advancing *s) {
  return s->radius + s->way->a->core_radius + s->way->b->core_radius;
}

// A fraction before which the bounding circles do not meet, where they do not at the start.
static gjk_q30 plane_advance_reach(const gjk2_advancing *s) {
  const gjk2_way *way = s->way;
  if (way->wide) {
    return 0;
  }
  const gjk2_vec delta = {(int32_t)way->delta.x, (int32_t)way->delta.y};
  const int64_t ahead = gjk2_dot(way->d, delta), squared = gjk2_dot(way->d, way->d);
  const int64_t reach = plane_advance_radius(s);
  // At most 1/8 too long, so that the bound is early.
  const int64_t before = ahead - (int64_t)gjk2_length_bound(way->d) * reach;
  bool exact;
  return before <= 0 ? 0 : before >= squared ? GJK_Q30_ONE : gjk2_ratio((uint64_t)before, (uint64_t)squared, &exact);
}

// The same for two circles that do not meet at the start, from the place of plane_advance_reach. It lies R or more before the
// centre along the way; the line meets the circle nearer. For a line that passes the centre at R / 8 or more the angle is above
// 2^-10, less 2^-12 by the place's rounding where R is 2^12 or more.
static bool plane_advance_circle(gjk2_advancing *s) {
  const gjk2_way *way = s->way;
  const uint32_t size = gjk2_norm1(way->d);
  if (way->wide || s->radius >> 28 != 0 || s->radius >> 12 == 0 || s->radius << 7 < size) {
    return false;
  }
  const gjk2_vec delta = {(int32_t)way->delta.x, (int32_t)way->delta.y};
  const uint64_t reach = gjk_umul32(gjk2_length_bound(way->d), (uint32_t)plane_advance_radius(s));
  const int64_t before = gjk2_dot(way->d, delta) - (int64_t)reach;
  gjk2_vec n;
  uint32_t near;
  gjk2_rate rate;
  gjk_q30 closer;
  gjk2_copy_span(&s->face.p, &gjk2_origin_span);
  if (before <= 0 || before >= gjk2_dot(way->d, way->d) || gjk_magnitude64(way->base) << 3 < reach ||
      !plane_advance_disc(s, &n, &near) ||
      gjk2_cast_bound(way, n, gjk2_dot(n, delta), s->radius, near, &closer, &rate) != GJK2_BOUND_AT ||
      rate.closing < (int64_t)((uint64_t)rate.length * size >> 5)) {
    return false;
  }
  s->way->scans++;
  s->fraction = closer;
  s->face.n = n;
  s->face.count = 1;
  return true;
}

// Step 4 and 5, once. Returns whether the fraction is the answer. Pre: the gap at the fraction is measured, or at one
// before it.
GJK_OUT_OF_LINE static bool plane_advance_round(gjk2_advancing *s, gjk2_bound *bound) {
  gjk_q30 next;
  gjk2_rate rate;
  gjk2_span support;
  if (GJK2_DIRECT && s->face.count == 1 && !s->curved) {
    *bound = GJK2_BOUND_AT;
    if (plane_advance_direct(s)) {
      return true;
    }
    if (s->raw) {
      gjk2_face_shorten(&s->face.n);
    }
  }
  *bound =
      plane_advance_bound(s, s->face.n, gjk2_face_is_edge(&s->face) ? 0 : UINT32_C(1) << 30, &support, &next, &rate);
  if (s->curved) {
    gjk2_copy_span(&s->face.p, &support);
  }
  if (*bound != GJK2_BOUND_AT) {
    return true;
  }
  const gjk_q30 before = s->fraction;
  s->fraction = next > before ? next : before;
  if (s->curved) {
    return plane_is_step(&rate, next - before);
  }
  if (gjk2_face_is_edge(&s->face)) {
    const int64_t foot = gjk2_cast_foot(s->way, s->face.p.o, s->face.q.o, s->fraction);
    if (foot >= 0 && foot <= GJK_Q30_ONE) {
      s->at = s->fraction;
      s->foot = foot;
      plane_advance_settle(s, next);
      return true;
    }
  } else {
    gjk2_vec n;
    gjk_q30 closer;
    uint32_t near;
    if (plane_advance_disc(s, &n, &near) && plane_advance_bound(s, n, near, &support, &closer, NULL) == GJK2_BOUND_AT &&
        closer >= next && closer >= before && gjk2_equal(support.o, s->face.p.o)) {
      s->fraction = closer;
      s->face.n = n;
      return true;
    }
  }
  if (!plane_is_step(&rate, next - before)) {
    return false;
  }
  s->fraction = before;  // at a grazing way the place ahead may be far from the face
  plane_advance_settle(s, next);
  return true;
}

// A miss, by the direction that parts the shapes at the start or at the end. From a vertex the exact one is reported.
static void plane_advance_short(const gjk2_advancing *s, const gjk2_face *face, bool at_end, gjk2_cast_result *out) {
  const gjk2_way *way = s->way;
  gjk2_cast_miss(way, s->curved ? GJK2_CAST_PROOF_NONE : GJK2_CAST_PROOF_SHORT, out);
  gjk2_copy(&out->certificate.direction, &face->n);
  if (!gjk2_face_is_edge(face) && !s->curved) {
    const int64_t x = (at_end ? way->t.x : 0) - way->delta.x - face->p.o.x;
    const int64_t y = (at_end ? way->t.y : 0) - way->delta.y - face->p.o.y;
    if ((gjk_magnitude64(x) | gjk_magnitude64(y)) >> 29 == 0) {
      out->certificate.direction.x = (int32_t)x;
      out->certificate.direction.y = (int32_t)y;
    }
  }
}

// Points, segments and boxes are centred: their classes have 1, 2 and 4 vertices.
static bool plane_is_centred(const gjk2_collider *c) {
  return (0x16u >> (c->shape->type->count & 7u) & 1u) != 0;
}

// Step 1. Pre: polygons. Without a way no line is there to be passed.
static bool plane_advance_is_beside(gjk2_advancing *s, gjk2_cast_result *out) {
  for (int left = 0; left < 2 && (s->way->t.x | s->way->t.y) != 0; left++) {
    gjk2_span nearest;
    if (!GJK_SMALL && s->centred && (left != 0 ? s->way->base >= 0 : s->way->base <= 0)) {  // so is the outermost there
      continue;
    }
    if (!GJK_SMALL && s->point) {
      gjk2_copy_span(&nearest, &gjk2_origin_span);
    } else {
      gjk2_way_outermost(s->way, left != 0, &nearest);
    }
    const int64_t side = gjk2_way_side(s->way, nearest.o);
    if ((left != 0 ? side < 0 : side > 0) && gjk2_way_is_beside(s->way, nearest.o, s->radius)) {
      gjk2_cast_miss(s->way, GJK2_CAST_PROOF_BESIDE, out);
      out->certificate.count = 1;
      out->certificate.a[0] = nearest.a.vertex;
      out->certificate.b[0] = nearest.b.vertex;
      return true;
    }
  }
  return false;
}

// Is a face at hand better than a distance at an end of the way? Where radii and margin are below 2^29, an end that may be near
// has a near frame, and both are exact.
static inline bool plane_is_put_off(const gjk2_advancing *s) {
  return !GJK_SMALL && !s->curved && s->radius >> 29 == 0;
}

static inline bool plane_is_late(const gjk2_advancing *s) {
  return !GJK_SMALL && s->late;
}

// Step 2. Finds the face at the start. Returns whether the gap there is at most the margin: exact of polygons.
static bool plane_advance_starts_near(gjk2_advancing *s) {
  if (!plane_is_put_off(s) || !gjk2_face_find(s, 0)) {
    if (gjk2_face_is_near(s, 0)) {
      return true;  // an overlap has no normal
    }
    gjk2_face_of_gap(s, &s->face);
    return false;
  }
  if (s->gap.intersecting) {
    return true;
  }
  const gjk2_long from = gjk2_cast_place_from(s->way, s->face.p.o, 0);
  return s->margin > 0 && gjk2_face_is_within(s, &s->face, &from) && gjk2_face_is_near(s, 0);
}

// Step 2. Returns whether out is written: a hit at the start, or a miss. Otherwise the start's face is set.
static bool plane_advance_decide_start(gjk2_advancing *s, gjk2_cast_result *out) {
  if (plane_advance_starts_near(s)) {
    gjk2_cast_inside(s->way, s->gap.intersecting ? NULL : &s->gap, out);
    return true;
  }
  if (!s->open && plane_advance_slope(s, &s->face, false) >= 0) {
    plane_advance_short(s, &s->face, false, out);
    return true;
  }
  return false;
}

// Step 3, where it is open. Returns whether out is written: a miss. Otherwise polygons hit.
static bool plane_advance_decide_end(gjk2_advancing *s, gjk2_cast_result *out) {
  gjk2_face end;
  if (gjk2_face_is_near(s, GJK_Q30_ONE)) {
    return false;
  }
  gjk2_face_of_gap(s, &end);
  if (plane_advance_slope(s, &end, true) >= 0) {
    return false;
  }
  plane_advance_short(s, &end, true, out);
  return true;
}

static void plane_advance_set(gjk2_advancing *s, gjk2_way *way, gjk_q16 margin) {
  const int64_t radius = (int64_t)way->a->shape->convex_radius + way->b->shape->convex_radius + margin;
  s->way = way;
  s->margin = margin;
  s->curved = gjk2_is_curved(way->a->shape) || gjk2_is_curved(way->b->shape);
  s->radius = radius + (s->curved ? PLANE_CURVED_SLACK : 0);
  s->fraction = 0;
  s->open = false;
  if (!GJK_SMALL) {
    s->point = way->a->count == 1 && way->b->count == 1;
    s->centred = plane_is_centred(way->a) && plane_is_centred(way->b);
    s->nearest = false;
    s->raw = false;
    s->late = false;
    s->at = -1;
  }
}

// Reports a hit, unless it is open whether the way ends before it, and it does.
static void plane_advance_finish(gjk2_advancing *s, gjk2_cast_result *out) {
  if (!plane_is_late(s) || gjk2_face_is_met(s, &s->face) || !plane_advance_decide_end(s, out)) {
    plane_advance_hit(s, out);
  }
}

// Steps 4 and 5. measured: the face of the gap at the fraction is known.
static gjk_status plane_advance_run(gjk2_advancing *s, bool measured, gjk2_cast_result *out) {
  for (int i = 0; i < GJK2_ADVANCE_ROUNDS_MAX; i++) {
    gjk2_bound bound;
    if (!measured && !(!GJK_SMALL && s->point && gjk2_face_at_vertex(s))) {
      const bool found = !s->curved && !GJK_SMALL && gjk2_face_find(s, s->fraction);
      if (!found) {
        (void)gjk2_face_is_near(s, s->fraction);
      }
      if (s->gap.intersecting) {
        // Supports of curved shapes err by as much as the slack. The last round's direction bounds the fraction, and stays. There
        // is a last round: where bounding circles meet, cores are apart by the slack of both circles and PLANE_CURVED_SLACK.
        if (!s->curved) {
          gjk2_face_load(s->way, s->gap.certificate.a[0], s->gap.certificate.b[0], &s->face.p);
          plane_advance_touch(s);
        }
        plane_advance_finish(s, out);
        return GJK_OK;
      }
      if (!found) {
        gjk2_face_of_gap(s, &s->face);
      }
    }
    measured = false;
    const gjk_q30 before = s->fraction;
    if (plane_advance_round(s, &bound)) {
      if (s->open && bound != GJK2_BOUND_BEYOND &&
          (bound == GJK2_BOUND_AWAY || s->gap.upper == GJK2_DISTANCE_MAX ||
           s->gap.upper - PLANE_CURVED_GAP > s->margin)) {
        return GJK_ERROR_ITERATION_LIMIT;
      }
      if (bound != GJK2_BOUND_AT && s->curved) {
        plane_advance_short(s, &s->face, false, out);
        return GJK_OK;
      }
      if (s->curved) {
        plane_advance_stay(s, before);
      } else if (bound != GJK2_BOUND_AT) {
        if (plane_is_late(s) && bound == GJK2_BOUND_BEYOND) {  // the last direction parts the shapes on the whole way
          gjk2_cast_miss(s->way, GJK2_CAST_PROOF_SHORT, out);
          gjk2_copy(&out->certificate.direction, &s->face.n);
          return GJK_OK;
        }
        if (plane_is_late(s) && plane_advance_decide_end(s, out)) {
          return GJK_OK;
        }
        s->late = false;
        plane_advance_graze(s);
      }
      plane_advance_finish(s, out);
      return GJK_OK;
    }
  }
  return GJK_ERROR_ITERATION_LIMIT;
}

gjk_status gjk2_advance(gjk2_way *way, gjk_q16 margin, bool early, bool late, gjk2_cast_result *out) {
  gjk2_advancing s;
  plane_advance_set(&s, way, margin);
  if (!s.curved && plane_advance_is_beside(&s, out)) {
    return GJK_OK;
  }
  s.late = late && plane_is_put_off(&s);
  if (GJK2_DIRECT && s.point && !early && s.late == late && plane_advance_circle(&s)) {
    plane_advance_finish(&s, out);
    return GJK_OK;
  }
  if (early && plane_advance_decide_start(&s, out)) {
    return GJK_OK;
  }
  if (late && !s.late && !s.curved && plane_advance_decide_end(&s, out)) {
    return GJK_OK;
  }
  if (!early) {
    s.fraction = plane_advance_reach(&s);
  }
  return plane_advance_run(&s, early, out);
}

// Steps 1 to 3 are known.
gjk_status gjk2_advance_to_edge(gjk2_way *way, gjk_q16 margin, const gjk2_span *p, const gjk2_span *q,
                                gjk2_cast_result *out) {
  gjk2_advancing s;
  plane_advance_set(&s, way, margin);
  gjk2_copy_span(&s.face.p, p);
  gjk2_copy_span(&s.face.q, q);
  s.face.n = gjk2_outward(gjk2_sub(q->o, p->o));
  s.face.count = 2;
  return plane_advance_run(&s, true, out);
}
