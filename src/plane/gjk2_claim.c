// Checks the points and the normal of an answer of the plane in exact integer arithmetic.
#include "gjk2_claim.h"

int64_t gjk2_claim_farthest(const gjk2_collider *c, gjk2_vec d) {
  int64_t largest = INT64_MIN;
  gjk2_vec offset;
  for (uint32_t i = 0; i < c->count; i++) {
    if (!c->shape->type->vertex(c, (uint16_t)i, &offset)) {
      break;  // not reached: there are count
    }
    const int64_t along = gjk2_dot(offset, d);
    largest = along > largest ? along : largest;
  }
  return largest;
}

// sum += x^2
static void plane_add_square(gjk_u192 *sum, int64_t x) {
  gjk_u192 size, square;
  gjk_u192_set(&size, gjk_magnitude64(x));
  gjk_u192_multiply(&square, &size, &size);
  gjk_u192_add(sum, &square);
}

// sum += x^2 y
static void add_square_times(gjk_u192 *sum, int64_t x, uint64_t y) {
  gjk_u192 square, factor, product;
  gjk_u192_set(&square, 0);
  plane_add_square(&square, x);
  gjk_u192_set(&factor, y);
  gjk_u192_multiply(&product, &square, &factor);
  gjk_u192_add(sum, &product);
}

static bool plane_same_sign(int32_t direction, gjk_q30 u) {
  return direction == 0 ? u == 0 : (direction > 0 ? u >= 0 : u <= 0);
}

// The error of the normal u has two parts, in LSB of Q2.30:
//   across n   |u x n| / |n|
//   along n    |u| - 2^30 = (|u|^2 - 2^60) / 2^31     to 2^-26
// Together at most 4 LSB are allowed, which is 2^-28. Their square is compared with 255/16 instead of 16, which leaves
// room for the 2^-26.
bool gjk2_claim_normal(gjk2_vec n, const gjk2_unit *normal) {
  const gjk2_vec u = {normal->x, normal->y};
  const gjk_q30 most = GJK_Q30_ONE + 4;
  if (u.x < -most || u.x > most || u.y < -most || u.y > most || !plane_same_sign(n.x, u.x) ||
      !plane_same_sign(n.y, u.y)) {
    return false;
  }
  // |u| <= sqrt(2) (2^30 + 4), |n| <= sqrt(2) 3 2^29:   along below 2^62, across below 2^62
  const int64_t along = gjk2_dot(u, u) - (INT64_C(1) << 60), limit = INT64_C(1) << 34, across = gjk2_cross(u, n);
  if (along < -limit || along > limit || gjk_magnitude64(across) >= UINT64_C(1) << 35) {  // 4 |n| < 2^34
    return false;
  }
  // Is 2^62 across^2 + along^2 n^2 <= 255/16 2^62 n^2?
  //   n^2           at most 9 2^59 < 2^63
  //   left side     below 2^62 2^70 + 2^68 2^63
  //   right side    below 2^66 2^63
  const uint64_t squared = (uint64_t)gjk_mul32(n.x, n.x) + (uint64_t)gjk_mul32(n.y, n.y);
  gjk_u192 left, right, factor, product;
  gjk_u192_set(&left, 0);
  add_square_times(&left, across, UINT64_C(1) << 62);
  add_square_times(&left, along, squared);
  gjk_u192_set(&factor, squared);
  gjk_u192_set(&right, UINT64_C(255) << 29);
  gjk_u192_multiply(&product, &factor, &right);
  gjk_u192_set(&factor, UINT64_C(1) << 29);
  gjk_u192_multiply(&right, &product, &factor);
  return gjk_u192_compare(&left, &right) <= 0;
}

// A point within 1 LSB of a shape has all of the shape's vertices within this, per component: a shape is below 2^29
// across.
#define PLANE_POINT_REACH (INT64_C(3) << 28)

// *out = centre + offset - point. False when that is beyond PLANE_POINT_REACH.
static bool plane_from_point(gjk_q16 centre, gjk_q16 offset, gjk_q16 point, int32_t *out) {
  const int64_t difference = (int64_t)centre + offset - point;
  if (difference < -PLANE_POINT_REACH || difference > PLANE_POINT_REACH) {
    return false;
  }
  *out = (int32_t)difference;
  return true;
}

bool gjk2_claim_point(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point) {
  gjk2_vec from[2];
  from[0].x = from[0].y = from[1].x = from[1].y = 0;
  const int32_t reach = c->shape->convex_radius + 1;
  for (unsigned i = 0; i < count; i++) {
    gjk2_vec offset;
    // not reached: no such vertex, since the certificate holds
    if (!c->shape->type->vertex(c, named[i], &offset) ||
        !plane_from_point(c->centre.x, offset.x, point->x, &from[i].x) ||
        !plane_from_point(c->centre.y, offset.y, point->y, &from[i].y)) {
      return false;
    }
    // |from| <= sqrt(2) 3 2^28:  the square below 2^60
    if (gjk2_dot(from[i], from[i]) <= gjk_mul32(reach, reach)) {
      return true;
    }
  }
  // By component: GCC copies whole vectors by memcpy on ARMv6-M.
  const gjk2_vec p = {from[0].x, from[0].y}, q = {from[1].x, from[1].y}, edge = gjk2_sub(q, p);
  return count == 2 && gjk2_dot(p, edge) < 0 && gjk2_dot(q, edge) > 0 &&
         gjk2_is_within(gjk_int64(gjk_magnitude64(gjk2_cross(p, q))), edge, reach);
}

// Is the coordinate at an end of its range, which the vertex reaches with the convex radius and 1 LSB?
static bool plane_at_end(gjk_q16 coordinate, gjk_q16 centre, gjk_q16 offset, gjk_q16 convex_radius) {
  const int64_t vertex = (int64_t)centre + offset, reach = (int64_t)convex_radius + 1;
  return (coordinate == INT32_MAX && vertex + reach >= INT32_MAX) ||
         (coordinate == INT32_MIN && vertex - reach <= INT32_MIN);
}

bool gjk2_claim_saturated(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point) {
  const gjk_q16 convex_radius = c->shape->convex_radius;
  for (unsigned i = 0; i < count; i++) {
    gjk2_vec offset;
    // not reached: no such vertex, since the certificate holds
    if (c->shape->type->vertex(c, named[i], &offset) &&
        (plane_at_end(point->x, c->centre.x, offset.x, convex_radius) ||
         plane_at_end(point->y, c->centre.y, offset.y, convex_radius))) {
      return true;
    }
  }
  return false;
}

// The sign of 8 height / |n| - eighths. Pre: 0 <= height < 2^62, squared = |n|^2 < 2^62, 0 < eighths < 2^36.
static int compare_eighths(uint64_t squared, int64_t height, int64_t eighths) {
  gjk_u192 left, right;
  gjk_u192_set(&left, 0);
  gjk_u192_set(&right, 0);
  add_square_times(&left, height, 64);
  add_square_times(&right, eighths, squared);
  return gjk_u192_compare(&left, &right);
}

bool gjk2_claim_gap(const gjk2_search *s, gjk_q16 distance, const gjk2_vec *a, const gjk2_vec *b) {
  const int64_t x = (int64_t)b->x - a->x, y = (int64_t)b->y - a->y;
  const int64_t radii = gjk2_convex_radii(s), exact = distance + radii;
  const gjk2_vec d = {s->d.x, s->d.y};
  const uint64_t length = (uint64_t)gjk2_dot(d, d);
  // Find the integer `eighths` with eighths <= 8 |base| / |d| < eighths + 1: from half an LSB below exact on.
  int64_t eighths = exact > 0 ? 8 * exact - 4 : 0;
  for (int step = 4; step > 0; step /= 2) {
    eighths += compare_eighths(length, -s->base, eighths + step) >= 0 ? step : 0;
  }
  eighths -= 8 * radii;
  gjk_u192 squared, most, least;
  gjk_u192_set(&squared, 0);
  add_square_times(&squared, x, 64);
  add_square_times(&squared, y, 64);
  gjk_u192_set(&most, 0);
  plane_add_square(&most, eighths + 16);
  gjk_u192_set(&least, 0);
  plane_add_square(&least, eighths > 15 ? eighths - 15 : 0);
  return gjk_u192_compare(&squared, &most) <= 0 && gjk_u192_compare(&squared, &least) >= 0;
}

bool gjk2_claim_overlap(gjk_q16 depth, const gjk2_unit *normal, const gjk2_vec *a, const gjk2_vec *b) {
  const int64_t most = INT64_C(1) << 31, slack = gjk_shl64(3, 29) + gjk_shl64(depth, 1);  // Q29, below 2^33
  const int64_t apart[2] = {(int64_t)a->x - b->x, (int64_t)a->y - b->y};
  const int32_t unit[2] = {normal->x, normal->y};
  gjk_u192 squared, limit;
  gjk_u192_set(&squared, 0);
  gjk_u192_set(&limit, 0);
  for (int i = 0; i < 2; i++) {
    if (apart[i] < -most || apart[i] > most) {  // not reached: both points are on shapes that overlap
      return false;
    }
    // |apart| 2^30 <= 2^61, |depth unit| <= 2^61: their difference is halved, rounded to the nearest, to fit.
    plane_add_square(&squared, gjk_sar64(gjk_shl64(apart[i], 30) - gjk_mul32(depth, unit[i]) + 1, 1));
  }
  plane_add_square(&limit, slack);
  return gjk_u192_compare(&squared, &limit) <= 0;
}
