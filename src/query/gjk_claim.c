// Checks the points and the normal of an answer in exact integer arithmetic.
#include "gjk_claim.h"

// floor(x / 2^n) for x in two's complement. Pre: n <= 63, and the result fits.
GJK_ONE_COPY static int64_t shift_down(const gjk_u128 *x, unsigned n) {
  return gjk_int64(n == 0 ? x->low : x->high << (64 - n) | x->low >> n);
}

void gjk_claim_direction(const gjk_simplex *s, gjk_long3 *out) {
  gjk_direction d;
  gjk_u128 sum[3];
  d.ta = d.tb = 0;  // used where an edge sets them, which GCC does not see
  gjk_simplex_exact_direction(s, &d);
  if (d.spanning == 3) {
    out->x = d.n->x;
    out->y = d.n->y;
    out->z = d.n->z;
    return;
  }
  if (d.spanning == 1) {
    out->x = -d.a->x;
    out->y = -d.a->y;
    out->z = -d.a->z;
    return;
  }
  // |a.x tb| <= 3 2^29 2^61, and so is |b.x ta|: sums below 2^93.
  gjk_sum_of_products(-d.a->x, d.tb, -d.b->x, d.ta, &sum[0]);
  gjk_sum_of_products(-d.a->y, d.tb, -d.b->y, d.ta, &sum[1]);
  gjk_sum_of_products(-d.a->z, d.tb, -d.b->z, d.ta, &sum[2]);
  uint64_t high = 0, low = 0;
  for (int i = 0; i < 3; i++) {
    const uint64_t flip = sum[i].high > INT64_MAX ? UINT64_MAX : 0;
    high |= sum[i].high ^ flip;
    low |= sum[i].low ^ flip;
  }
  const unsigned bits = high != 0 ? 128 - gjk_clz64(high) : 64 - gjk_clz64(low | 1), n = bits > 61 ? bits - 61 : 0;
  //@ assert n <= 32;
  out->x = shift_down(&sum[0], n);
  out->y = shift_down(&sum[1], n);
  out->z = shift_down(&sum[2], n);
}

// sum += x^2
static void add_square(gjk_u192 *sum, int64_t x) {
  gjk_u192 size, square;
  gjk_u192_set(&size, gjk_magnitude64(x));
  gjk_u192_multiply(&square, &size, &size);
  gjk_u192_add(sum, &square);
}

// *out = p q + r s. False when that is 2^63 or more in size.
GJK_ONE_COPY static bool small_sum(int64_t p, int64_t q, int64_t r, int64_t s, int64_t *out) {
  gjk_u128 sum;
  gjk_sum_of_products(p, q, r, s, &sum);
  *out = gjk_int64(sum.low);
  return sum.high == (*out < 0 ? UINT64_MAX : 0);
}

static bool same_sign(int64_t direction, gjk_q30 u) {
  return direction == 0 ? u == 0 : (direction > 0 ? u >= 0 : u <= 0);
}

// v is the direction, at most 2^56 per component, and u the normal, Q2.30. The error of u has two parts, in LSB of
// Q2.30:
//   across v   |u x v| / |v|
//   along v    |u| - 2^30 = (|u|^2 - 2^60) / 2^31     to 2^-26
// Together at most 4 LSB are allowed, which is 2^-28. Their square is compared with 255/16 instead of 16, which leaves
// room for the low bits that v loses and for the 2^-26.
bool gjk_claim_normal(const gjk_long3 *direction, const gjk_unit3 *u) {
  const gjk_vec3 n = {u->x, u->y, u->z};
  const gjk_long3 *d = direction;
  const bool large = (gjk_magnitude64(d->x) | gjk_magnitude64(d->y) | gjk_magnitude64(d->z)) >> 56 != 0;
  const gjk_long3 v = {gjk_sar64(d->x, large ? 6 : 0), gjk_sar64(d->y, large ? 6 : 0), gjk_sar64(d->z, large ? 6 : 0)};
  const gjk_q30 most = GJK_Q30_ONE + 4;
  int64_t x, y, z;
  if (n.x < -most || n.x > most || n.y < -most || n.y > most || n.z < -most || n.z > most) {
    return false;
  }
  // Bounds:
  //   |u|^2      at most 3 (2^30 + 4)^2:     along below 2^62
  //   n.y v.z    at most 2^56 (2^30 + 4):    sums of two below 2^88
  const int64_t along = gjk_dot(&n, &n) - (INT64_C(1) << 60), limit = INT64_C(1) << 34;
  if (along < -limit || along > limit || !same_sign(v.x, n.x) || !same_sign(v.y, n.y) || !same_sign(v.z, n.z) ||
      !small_sum(n.y, v.z, -n.z, v.y, &x) || !small_sum(n.z, v.x, -n.x, v.z, &y) ||
      !small_sum(n.x, v.y, -n.y, v.x, &z)) {
    return false;
  }
  // Is 2^62 |u x v|^2 + along^2 v^2 <= 255/16 2^62 v^2?
  //   v^2          below 3 2^112
  //   |u x v|^2    components below 2^63:            below 3 2^126, times 2^62 below 2^190
  //   along^2 v^2  |along| <= 2^34:                  at most 2^68 3 2^112
  //   right side   255/16 2^62 < 2^66:               below 2^66 3 2^112
  gjk_u192 squared, across, scale, left, right;
  gjk_u192_set(&squared, 0);
  add_square(&squared, v.x);
  add_square(&squared, v.y);
  add_square(&squared, v.z);
  gjk_u192_set(&across, 0);
  add_square(&across, x);
  add_square(&across, y);
  add_square(&across, z);
  gjk_u192_set(&scale, UINT64_C(1) << 62);
  gjk_u192_multiply(&left, &across, &scale);
  gjk_u192_set(&scale, gjk_magnitude64(along));
  gjk_u192_multiply(&right, &squared, &scale);
  gjk_u192_multiply(&across, &right, &scale);
  gjk_u192_add(&left, &across);
  gjk_u192_set(&scale, UINT64_C(255) << 29);
  gjk_u192_multiply(&right, &squared, &scale);
  gjk_u192_set(&scale, UINT64_C(1) << 29);
  gjk_u192_multiply(&across, &right, &scale);
  // v = 0 does not get here: u would be 0 by its signs, and along out of limits.
  return gjk_u192_compare(&left, &across) <= 0;
}

// A point within 1 LSB of a shape has all of the shape's vertices within this, per component: a shape is below 2^29
// across.
#define POINT_REACH (INT64_C(3) << 28)

// *out = centre + offset - point. False when that is beyond POINT_REACH.
static bool from_point(gjk_q16 centre, gjk_q16 offset, gjk_q16 point, int32_t *out) {
  const int64_t difference = (int64_t)centre + offset - point;
  if (difference < -POINT_REACH || difference > POINT_REACH) {
    return false;
  }
  *out = (int32_t)difference;
  return true;
}

bool gjk_claim_point(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point) {
  gjk_simplex s;
  gjk_u192 numerator, denominator;
  gjk_vec3 from[3];
  for (unsigned i = 0; i < count; i++) {
    gjk_vec3 offset;
    if (!c->shape->type->vertex(c, named[i], &offset) || !from_point(c->centre.x, offset.x, point->x, &from[i].x) ||
        !from_point(c->centre.y, offset.y, point->y, &from[i].y) ||
        !from_point(c->centre.z, offset.z, point->z, &from[i].z)) {
      return false;
    }
  }
  // The hull's point nearest to the origin lies strictly inside one of the features that the vertices span.
  const uint64_t twice = 2 * ((uint64_t)(uint32_t)c->shape->convex_radius + 1);
  for (unsigned subset = 1; subset < 1u << count; subset++) {
    unsigned n = 0;
    for (unsigned i = 0; i < count; i++) {
      if ((subset >> i & 1u) != 0) {
        s.slot[n++].w = from[i];
      }
    }
    if (gjk_simplex_set(&s, n)) {
      gjk_simplex_squared_distance(&s, &numerator, &denominator);
      if (gjk_compare_distance(&numerator, &denominator, twice) <= 0) {
        return true;
      }
    }
  }
  return false;
}

// Is the coordinate at an end of its range, which the vertex reaches with the convex radius and 1 LSB?
static bool at_end(gjk_q16 coordinate, gjk_q16 centre, gjk_q16 offset, gjk_q16 convex_radius) {
  const int64_t vertex = (int64_t)centre + offset, reach = (int64_t)convex_radius + 1;
  return (coordinate == INT32_MAX && vertex + reach >= INT32_MAX) ||
         (coordinate == INT32_MIN && vertex - reach <= INT32_MIN);
}

bool gjk_claim_saturated(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point) {
  const gjk_q16 convex_radius = c->shape->convex_radius;
  for (unsigned i = 0; i < count; i++) {
    gjk_vec3 offset;
    if (c->shape->type->vertex(c, named[i], &offset) && (at_end(point->x, c->centre.x, offset.x, convex_radius) ||
                                                         at_end(point->y, c->centre.y, offset.y, convex_radius) ||
                                                         at_end(point->z, c->centre.z, offset.z, convex_radius))) {
      return true;
    }
  }
  return false;
}

// The sign of 4 sqrt(numerator / denominator) - quarters. Pre: numerator <= 2^186, so 4 times it fits.
static int compare_quarters(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t quarters) {
  gjk_u192 x;
  gjk_u192_set(&x, 0);
  gjk_u192_add(&x, numerator);  // an addition to 0: GCC makes a copy a call of memcpy on ARMv6-M
  gjk_u192_add(&x, &x);
  gjk_u192_add(&x, &x);
  return gjk_compare_distance(&x, denominator, quarters);
}

bool gjk_claim_gap(const gjk_iteration *it, gjk_q16 distance, int64_t radius, const gjk_vec3 *a, const gjk_vec3 *b) {
  const int64_t most = (int64_t)distance + 3;  // at most 2^31 + 2
  const int64_t x = (int64_t)b->x - a->x, y = (int64_t)b->y - a->y, z = (int64_t)b->z - a->z;
  if (x < -most || x > most || y < -most || y > most || z < -most || z > most) {
    return false;
  }
  // Find the integer `exact` with exact <= 4 (feature's distance - radius) < exact + 1. That is among four, since the
  // distance is rounded to the nearest LSB.
  gjk_u192 numerator, denominator;
  int64_t exact = 4 * (int64_t)distance - 2;
  const int64_t least = 4 * radius;  // exact + least is below 2^34, and below 2^33 in the frame's units
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  for (int i = 0; i < 3; i++) {
    const int64_t next = exact + 1 + least;
    exact += next < 0 || compare_quarters(&numerator, &denominator, (uint64_t)next << it->shift) >= 0;
  }
  gjk_u192 squared;
  gjk_u192_set(&denominator, 1);
  gjk_u192_set(&squared, 0);
  add_square(&squared, x);
  add_square(&squared, y);
  add_square(&squared, z);
  return compare_quarters(&squared, &denominator, (uint64_t)(exact + 8)) <= 0 &&
         (exact < 7 || compare_quarters(&squared, &denominator, (uint64_t)(exact - 7)) >= 0);
}

bool gjk_claim_overlap(gjk_q16 depth, const gjk_unit3 *normal, const gjk_vec3 *a, const gjk_vec3 *b) {
  const int64_t most = INT64_C(1) << 31, slack = gjk_shl64(3, 29) + gjk_shl64(depth, 1);  // Q29, below 2^33
  const gjk_vec3 n = {normal->x, normal->y, normal->z};
  const int64_t apart[3] = {(int64_t)a->x - b->x, (int64_t)a->y - b->y, (int64_t)a->z - b->z};
  const int32_t unit[3] = {n.x, n.y, n.z};
  gjk_u192 squared, limit;
  gjk_u192_set(&squared, 0);
  gjk_u192_set(&limit, 0);
  for (int i = 0; i < 3; i++) {
    if (apart[i] < -most || apart[i] > most) {  // not reached: both points are on shapes that overlap
      return false;
    }
    // |apart| 2^30 <= 2^61, |depth unit| <= 2^61: their difference is halved, rounded to the nearest, to fit.
    add_square(&squared, gjk_sar64(gjk_shl64(apart[i], 30) - gjk_mul32(depth, unit[i]) + 1, 1));
  }
  add_square(&limit, slack);
  return gjk_u192_compare(&squared, &limit) <= 0;
}
