// The gap on the way of a cast: the steps of one measurement.
//
//   Step 1   Set the frame: centre_a - centre_b at the fraction, as fine as the frame is, not only to whole LSB.
//   Step 2   Move the feature of the last measurement there, vertex by vertex.
//   Step 3   Search for the nearest feature.
//   Step 4   The plane through it across its direction bounds the gap from below. A fine frame takes it along the unit
//            normal. A coarse one, where an error of the normal may be LSB, takes the exact distance, rounded down.
#include "gjk_gap.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_unit.h"
#include "../gjk/gjk_frame.h"
#include "../gjk/gjk_search.h"
#include "../query/gjk_distance.h"

// How far off the plane along the unit normal may be in a fine frame, Q30 in units of the frame: fine_gap adds it up.
#define POLYTOPE_ERROR (INT64_C(1) << 33)
#define CURVED_ERROR (INT64_C(1) << 34)

// From these shifts on that is at most 1/2 LSB, of a curved pair 1/8: the frame is fine.
#define POLYTOPE_SHIFT 4
#define CURVED_SHIFT 7

// Is x no int32?
static bool exceeds_int32(int64_t x) {
  return (x ^ gjk_sar64(x, 63)) >> 31 != 0;
}

void gjk_gap_start(gjk_gap *gap, const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius) {
  gjk_iteration *it = &gap->it;
  gap->way = way;
  gap->radius = radius;
  gap->start.x = (int64_t)a->centre.x - b->centre.x;
  gap->start.y = (int64_t)a->centre.y - b->centre.y;
  gap->start.z = (int64_t)a->centre.z - b->centre.z;
  gap->scale = exceeds_int32(way->t.x) || exceeds_int32(way->t.y) || exceeds_int32(way->t.z) ? 1 : 0;
  gap->used = 0;
  it->a = a;
  it->b = b;
  it->radius = 0;
  it->shift = -1;  // no feature that Step 2 could move
  it->stalls = a->shape->type->stalls;
  if (!gjk_pair_is_curved(it)) {
    it->stalls = b->shape->type->stalls;
  }
}

// One axis of centre_a - centre_b, Q30 LSB.
//   both centres are int32 on the whole way:   |result| <= 2^62
//   |start| < 2^32, |t| < 2^32, fraction <= 2^30
static int64_t apart(int64_t start, int64_t t, gjk_q30 fraction) {
  return gjk_shl64(start, 30) - t * fraction;
}

// One axis of the frame's delta, and what it leaves, Q30 LSB: at most 2^(29 - shift) in size.
GJK_ONE_COPY static int32_t frame_axis(int64_t apart, unsigned shift, int32_t *rest) {
  const unsigned n = 30 - shift;
  const int64_t delta = gjk_sar64(apart + gjk_shl64(1, n - 1), n);
  *rest = (int32_t)(apart - gjk_shl64(delta, n));
  return (int32_t)delta;
}

// Step 1 for centres less than 2^29 apart along each axis, as gjk_frame_set. Sets shift, delta and rest.
static void set_near_frame(gjk_gap *gap, const gjk_long3 *at) {
  gjk_iteration *it = &gap->it;
  // Whole LSB, rounded up: below 3 2^29 + 3; with the cores below 2^31. Another 3 for what rounding delta may add.
  const uint32_t reach = (uint32_t)(gjk_magnitude64(at->x) >> 30) + (uint32_t)(gjk_magnitude64(at->y) >> 30) +
                         (uint32_t)(gjk_magnitude64(at->z) >> 30) + 6 +
                         (uint32_t)(it->a->core_radius + it->b->core_radius);
  const unsigned zeros = gjk_clz32(reach), shift = zeros < 2 ? 0 : zeros - 2;
  it->shift = (int8_t)shift;
  it->delta.x = frame_axis(at->x, shift, &gap->rest.x);
  it->delta.y = frame_axis(at->y, shift, &gap->rest.y);
  it->delta.z = frame_axis(at->z, shift, &gap->rest.z);
}

// One axis of a vertex of A - B in the new frame. The offset, in LSB, stays.
GJK_ONE_COPY static int32_t vertex_axis(int32_t w, int32_t from, unsigned from_shift, int32_t to, unsigned to_shift) {
  return to + gjk_shl32(gjk_sar32(w - from, from_shift), to_shift);
}

// Step 2. from: the delta of the last measurement. False: start cold.
static bool move_feature(gjk_iteration *it, const gjk_vec3 *from, unsigned from_shift) {
  gjk_simplex *s = &it->simplex;
  const unsigned n = s->count, shift = (unsigned)it->shift;
  const uint8_t order[3] = {s->order[0], s->order[1], s->order[2]};
  s->count = 0;
  for (unsigned i = 0; i < n && i < 3; i++) {  // n <= 3
    gjk_vec3 *w = &s->slot[order[i]].w;
    w->x = vertex_axis(w->x, from->x, from_shift, it->delta.x, shift);
    w->y = vertex_axis(w->y, from->y, from_shift, it->delta.y, shift);
    w->z = vertex_axis(w->z, from->z, from_shift, it->delta.z, shift);
  }
  for (unsigned i = 0; i < n && i < 3; i++) {  // n <= 3
    unsigned free = s->count;
    while (free < 3 && s->order[free] != order[i]) {  // the slot is among those that are not of the feature
      free++;
    }
    s->order[free] = s->order[s->count];
    s->order[s->count] = order[i];
    if (gjk_simplex_add(s) == GJK_STEP_ENCLOSING) {
      return false;
    }
  }
  return s->count == 3 || gjk_simplex_direction(s, &it->direction);
}

// Step 3.
static gjk_outcome search(gjk_gap *gap) {
  gjk_iteration *it = &gap->it;
  const unsigned left = gjk_pair_is_curved(it) ? GJK_ITERATIONS_MAX : GJK_NO_LIMIT;
  it->iterations = 0;
  const gjk_outcome outcome = gjk_search_any(it, GJK_GOAL_SIGNED, NULL, left);
  gap->used += it->iterations;
  return outcome;
}

// The vertex whose plane across the direction bounds A - B.
//   NEAREST    of polytopes one of the feature; of a curved pair the support point, which has gained too little to be added
//   LIMIT      the newest one, which is the support point
static const gjk_vec3 *bounding_vertex(const gjk_iteration *it, gjk_outcome outcome) {
  const gjk_simplex *s = &it->simplex;
  const unsigned newest = outcome == GJK_OUTCOME_NEAREST && gjk_pair_is_curved(it) ? s->count : s->count - 1u;
  return &s->slot[s->order[newest]].w;
}

// Step 4 for a fine or far frame. The error of the plane, Q30 in units of the frame:
//   normal     within 2^-28 of the exact direction, |w| < 2^30         2^32
//   delta      rounded by sqrt(3) / 2                                  2^30
//   Together below 2^33 - 2^31 for polytopes.
//   curved     the support point is one along the rounded direction, which is off by up to sqrt(3) in 2^29; a vertex of the
//              pair's polytope is off by the size of its shape, up to 2^30, times that: 4 2^30
//   far        vertices are rounded by sqrt(3) / 2, the centres' difference by as much: 2^31
// Together below 2^34. What is left of it, at least 2^31, is 2^-28 LSB or more: so the sign of a small component of the
// normal, 2^-28 of the length, does not matter where positions are rounded away from A.
static int64_t fine_gap(const gjk_gap *gap, const gjk_vec3 *w) {
  const bool exact = !gjk_pair_is_curved(&gap->it) && gap->it.shift >= 0;
  const int64_t plane = -gjk_along(&gap->normal, w) - (exact ? POLYTOPE_ERROR : CURVED_ERROR);
  return gjk_sar64(plane, (unsigned)(14 + gap->it.shift)) - gjk_shl64(gap->radius, 16);
}

// *numerator 16: the square of four times the distance.
static void quadruple(gjk_u192 *numerator) {
  for (int i = 0; i < 4; i++) {
    gjk_u192_add(numerator, numerator);
  }
}

// The squared distance of the plane through w across the direction: (d . w)^2 / d^2.
static void squared_plane(const gjk_iteration *it, const gjk_vec3 *w, gjk_u192 *numerator, gjk_u192 *denominator) {
  const gjk_vec3 *d = &it->direction.d;
  gjk_u192 along;
  gjk_u192_set(&along, gjk_magnitude64(gjk_dot(d, w)));
  gjk_u192_multiply(numerator, &along, &along);
  gjk_u192_set(denominator, (uint64_t)gjk_dot(d, d));
}

// Step 4 for a coarse frame: 0 <= shift, below that of a fine frame. The distance is found to a quarter of the frame's unit.
//   numerator   below 2^184 where edges have 31 bits (gjk_simplex.h): 16 times, and 4 times in the comparison, below 2^192
GJK_OUT_OF_LINE static int64_t coarse_gap(gjk_gap *gap, gjk_outcome outcome, const gjk_vec3 *w) {
  gjk_iteration *it = &gap->it;
  gjk_u192 numerator, denominator;
  gjk_support b;
  if (!gjk_pair_is_curved(it)) {
    gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  } else {
    if (outcome == GJK_OUTCOME_NEAREST) {
      gjk_iteration_next(it, &b);  // the search may have moved it along the exact direction
    }
    if (gjk_dot(&it->direction.d, w) >= 0) {
      return -gjk_shl64(gap->radius, 16);
    }
    squared_plane(it, w, &numerator, &denominator);
  }
  quadruple(&numerator);
  const int64_t plane = -gjk_along(&gap->normal, w);
  const int64_t low = gjk_sar64(plane - CURVED_ERROR, 28), high = gjk_sar64(plane + CURVED_ERROR, 28);
  const int64_t quarters =
      gjk_round_distance(&numerator, &denominator, low > 0 ? low : 0, high > 0 ? high : 0, 0, GJK_ROUND_DOWN);
  // What rest moves the shapes apart along the normal; another 2^-14 LSB for the errors of the normal.
  const gjk_vec3 *rest = &gap->rest;
  const int64_t of_rest = gjk_along(&gap->normal, rest);  // Q60, |rest| <= sqrt(3) 2^29
  return gjk_sar64(gjk_shl64(quarters, 14), (unsigned)it->shift) - gjk_sar64(of_rest, 44) - 4 -
         gjk_shl64(gap->radius, 16);
}

// Step 4. Pre: outcome is NEAREST or LIMIT.
static void bound(gjk_gap *gap, gjk_outcome outcome) {
  const gjk_vec3 *w = bounding_vertex(&gap->it, outcome);
  gap->normal = gjk_unit(&gap->it.direction.d);
  const int fine = gjk_pair_is_curved(&gap->it) ? CURVED_SHIFT : POLYTOPE_SHIFT;
  gap->above = gap->it.shift >= fine || gap->it.shift < 0 ? fine_gap(gap, w) : coarse_gap(gap, outcome, w);
}

static bool fits_near_frame(int64_t apart) {
  return gjk_magnitude64(apart) >> 59 == 0;
}

// Steps 1, 3 and 4 for centres farther apart: the frame needs centres, so copies of the colliders have some. Its shift is
// from -3 to 0.
GJK_OUT_OF_LINE static gjk_outcome measure_far(gjk_gap *gap, const gjk_long3 *at) {
  gjk_iteration *it = &gap->it;
  const gjk_collider *a = it->a, *b = it->b;
  const int64_t half = INT64_C(1) << 29;
  gjk_collider moved_a, moved_b;
  gjk_copy(&moved_a, a, sizeof moved_a);
  gjk_copy(&moved_b, b, sizeof moved_b);
  // The difference rounded to LSB is at most 2^32 in size, so half of it, and what that leaves, fit.
  const gjk_long3 lsb = {gjk_sar64(at->x + half, 30), gjk_sar64(at->y + half, 30), gjk_sar64(at->z + half, 30)};
  gap->rest.x = (int32_t)(at->x - gjk_shl64(lsb.x, 30));
  gap->rest.y = (int32_t)(at->y - gjk_shl64(lsb.y, 30));
  gap->rest.z = (int32_t)(at->z - gjk_shl64(lsb.z, 30));
  moved_a.centre.x = (int32_t)gjk_sar64(lsb.x, 1);
  moved_a.centre.y = (int32_t)gjk_sar64(lsb.y, 1);
  moved_a.centre.z = (int32_t)gjk_sar64(lsb.z, 1);
  moved_b.centre.x = (int32_t)(moved_a.centre.x - lsb.x);
  moved_b.centre.y = (int32_t)(moved_a.centre.y - lsb.y);
  moved_b.centre.z = (int32_t)(moved_a.centre.z - lsb.z);
  it->a = &moved_a;
  it->b = &moved_b;
  gjk_frame_set_far(it, false, 0);
  gjk_simplex_clear(&it->simplex);
  const gjk_outcome outcome = search(gap);
  it->a = a;
  it->b = b;
  if (outcome != GJK_OUTCOME_ENCLOSING) {
    bound(gap, outcome);
  }
  it->shift = -1;
  return outcome;
}

// Steps 1 and 2 for centres less than 2^29 apart along each axis. Returns whether the feature has been moved.
static bool move_near(gjk_gap *gap, const gjk_long3 *at) {
  gjk_iteration *it = &gap->it;
  const gjk_vec3 from = it->delta;
  const int from_shift = it->shift;
  set_near_frame(gap, at);
  return from_shift >= 0 && move_feature(it, &from, (unsigned)from_shift);
}

static gjk_long3 apart_at(const gjk_gap *gap, gjk_q30 fraction) {
  const gjk_long3 *t = &gap->way->t;
  const gjk_long3 at = {apart(gap->start.x, t->x, fraction), apart(gap->start.y, t->y, fraction),
                        apart(gap->start.z, t->z, fraction)};
  return at;
}

gjk_outcome gjk_gap_measure(gjk_gap *gap, gjk_q30 fraction) {
  gjk_iteration *it = &gap->it;
  const gjk_long3 at = apart_at(gap, fraction);
  if (!fits_near_frame(at.x) || !fits_near_frame(at.y) || !fits_near_frame(at.z)) {
    return measure_far(gap, &at);
  }
  if (!GJK_SMALL && gjk_search_may_close(it)) {
    it->shift = -1;  // no feature to move
  }
  if (!move_near(gap, &at)) {
    gjk_simplex_clear(&it->simplex);
  }
  const gjk_outcome outcome = search(gap);
  if (outcome != GJK_OUTCOME_ENCLOSING) {
    bound(gap, outcome);
  } else {
    it->shift = -1;
  }
  return outcome;
}

bool gjk_gap_follow(gjk_gap *gap, gjk_q30 fraction) {
  gjk_iteration *it = &gap->it;
  const gjk_long3 at = apart_at(gap, fraction);
  if (it->simplex.count < 3 || it->shift < 0 || gjk_pair_is_curved(it) || !fits_near_frame(at.x) ||
      !fits_near_frame(at.y) || !fits_near_frame(at.z)) {
    return false;
  }
  return move_near(gap, &at) && it->simplex.count == 3;
}

gjk_slope gjk_gap_slope(const gjk_gap *gap) {
  const gjk_long3 *t = &gap->way->t;
  const unsigned scale = gap->scale;
  const gjk_vec3 way = {(int32_t)gjk_sar64(t->x, scale), (int32_t)gjk_sar64(t->y, scale),
                        (int32_t)gjk_sar64(t->z, scale)};  // each at most 2^31 in size
  // Errors, Q30: the normal's 2^-28 times |way|, at most 4 norm1 < 2^35; of the shift, at most sqrt(3) < 2.
  const int64_t norm = (int64_t)gjk_magnitude32(way.x) + gjk_magnitude32(way.y) + gjk_magnitude32(way.z);
  const int64_t error = 4 * norm + (scale > 0 ? INT64_C(1) << 31 : 0);
  const int64_t along = gjk_along(&gap->normal, &way);  // |way| <= sqrt(3) 2^31: below 2^62
  const gjk_slope slope = {-along - error, error - along};
  return slope;
}

// Likewise of a vertex.
static gjk_q16 vertex_point(int32_t u, gjk_q30 normal, gjk_q16 radius) {
  return u + (gjk_q16)gjk_sar64(gjk_mac32(INT64_C(1) << 30, normal, 2 * radius), 31);
}

// One coordinate of the nearest point, from those of the feature's vertices of A.
static gjk_q16 point_axis(const gjk_barycentric weight[2], int32_t u, int32_t v, int32_t w, gjk_q30 normal,
                          gjk_q16 radius) {
  v -= u;  // offsets are at most 2^28 in size
  w -= u;
  const int64_t low = gjk_sar64(gjk_mac32(gjk_mul32(v, weight[0].low), w, weight[1].low), 16);
  // Q31: |u| 2^31 <= 2^59, the weights are together at most 2^31, |radius normal| <= 2^58:  partial sums below 2^62
  const int64_t core = gjk_mac32(gjk_mac32(gjk_shl64(u, 31) + low, v, weight[0].high), w, weight[1].high);
  return (gjk_q16)gjk_sar64(gjk_mac32(core, normal, 2 * radius) + (INT64_C(1) << 30), 31);
}

gjk_vec3 gjk_gap_point(const gjk_gap *gap) {
  const gjk_simplex *s = &gap->it.simplex;
  const gjk_vec3 *u = &s->slot[s->order[0]].a.offset;
  const gjk_vec3 *v = s->count > 1 ? &s->slot[s->order[1]].a.offset : u;
  const gjk_vec3 *w = s->count > 2 ? &s->slot[s->order[2]].a.offset : u;
  const gjk_q16 radius = gap->it.a->shape->convex_radius;
  gjk_barycentric weight[2];
  if (!GJK_SMALL && s->count < 2) {
    const gjk_vec3 vertex = {vertex_point(u->x, gap->normal.x, radius), vertex_point(u->y, gap->normal.y, radius),
                             vertex_point(u->z, gap->normal.z, radius)};
    return vertex;
  }
  gjk_zero(weight, sizeof weight);
  if (s->count > 1) {
    gjk_simplex_weights(s, gap->it.shift < POLYTOPE_SHIFT, weight);
  }
  const gjk_vec3 point = {point_axis(weight, u->x, v->x, w->x, gap->normal.x, radius),
                          point_axis(weight, u->y, v->y, w->y, gap->normal.y, radius),
                          point_axis(weight, u->z, v->z, w->z, gap->normal.z, radius)};
  return point;
}
