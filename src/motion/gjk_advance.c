// Brackets the fraction of a cast if shapes are rounded or curved, or the cast has a margin.
//
// The gap along the way is convex, so the plane that touches A - B at one fraction bounds it from below at all of them.
// The first fraction is where the bounding spheres meet.
//
//   Step 1   Measure the gap and its plane at the fraction (gjk_gap.h).
//   Step 2   There is provably no contact up to where the plane's gap is used up, rounded down.
//   Step 3   Stop when the gap there is small. Otherwise go on from 1, at the fraction where the way reaches the
//            feature itself, with the radius. That is beyond the plane's place, since the feature curves away. Once
//            that goes too far, the proven fraction is always next.
//   Step 4   Support points of a curved pair err by an LSB for each curved shape, so steps 1 to 3 enlarge the radius by
//            that. If it is then not sure that the shapes meet, steps 1 to 3 go on with the radius itself, to decide.
//
// Rounds from the proven fraction alone are Newton's iteration from below. Each of them makes gap times slope at most a
// quarter, up to rounding: (gap' / gap) + (slope' / slope) <= 1, since the gap is convex. A gap g that is used up within
// the way w has slope g / w at least. From gap and way below 2^34 down to 2^-3 that takes at most 38 rounds, and one probe
// fails at most.
//
// After   Gino van den Bergen, Ray Casting against General Convex Objects, 2004. Departures: each round measures the
//         nearest feature, so that rounds are few and bounded; planes are bounds that rounding does not break.
#include "gjk_advance.h"
#include "../arith/gjk_memory.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"
#include "gjk_gap.h"

// A step of at most this many LSB along the way ends the rounds: the plane is right to far less there.
#define LAST_STEP 2

// Along a triangle's own plane a step may close a gap of so much, Q16 LSB: 2^24 LSB. Its errors, the slope's and the
// quotient's, are together below 2^-26 of that, 1/4 LSB.
#define LAST_FALL (INT64_C(1) << 40)

// Likewise a step back, where a probe has gone too far.
#define LAST_STEP_BACK 1

// What gjk_collider_init adds to the radius of a core.
#define CORE_SLACK 4

// A gap of at most this ends them as well, Q16 LSB.
#define LAST_GAP (INT64_C(1) << 13)

// What a round leaves to do.
typedef enum advance_end {
  ADVANCE_ON,        // another round
  ADVANCE_NEAR,      // nothing: the gap at the proven fraction is small
  ADVANCE_TOUCH,     // nothing: there it is not above 0, for all that is proven
  ADVANCE_ENCLOSED,  // nothing: there the cores share a point
  ADVANCE_APART,     // nothing: the plane is not reached on the way, which is proven
  ADVANCE_LIMIT      // nothing, since a ceiling is reached
} advance_end;

// Where shapes touch.
typedef struct advance_contact {
  gjk_q30 fraction;
  gjk_unit3 normal;
  gjk_vec3 point;  // on A, from its centre
} advance_contact;

// The rounds of a cast.
typedef struct advance_rounds {
  gjk_gap gap;
  gjk_vec3 heading;         // the way's direction, a unit vector in Q30
  gjk_q30 proven;           // before this fraction is no contact
  gjk_q30 at;               // the fraction to measure at
  bool plain;               // a probe has failed: measure at the proven fraction alone
  advance_contact contact;  // of a curved pair: of the last round whose cores shared no point
} advance_rounds;

static void keep_contact(const gjk_gap *gap, gjk_q30 fraction, advance_contact *out) {
  out->fraction = fraction;
  out->normal = gap->normal;
  out->point = gjk_gap_point(gap);
}

// 2^30 above / slope, Q30, for a slope in units of 2^scale LSB: rounded down, or up where up is set.
// Saturates at 2^31, which is more than any way has. Pre: above, slope > 0.
static int64_t fraction_of(int64_t above, int64_t slope, unsigned scale, bool up) {
  unsigned k;
  // Q16 LSB / (Q30 2^scale LSB) in Q30: 2^(44 - scale)
  const int64_t quotient = gjk_divide64((uint64_t)above, (uint64_t)slope, 44 - scale, &k);
  if (quotient == INT32_MAX && k == 0) {
    return INT64_C(1) << 31;
  }
  // Within 2^-28 of itself and 2^-32: of quotient, by up to 8 and 1.
  const int64_t error = (quotient >> 28) + 2;
  if (up) {
    return gjk_sar64(quotient + error, k) + 1;
  }
  return quotient <= error ? 0 : gjk_sar64(quotient - error, k);
}

// Is a step of the fraction at most so many LSB long?
//   norm1 of the way < 3 2^32 < 2^34, step <= 2^31:  below 2^63 once the length is at most 2^32
GJK_ONE_COPY static bool is_short_step(const gjk_way *way, int64_t step, unsigned lsb) {
  const uint64_t length = gjk_magnitude64(way->t.x) + gjk_magnitude64(way->t.y) + gjk_magnitude64(way->t.z);
  return step <= GJK_Q30_ONE && length * (uint64_t)step <= (uint64_t)lsb << 30;
}

// 2^scale x / y, to about 2^-28 of it, rounded down, at most 2^31 - 1. Pre: x >= 0, y > 0.
GJK_ONE_COPY static int64_t quotient(int64_t x, int64_t y, unsigned scale) {
  unsigned k;
  const int32_t number = gjk_divide64((uint64_t)x, (uint64_t)y, scale, &k);
  return gjk_sar64(number, k);
}

// x y / 2^30. Pre: |x|, |y| <= 2^31.
GJK_ONE_COPY static int64_t scaled(int64_t x, int64_t y) {
  return gjk_sar64(x * y, 30);
}

// The square of the sine of the angle between the way and an edge of the cores, Q30.
static int64_t squared_sine(const advance_rounds *r, const gjk_vec3 *v, const gjk_vec3 *w) {
  const gjk_vec3 edge = gjk_sub(*v, *w);
  const gjk_vec3 d = {gjk_sar32(edge.x, 1), gjk_sar32(edge.y, 1), gjk_sar32(edge.z, 1)};
  if ((d.x | d.y | d.z) == 0) {
    return GJK_Q30_ONE;
  }
  const gjk_unit3 u = gjk_unit(&d);
  const int64_t cosine = gjk_sar64(gjk_along(&u, &r->heading), 30);
  return GJK_Q30_ONE - scaled(cosine, cosine);
}

// Step 3: where the way reaches the feature itself, rounded by the radius, in place of the plane. step is the plane's.
// With D = R + g for the feature's distance, c = cos of the angle of way and normal, and q the square of the part of the way
// that is across the edge, 1 of a vertex, the feature is reached after
//   l = g (D + R) / (D c + sqrt(D^2 c^2 - q g (D + R)))
//     = (g / c) (2 - p) c / (c + sqrt(c^2 - q p (2 - p)))     p = g / D
// where g / c is the plane's step. It is an estimate, so its errors do not matter.
static int64_t probe_ahead(const advance_rounds *r, int64_t step) {
  const gjk_gap *gap = &r->gap;
  const gjk_simplex *s = &gap->it.simplex;
  if (s->count == 3 || step <= 0) {
    return step;
  }
  const int64_t c = -gjk_sar64(gjk_along(&gap->normal, &r->heading), 30);
  const int64_t share = quotient(gap->above, gap->above + gjk_shl64(gap->radius, 16), 30);
  int64_t part = scaled(share, 2 * (int64_t)GJK_Q30_ONE - share);
  if (s->count == 2) {
    part = scaled(part, squared_sine(r, &s->slot[s->order[0]].w, &s->slot[s->order[1]].w));
  }
  const int64_t rest = c * c - gjk_shl64(part, 30);
  if (c <= 0 || rest <= 0) {
    return step;
  }
  const int64_t root = (int64_t)gjk_isqrt64((uint64_t)rest);
  return scaled(step, quotient((2 * (int64_t)GJK_Q30_ONE - share) * c, c + root, 0));
}

GJK_ONE_COPY static void raise_proven(advance_rounds *r, int64_t fraction) {
  if (fraction > r->proven) {
    r->proven = (gjk_q30)fraction;
  }
}

// After a probe that has gone too far.
static advance_end retreat(advance_rounds *r) {
  r->plain = true;
  r->at = r->proven;
  return ADVANCE_ON;
}

// Step 2 where the plane is reached before the fraction, at a probe.
static advance_end step_back(advance_rounds *r, const gjk_slope *slope, bool limited) {
  const gjk_gap *gap = &r->gap;
  const int64_t step = gap->above < 0 ? fraction_of(-gap->above, slope->low, gap->scale, true) : 0;
  raise_proven(r, r->at - step);
  if (limited) {
    return ADVANCE_LIMIT;
  }
  return is_short_step(gap->way, step, LAST_STEP_BACK) ? ADVANCE_NEAR : retreat(r);
}

// Steps 2 and 3 where the plane lies ahead.
static advance_end step_ahead(advance_rounds *r, const gjk_slope *slope, bool limited) {
  gjk_gap *gap = &r->gap;
  const gjk_q30 left = GJK_Q30_ONE - r->at;
  const int64_t step = slope->high > 0 ? fraction_of(gap->above, slope->high, gap->scale, false) : INT64_MAX;
  if (step > left) {
    return ADVANCE_APART;
  }
  const bool last = step <= 1 || is_short_step(gap->way, step, LAST_STEP);
  if (!limited && !last && gap->above <= LAST_GAP) {
    r->proven = r->at;
    return ADVANCE_NEAR;
  }
  raise_proven(r, r->at + step);
  if (limited || last) {
    return limited ? ADVANCE_LIMIT : ADVANCE_NEAR;
  }
  const int64_t ahead = r->plain ? step : probe_ahead(r, step);
  r->at = ahead > step ? (gjk_q30)(r->at + (ahead < left ? ahead : left)) : r->proven;
  if (r->at == r->proven && gap->above <= LAST_FALL && gjk_gap_follow(gap, r->at)) {
    gap->above = 0;
    return ADVANCE_NEAR;
  }
  return ADVANCE_ON;
}

// Steps 2 and 3, after a measurement. Out of line, as what is done before and after the rounds: the stack of measurements
// is the deepest.
GJK_OUT_OF_LINE static advance_end end_round(advance_rounds *r, gjk_outcome outcome) {
  const bool limited = outcome == GJK_OUTCOME_LIMIT;
  if (outcome == GJK_OUTCOME_ENCLOSING) {
    return r->at == r->proven ? ADVANCE_ENCLOSED : retreat(r);
  }
  if (gjk_pair_is_curved(&r->gap.it)) {
    keep_contact(&r->gap, r->at, &r->contact);
  }
  const bool met = r->gap.above <= 0;
  if (met && r->at == r->proven) {
    return limited ? ADVANCE_LIMIT : ADVANCE_TOUCH;
  }
  const gjk_slope slope = gjk_gap_slope(&r->gap);
  // The plane bounds the gap before the fraction only where it comes nearer along the way.
  if (r->at > r->proven && slope.low <= 0) {
    return limited ? ADVANCE_LIMIT : retreat(r);
  }
  return met ? step_back(r, &slope, limited) : step_ahead(r, &slope, limited);
}

static advance_end run_rounds(advance_rounds *r) {
  advance_end end = ADVANCE_ON;
  for (unsigned round = 0; end == ADVANCE_ON && round < GJK_ADVANCE_ROUNDS_MAX; round++) {
    end = end_round(r, gjk_gap_measure(&r->gap, r->at));  // Step 1
  }
  return end == ADVANCE_ON ? ADVANCE_LIMIT : end;
}

// One axis of how far a centre has come, Q30 LSB. |end - start| < 2^32:  at most 2^62
GJK_ONE_COPY static int64_t way_done(gjk_q16 start, gjk_q16 end, gjk_q30 fraction) {
  return ((int64_t)end - start) * fraction;
}

// x / 2^30 rounded up where side is above 0, down where it is below, else to the nearest. Pre: |x| <= 2^62.
GJK_ONE_COPY static int64_t round_away(int64_t x, gjk_q30 side) {
  const int64_t up = side > 0 ? GJK_Q30_ONE - 1 : side < 0 ? 0 : GJK_Q30_ONE / 2;
  return gjk_sar64(x + up, 30);
}

// One axis of where A is touched, and B: margin farther along the normal.
//   |way_a| <= 2^62, |margin normal| <= 2^61
static void report_touch(int64_t from_centre, int64_t way_a, gjk_q30 normal, gjk_q16 margin, gjk_q16 *point_a,
                         gjk_q16 *point_b, bool *saturated) {
  *point_a = gjk_saturate_noting(from_centre + round_away(way_a, 0), saturated);
  *point_b = gjk_saturate_noting(from_centre + round_away(way_a + gjk_mul32(margin, normal), 0), saturated);
}

// A position at rest, along one axis: between those at the start and the end, which are int32.
static gjk_q16 rest_at(gjk_q16 position, int64_t way, gjk_q30 side) {
  return (gjk_q16)(position + round_away(way, side));
}

// Writes all of a hit but hit, inside, certificate and iterations.
// At rest the shapes have moved from the fraction along the normal, by B's rounding and A's: so the plane's gap is no
// smaller than at the fraction, where it is at least 0.
static void report_contact(const gjk_gap *gap, const advance_contact *contact, gjk_q16 margin, gjk_cast_result *out) {
  const gjk_collider *a = gap->it.a, *b = gap->it.b;
  const gjk_vec3 *end_a = &gap->way->end_a, *end_b = &gap->way->end_b;
  const gjk_q30 f = contact->fraction;
  const gjk_long3 way_a = {way_done(a->centre.x, end_a->x, f), way_done(a->centre.y, end_a->y, f),
                           way_done(a->centre.z, end_a->z, f)};
  const gjk_unit3 n = contact->normal;
  out->inside = false;
  out->fraction = f;
  out->normal = n;
  out->saturated = false;
  report_touch((int64_t)a->centre.x + contact->point.x, way_a.x, n.x, margin, &out->point_a.x, &out->point_b.x,
               &out->saturated);
  report_touch((int64_t)a->centre.y + contact->point.y, way_a.y, n.y, margin, &out->point_a.y, &out->point_b.y,
               &out->saturated);
  report_touch((int64_t)a->centre.z + contact->point.z, way_a.z, n.z, margin, &out->point_a.z, &out->point_b.z,
               &out->saturated);
  out->rest_a.x = rest_at(a->position.x, way_a.x, -n.x);
  out->rest_a.y = rest_at(a->position.y, way_a.y, -n.y);
  out->rest_a.z = rest_at(a->position.z, way_a.z, -n.z);
  out->rest_b.x = rest_at(b->position.x, way_done(b->centre.x, end_b->x, f), n.x);
  out->rest_b.y = rest_at(b->position.y, way_done(b->centre.y, end_b->y, f), n.y);
  out->rest_b.z = rest_at(b->position.z, way_done(b->centre.z, end_b->z, f), n.z);
}

// iterations, with those before, at most UINT8_MAX
static uint8_t count_iterations(unsigned before, unsigned used) {
  return before + used < UINT8_MAX ? (uint8_t)(before + used) : UINT8_MAX;
}

// Do the cores come within the radius at the start? Exact for near frames. Pre: fraction 0 is measured, in a near frame.
GJK_OUT_OF_LINE static bool starts_inside(const advance_rounds *r) {
  const gjk_iteration *it = &r->gap.it;
  gjk_u192 numerator, denominator;
  if (r->gap.radius >> (31 - it->shift) != 0) {
    return true;  // vertices are below 2^31
  }
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)r->gap.radius << (it->shift + 1)) <= 0;
}

// Does the ball of the radius about the feature's nearest point surely meet the way, as the plane's measurement sees it?
// With D = R + g and the cosine c of way and normal, the ball is met where D^2 (1 - c^2) <= R^2, so where 2 g <= D c^2,
// within 2 g / c. An LSB on top of g is more than all errors.
static bool surely_hits(const advance_rounds *r) {
  const gjk_gap *gap = &r->gap;
  const int64_t c = -gjk_sar64(gjk_along(&gap->normal, &r->heading), 30) - 16;
  const int64_t g = (gap->above > 0 ? gap->above : 0) + (INT32_C(1) << 16);
  const gjk_slope slope = gjk_gap_slope(gap);
  // D c^2, Q16 LSB: D < 2^33
  const int64_t reach = gjk_sar64((gap->above + gjk_shl64(gap->radius, 16)) * gjk_sar64(scaled(c, c), 16), 14);
  if (gap->it.shift < 0 || c <= 0 || slope.low <= 0 || 2 * g > reach) {
    return false;
  }
  // 2 g 2^44 < slope 2^scale left, rounded apart: g < 2^19 where 2 g <= reach has not failed
  const int64_t left = gjk_sar64(GJK_Q30_ONE - r->at, 6);
  return gjk_sar64(slope.low, 24) * left > gjk_shl64(2 * g, 14 - gap->scale);
}

static gjk_advance_answer bracket_rounded(advance_rounds *r, gjk_q16 margin, gjk_cast_result *out) {
  advance_contact contact;
  const advance_end end = run_rounds(r);
  out->iterations = count_iterations(0, r->gap.used);
  if (end == ADVANCE_APART) {
    return GJK_ADVANCE_MISS;
  }
  const bool start = end == ADVANCE_TOUCH && r->at == 0, far = r->gap.it.shift < 0;
  if (end == ADVANCE_ENCLOSED || (start && !far && starts_inside(r))) {
    return GJK_ADVANCE_INSIDE;
  }
  keep_contact(&r->gap, r->proven, &contact);
  report_contact(&r->gap, &contact, margin, out);
  if (start && far) {
    return GJK_ADVANCE_START;
  }
  return end == ADVANCE_LIMIT ? GJK_ADVANCE_LIMIT : surely_hits(r) ? GJK_ADVANCE_HIT : GJK_ADVANCE_OPEN;
}

// Step 4.
static gjk_advance_answer bracket_curved(advance_rounds *r, gjk_q16 margin, gjk_cast_result *out) {
  gjk_gap *gap = &r->gap;
  const int64_t error = (gjk_is_curved(gap->it.a->shape) ? 1 : 0) + (gjk_is_curved(gap->it.b->shape) ? 1 : 0);
  gap->radius += error;
  advance_end end = run_rounds(r);
  advance_contact contact;
  gjk_copy(&contact, &r->contact, sizeof contact);
  contact.fraction = r->proven;
  gap->radius -= error;
  if ((end == ADVANCE_NEAR && !surely_hits(r)) || end == ADVANCE_TOUCH || end == ADVANCE_ENCLOSED) {
    r->at = r->proven;
    end = run_rounds(r);
  }
  out->iterations = count_iterations(0, gap->used);
  if (end == ADVANCE_APART) {
    return GJK_ADVANCE_MISS;
  }
  if ((end == ADVANCE_TOUCH || end == ADVANCE_ENCLOSED) && r->at == 0) {
    return GJK_ADVANCE_INSIDE;
  }
  report_contact(gap, &contact, margin, out);
  return end == ADVANCE_LIMIT ? GJK_ADVANCE_LIMIT : GJK_ADVANCE_HIT;
}

// Sets the first fraction to measure at: where the bounding spheres meet, rounded by the radius. An estimate.
//   centres   2^k times as coarse as an LSB, components below 2^30
GJK_OUT_OF_LINE static void start_at_spheres(advance_rounds *r) {
  const gjk_gap *gap = &r->gap;
  const gjk_long3 *start = &gap->start, *t = &gap->way->t;
  const uint64_t bits = gjk_magnitude64(start->x) | gjk_magnitude64(start->y) | gjk_magnitude64(start->z);
  const unsigned k = bits >> 30 == 0 ? 0 : 34 - gjk_clz64(bits);  // bits <= 2^32
  const gjk_vec3 from = {(int32_t)gjk_sar64(start->x, k), (int32_t)gjk_sar64(start->y, k),
                         (int32_t)gjk_sar64(start->z, k)};
  // Less what core radii have as slack, so that balls are met exactly.
  const int64_t cores = gap->it.a->core_radius + gap->it.b->core_radius - 2 * CORE_SLACK;
  const int64_t reach = gjk_sar64(gap->radius + (cores > 0 ? cores : 0), k);
  const gjk_unit3 h = {r->heading.x, r->heading.y, r->heading.z};
  const int64_t along = gjk_sar64(gjk_along(&h, &from), 30);  // to where the way passes nearest
  if (along <= 0 || reach >> 31 != 0) {
    return;
  }
  const int64_t rest = reach * reach - gjk_dot(&from, &from) + along * along;
  const int64_t before = rest > 0 ? along - (int64_t)gjk_isqrt64((uint64_t)rest) : along;
  const gjk_vec3 way = {(int32_t)gjk_sar64(t->x, gap->scale), (int32_t)gjk_sar64(t->y, gap->scale),
                        (int32_t)gjk_sar64(t->z, gap->scale)};
  if (before > 0) {
    const int64_t step = fraction_of(gjk_shl64(before, 16 + k), gjk_along(&h, &way), gap->scale, false);
    r->at = step < GJK_Q30_ONE ? (gjk_q30)step : GJK_Q30_ONE;
  }
}

gjk_advance_answer gjk_advance(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, gjk_q16 margin,
                               gjk_cast_result *out) {
  advance_rounds r;
  gjk_search_direction heading;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + margin;
  gjk_gap_start(&r.gap, a, b, way, radius);
  r.proven = 0;
  r.at = 0;
  r.contact.normal.x = GJK_Q30_ONE;
  r.contact.normal.y = r.contact.normal.z = 0;
  r.contact.point.x = r.contact.point.y = r.contact.point.z = 0;
  gjk_search_direction_of(&way->t, &heading);
  r.plain = (heading.d.x | heading.d.y | heading.d.z) == 0;
  r.heading.x = r.heading.y = r.heading.z = 0;
  if (!r.plain) {
    const gjk_unit3 unit = gjk_unit(&heading.d);
    r.heading.x = unit.x;
    r.heading.y = unit.y;
    r.heading.z = unit.z;
    start_at_spheres(&r);
  }
  return gjk_pair_is_curved(&r.gap.it) ? bracket_curved(&r, margin, out) : bracket_rounded(&r, margin, out);
}
