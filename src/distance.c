// The distance query: how far apart, and where.
#include "gjk/distance.h"

#include "iteration.h"
#include "unit.h"

// u . a for a unit vector u, Q2.30, and |a| <= 3 2^29: at most 2^61.
static int64_t along(const gjk_unit3 *u, const gjk_vec3 *a) {
  return gjk_mul32(u->x, a->x) + gjk_mul32(u->y, a->y) + gjk_mul32(u->z, a->z);
}

// x / 2^(30 + shift) to the nearest integer, not negative; from the frame's Q30 to LSB. -3 <= shift <= 29.
static int64_t to_lsb(int64_t x, int shift) {
  const unsigned n = (unsigned)(30 + shift);
  return x <= 0 ? 0 : gjk_sar64(x + (INT64_C(1) << (n - 1)), n);
}

// The feature's distance in LSB, correctly rounded, a tie up. approximate: the same in the frame, Q30, off by less than
// 2^33: u is within 1.4 2^-29 of the exact direction and |w| <= 3 2^29.
static int64_t exact_distance(const gjk_iteration *it, int64_t approximate) {
  const int64_t error = INT64_C(1) << 33;
  int64_t low = to_lsb(approximate - error, it->shift), high = to_lsb(approximate + error, it->shift);
  if (low == high) {
    return low;
  }
  if (it->shift < 0) {
    return to_lsb(approximate, it->shift);
  }
  gjk_limbs numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  while (low < high) {  // at most 17 candidates, so 5 rounds
    const int64_t middle = gjk_sar64(low + high, 1);
    // Is twice the distance at least 2 middle + 1? In the frame, at most 2^33.
    if (gjk_compare_distance(&numerator, &denominator, (uint64_t)(2 * middle + 1) << it->shift) >= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// Do the cores come within the roundings of each other? approximate as above.
static bool rounded_touch(const gjk_iteration *it, int64_t approximate) {
  const int64_t error = INT64_C(1) << 33, radius = gjk_shl64(it->radius, 30);  // at most 2^61
  if (approximate - error > radius) {
    return false;
  }
  return it->radius > 0 && gjk_iteration_near(it);
}

static gjk_q16 saturate(int64_t x, bool *saturated) {
  if (x > INT32_MAX || x < INT32_MIN) {
    *saturated = true;
    return x < 0 ? INT32_MIN : INT32_MAX;
  }
  return (gjk_q16)x;
}

// v0 + weight[0] (v1 - v0) + weight[1] (v2 - v0), Q31. Pre: |v| <= 3 2^29, differences below 2^31: at most 3 2^61, the sum
// of the first two at most 7 2^60.
static int64_t weighted(const int32_t weight[2], int32_t v0, int32_t v1, int32_t v2) {
  return gjk_shl64(v0, 31) + gjk_mul32(weight[0], v1 - v0) + gjk_mul32(weight[1], v2 - v0);
}

// One coordinate of the nearest points. a: of the core of A, offset from its centre, Q31; w: of A - B in the frame, Q31;
// normal Q30. B's point is A's less w, so both start from A's centre.
static void report_coordinate(const gjk_iteration *it, gjk_q16 centre, int64_t a, int64_t w, gjk_q30 normal,
                              gjk_q16 *point_a, gjk_q16 *point_b, bool *saturated) {
  int64_t whole = 0, b = a;
  if (it->shift >= 0) {
    b -= gjk_sar64(w, (unsigned)it->shift);
  } else {
    whole = gjk_sar64(w, (unsigned)(31 + it->shift));  // to the LSB is fine enough there
  }
  const int64_t half = INT64_C(1) << 30;
  a += gjk_mul32(normal, it->a->shape->round) * 2 + half;
  b -= gjk_mul32(normal, it->b->shape->round) * 2 - half;
  *point_a = saturate(centre + gjk_sar64(a, 31), saturated);
  *point_b = saturate(centre + gjk_sar64(b, 31) - whole, saturated);
}

static void nearest_points(const gjk_iteration *it, gjk_distance_result *out) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *u = &s->slot[s->order[0]];
  const gjk_vertex *v = s->count > 1 ? &s->slot[s->order[1]] : u;
  const gjk_vertex *w = s->count > 2 ? &s->slot[s->order[2]] : u;
  const gjk_vec3 *centre = &it->a->centre;
  gjk_vec3 *a = &out->point_a, *b = &out->point_b;
  int32_t weight[2] = {0, 0};
  if (s->count > 1) {
    gjk_simplex_weights(s, weight);
  }
  report_coordinate(it, centre->x, weighted(weight, u->offset_a.x, v->offset_a.x, w->offset_a.x),
                    weighted(weight, u->w.x, v->w.x, w->w.x), out->normal.x, &a->x, &b->x, &out->saturated);
  report_coordinate(it, centre->y, weighted(weight, u->offset_a.y, v->offset_a.y, w->offset_a.y),
                    weighted(weight, u->w.y, v->w.y, w->w.y), out->normal.y, &a->y, &b->y, &out->saturated);
  report_coordinate(it, centre->z, weighted(weight, u->offset_a.z, v->offset_a.z, w->offset_a.z),
                    weighted(weight, u->w.z, v->w.z, w->w.z), out->normal.z, &a->z, &b->z, &out->saturated);
}

// The distance of the plane through the newest vertex, across the direction, in LSB; off by less than error, Q30.
static int64_t plane_distance(const gjk_iteration *it, int64_t error) {
  const gjk_simplex *s = &it->simplex;
  const gjk_unit3 u = gjk_unit(&it->direction.rounded, it->direction.exact);
  return to_lsb(error - along(&u, &s->slot[s->order[s->count - 1]].w), it->shift);
}

// The proven bounds when the ceiling is reached: the newest vertex was the support along the direction, so nothing lies
// before its plane; and the feature's own plane, found from its own direction, touches the feature.
static void report_bounds(gjk_iteration *it, gjk_distance_result *out) {
  const int64_t error = INT64_C(1) << 33;
  const int64_t rounding = (int64_t)it->a->shape->round + it->b->shape->round;
  const int64_t lower = plane_distance(it, -error) - rounding - 1;
  bool saturated;
  gjk_simplex_direction(&it->simplex, &it->direction);
  const int64_t upper = plane_distance(it, error) - rounding + 1;
  out->lower = lower > 0 ? saturate(lower, &saturated) : 0;
  out->upper = upper > 0 ? saturate(upper, &saturated) : 0;
}

gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out) {
  gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  gjk_iteration it;
  const int64_t radius = (int64_t)a->shape->round + b->shape->round;
  gjk_iteration_start(&it, a, b, GJK_GOAL_DISTANCE, radius);
  gjk_outcome outcome = gjk_iteration_run(&it, GJK_GOAL_DISTANCE, cache);
  out->iterations = it.rounds;
  if (outcome == GJK_OUTCOME_LIMIT) {
    report_bounds(&it, out);
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->saturated = false;
  int64_t gap = 0;
  if (outcome == GJK_OUTCOME_NEAREST) {
    out->normal = gjk_unit(&it.direction.rounded, it.direction.exact);
    const int64_t approximate = -along(&out->normal, &it.simplex.slot[it.simplex.order[0]].w);
    if (rounded_touch(&it, approximate)) {
      outcome = GJK_OUTCOME_NEAR;
    } else {
      gap = exact_distance(&it, approximate) - radius;
      nearest_points(&it, out);
    }
  }
  out->intersecting = outcome != GJK_OUTCOME_NEAREST;
  out->distance = saturate(gap, &out->saturated);
  out->lower = out->distance;
  out->upper = out->distance;
  gjk_iteration_certify(&it, outcome, &out->certificate);
  if (cache != NULL) {
    gjk_iteration_keep(&it, outcome, cache);
  }
  return GJK_OK;
}
