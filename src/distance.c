// The distance query: how far apart, and where.
#include "gjk/distance.h"

#include "iteration.h"
#include "unit.h"

// u . a for a unit vector u, Q2.30, and |a| <= 3 2^29: at most 2^61.
static int64_t along(const gjk_unit3 *u, const gjk_vec3 *a) {
  return gjk_mac32(gjk_mac32(gjk_mul32(u->x, a->x), u->y, a->y), u->z, a->z);
}

// x / 2^(30 + shift) to the nearest integer, not negative; from the frame's Q30 to LSB. -3 <= shift <= 29.
static int64_t to_lsb(int64_t x, int shift) {
  const unsigned n = (unsigned)(30 + shift);
  return x <= 0 ? 0 : gjk_sar64(x + (INT64_C(1) << (n - 1)), n);
}

// How far a plane distance, Q30, may be off: the unit vector is within 2^-28 of the exact direction and |w| <= 3 2^29.
#define PLANE_ERROR (INT64_C(1) << 33)

// The exact search among the few candidates that the plane distance leaves.
GJK_OUT_OF_LINE static int64_t settle_distance(const gjk_iteration *it, int64_t low, int64_t high) {
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

// The feature's distance in LSB, correctly rounded, a tie up; from the distance of its plane.
static int64_t exact_distance(const gjk_iteration *it, int64_t plane) {
  if (it->shift >= 4 && !GJK_SMALL) {
    // In steps of 2^32: the error and the bits cut off are less than 3.
    const unsigned n = (unsigned)it->shift - 2;
    const uint32_t mask = (UINT32_C(1) << n) - 1;
    const uint32_t steps = gjk_low32(gjk_sar64(plane, 32)) + (UINT32_C(1) << (n - 1));
    const uint32_t fraction = steps & mask;
    if (plane >= 0 && fraction >= 3 && fraction <= mask - 3) {
      return steps >> n;
    }
  }
  if (it->shift < 0) {
    return to_lsb(plane, it->shift);
  }
  return settle_distance(it, to_lsb(plane - PLANE_ERROR, it->shift), to_lsb(plane + PLANE_ERROR, it->shift));
}

// Do the cores come within the roundings of each other?
static bool rounded_touch(const gjk_iteration *it, int64_t plane) {
  const int64_t radius = gjk_shl64(it->radius, 30);  // below 2^61
  return radius > 0 && plane - PLANE_ERROR <= radius && gjk_iteration_near(it);
}

static gjk_q16 saturate(int64_t x, bool *saturated) {
  if (x > INT32_MAX || x < INT32_MIN) {
    *saturated = true;
    return x < 0 ? INT32_MIN : INT32_MAX;
  }
  return (gjk_q16)x;
}

// The feature's vertices and the weights of its nearest point; of fewer than three the first fills in, without weight.
typedef struct feature {
  const gjk_vertex *u, *v, *w;
  gjk_share weight[2];  // of v and w
} feature;

// In a frame of less than this shift an edge may be so long that weights of 31 bits put the point off by half an LSB.
#define FINE_SHIFT 4

// What the low parts of the weights add for edges v and w, Q31: at most 2^31.
GJK_OUT_OF_LINE static int64_t fine_part(const feature *f, int32_t v, int32_t w) {
  return gjk_sar64(gjk_mac32(gjk_mul32(v, f->weight[0].low), w, f->weight[1].low), 16);
}

// u + (weight of v) (v - u) + (weight of w) (w - u), Q31. Pre: coordinates at most 3 2^29, differences below 2^31 in
// size: the sum of the first two terms is at most 7 2^60, the whole at most 3 2^60.
static inline int64_t weighted(const feature *f, int32_t u, int32_t v, int32_t w) {
  v -= u;
  w -= u;
  const int64_t sum = gjk_mac32(gjk_mac32(gjk_shl64(u, 31), v, f->weight[0].high), w, f->weight[1].high);
  return (f->weight[0].low | f->weight[1].low) != 0 ? sum + fine_part(f, v, w) : sum;
}

// The coordinate of one point: of the core Q31 from A's centre, moved by round along the normal.
static gjk_q16 coordinate(int64_t core, gjk_q16 centre, gjk_q30 normal, gjk_q16 round, bool *saturated) {
  const int64_t half = INT64_C(1) << 30;
  return saturate(centre + gjk_sar64(core + half + gjk_mul32(normal, round) * 2, 31), saturated);
}

// One coordinate of B's vertex, offset from B's centre, from that of A's vertex and of w. At most 2^28 + 2^3.
static inline int32_t offset_b(const gjk_iteration *it, gjk_q16 centre_a, gjk_q16 centre_b, int32_t a, int32_t w) {
  const int shift = it->shift;
  if (shift >= 0) {
    return centre_a - centre_b + a - gjk_sar32(w, (unsigned)shift);
  }
  return (int32_t)((int64_t)centre_a - centre_b + a - gjk_shl64(w, (unsigned)-shift));
}

// One coordinate of both points, from that of the centres and the vertices.
GJK_ONCE static void report_axis(const gjk_iteration *it, const feature *f, gjk_q16 centre_a, gjk_q16 centre_b,
                                 const int32_t a[3], const int32_t w[3], gjk_q30 normal, gjk_q16 *point_a,
                                 gjk_q16 *point_b, bool *cut) {
  *point_a = coordinate(weighted(f, a[0], a[1], a[2]), centre_a, normal, it->a->shape->round, cut);
  *point_b =
      coordinate(weighted(f, offset_b(it, centre_a, centre_b, a[0], w[0]), offset_b(it, centre_a, centre_b, a[1], w[1]),
                          offset_b(it, centre_a, centre_b, a[2], w[2])),
                 centre_b, normal, -it->b->shape->round, cut);
}

static void nearest_points(const gjk_iteration *it, const feature *f, gjk_distance_result *out) {
  const gjk_vertex *u = f->u, *v = f->v, *w = f->w;
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  const int32_t ax[3] = {u->offset_a.x, v->offset_a.x, w->offset_a.x}, wx[3] = {u->w.x, v->w.x, w->w.x};
  report_axis(it, f, a->x, b->x, ax, wx, out->normal.x, &out->point_a.x, &out->point_b.x, &out->saturated);
  const int32_t ay[3] = {u->offset_a.y, v->offset_a.y, w->offset_a.y}, wy[3] = {u->w.y, v->w.y, w->w.y};
  report_axis(it, f, a->y, b->y, ay, wy, out->normal.y, &out->point_a.y, &out->point_b.y, &out->saturated);
  const int32_t az[3] = {u->offset_a.z, v->offset_a.z, w->offset_a.z}, wz[3] = {u->w.z, v->w.z, w->w.z};
  report_axis(it, f, a->z, b->z, az, wz, out->normal.z, &out->point_a.z, &out->point_b.z, &out->saturated);
}

GJK_OUT_OF_LINE static void report_points(const gjk_iteration *it, gjk_distance_result *out) {
  const gjk_simplex *s = &it->simplex;
  feature f;
  f.u = &s->slot[s->order[0]];
  f.v = s->count > 1 ? &s->slot[s->order[1]] : f.u;
  f.w = s->count > 2 ? &s->slot[s->order[2]] : f.u;
  if (s->count > 1) {
    gjk_simplex_weights(s, it->shift < FINE_SHIFT, f.weight);
  } else {
    f.weight[0].high = f.weight[0].low = f.weight[1].high = f.weight[1].low = 0;
  }
  nearest_points(it, &f, out);
}

// The distance of the plane through the newest vertex, across the direction, in LSB; error is added, Q30.
static int64_t plane_distance(const gjk_iteration *it, int64_t error) {
  const gjk_simplex *s = &it->simplex;
  const gjk_unit3 u = gjk_unit(&it->direction.d);
  return to_lsb(error - along(&u, &s->slot[s->order[s->count - 1]].w), it->shift);
}

// The proven bounds when the ceiling is reached: the newest vertex was the support along the direction, so nothing lies
// before its plane; and the feature's own plane, found from its own direction, touches the feature.
GJK_OUT_OF_LINE static void report_bounds(gjk_iteration *it, gjk_distance_result *out) {
  const int64_t rounding = (int64_t)it->a->shape->round + it->b->shape->round;
  const int64_t lower = plane_distance(it, -PLANE_ERROR) - rounding - 1;
  bool saturated;
  gjk_simplex_direction(&it->simplex, &it->direction);
  const int64_t upper = plane_distance(it, PLANE_ERROR) - rounding + 1;
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
    out->normal = gjk_unit(&it.direction.d);
    const int64_t plane = -along(&out->normal, &it.simplex.slot[it.simplex.order[0]].w);
    if (rounded_touch(&it, plane)) {
      outcome = GJK_OUTCOME_NEAR;
    } else {
      gap = exact_distance(&it, plane) - radius;
      report_points(&it, out);
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
