// The distance query: how far apart, and where.
//
//   1. Search for the feature of A - B nearest to the origin (gjk_search.h).
//   2. Find the distance of its plane along its unit normal.
//   3. Decide exactly whether the cores come within the convex radii: then the shapes intersect.
//   4. Round the distance of the feature: exactly, among the integers that step 2 leaves.
//   5. Find the nearest points.
// Out of iterations:
//   6. Bound the distance by the planes of the last iteration, and measure the feature so far as in steps 2 to 5.
//
// What is rounded:
//   normal     each component within 2^-30 of the rounded direction's unit vector: within 2^-28 of the exact one
//   step 2     within GJK_PLANE_ERROR, which only narrows step 4
//   step 4     to the nearest LSB, a tie up. Far pairs measure vertices that are rounded to 2^-shift LSB: 2^-28
//              relative
//   points     per component to the nearest LSB, within 1 LSB of the shape
//   step 6     outwards: lower down and upper up, by the plane error and 1 LSB
#include "gjk_distance.h"

#include "../arith/gjk_unit.h"
#include "../gjk/gjk_search.h"
#include "../gjk/gjk_witness.h"

// The exact distance, rounded: the one of low to high, in LSB, that an exact comparison of squares finds.
//   frame 2^n times as coarse as an LSB, n <= 3: no edge exceeds 2^(30 - n), and 4^n numerator stays below 2^186
#if GJK_SHAPES <= GJK_SHAPES_POINTS
//   points: up from low, while 2 distance >= q 2^shift. With q = 2^n a + f for a far frame of shift -n, squared:
//     4 square - a^2 >= (2 a f 2^n + f^2) / 4^n      |w| <= 2^30 + 1, a < 2^32; the left side is below 2^40, see below
GJK_OUT_OF_LINE static int64_t settle_distance(const gjk_iteration *it, int64_t low, int64_t high, gjk_round_to to) {
  const int64_t square = 4 * it->simplex.toward[0][0] - (to == GJK_ROUND_UP ? 1 : 0);  // up: near frames alone
  const unsigned up = it->shift > 0 ? (unsigned)it->shift : 0, n = it->shift < 0 ? (unsigned)-it->shift : 0;
  for (; low < high; low++) {
    const int64_t q = gjk_shl64(2 * low + (int)to, up);
    const uint32_t a = (uint32_t)gjk_sar64(q, n), f = gjk_low32(q) & ((UINT32_C(1) << n) - 1);
    const int64_t rest = square - gjk_int64(gjk_umul32(a, a));
    if (rest < 0 || gjk_shl64(rest, 2 * n) < gjk_shl64(gjk_int64(gjk_umul32(a, f)), n + 1) + (int32_t)(f * f)) {
      break;
    }
  }
  return low;
}
#else
GJK_OUT_OF_LINE static int64_t settle_distance(const gjk_iteration *it, int64_t low, int64_t high, gjk_round_to to) {
  const unsigned finer = it->shift > 0 ? (unsigned)it->shift : 0;
  gjk_u192 numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  for (int n = 2 * it->shift; n < 0; n++) {
    gjk_u192_add(&numerator, &numerator);
  }
  // At most 129 candidates, so 8 steps; 2 high + 2 < 2^35.
  return gjk_round_distance(&numerator, &denominator, low, high, finer, to);
}
#endif

// x / 2^(30 + shift), not negative, floored after half is added; from the frame's Q30 to LSB. -3 <= shift <= 29.
GJK_ONCE static int64_t to_lsb(int64_t x, int64_t half, int shift) {
  return x <= 0 ? 0 : gjk_sar64(x + half, (unsigned)(30 + shift));
}

int64_t gjk_feature_distance(const gjk_iteration *it, int64_t plane, gjk_round_to to) {
  const int shift = it->shift;
  const int64_t half = to == GJK_ROUND_NEAREST ? gjk_shl64(1, (unsigned)(29 + shift)) : 0;
  const int64_t low = to_lsb(plane - GJK_PLANE_ERROR, half, shift), high = to_lsb(plane + GJK_PLANE_ERROR, half, shift);
  if (low == high) {
    return low;
  }
  // A multiple of 2^shift needs no comparison.
  const int32_t along = !GJK_SMALL && shift >= 0 ? gjk_simplex_along_axis(&it->simplex) : -1;
  return along >= 0 ? gjk_sar32(along, (unsigned)shift) : settle_distance(it, low, high, to);
}

// The feature's distance in LSB, correctly rounded, a tie up; from the distance of its plane.
static int64_t exact_distance(const gjk_iteration *it, const gjk_unit3 *normal, int64_t plane) {
  // not reached: GJK_SMALL is a constant
  if (it->shift >= 4 && !GJK_SMALL) {
    // In units of 2^32 the plane's error and the bits dropped are below 3, so a fraction from 3 on is certain.
    const unsigned n = (unsigned)it->shift - 2;
    const uint32_t mask = (UINT32_C(1) << n) - 1;
    const uint32_t steps = gjk_low32(gjk_sar64(plane, 32)) + (UINT32_C(1) << (n - 1));
    const uint32_t fraction = steps & mask;
    if (plane >= 0 && fraction >= 3 && fraction <= mask - 3) {
      return steps >> n;
    }
  }
  int64_t distance = gjk_feature_distance(it, plane, GJK_ROUND_NEAREST);
  if (it->shift == -1) {
    // Rounding raised each coordinate of w by 0 or 1 LSB, 1/2 on average. Remove that bias along the normal. Coarser
    // frames need not: there the error is below 2^-28 of the distance in any case.
    distance += gjk_sar64((int64_t)normal->x + normal->y + normal->z + (INT64_C(1) << 30), 31);
  }
  return distance;
}

int64_t gjk_plane_of(const gjk_iteration *it, gjk_unit3 *normal) {
  *normal = gjk_unit(&it->direction.d);
  return -gjk_along(normal, &it->simplex.slot[it->simplex.order[0]].w);
}

bool gjk_convex_radii_touch(const gjk_iteration *it, int64_t plane) {
  const int64_t radius = gjk_shl64(it->radius, 30);  // below 2^61
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return it->radius > 0 && gjk_iteration_near(it);
  }
  return radius > 0 && plane - GJK_PLANE_ERROR <= radius &&
         (plane + GJK_PLANE_ERROR <= radius || gjk_iteration_near(it));
}

// The distance of the plane through the newest vertex across the direction, plus error (Q30), less the convex radii, to
// the nearest LSB. Negative when the origin lies behind the plane.
//   |plane|    at most 2^61 + 2^33; shifted by 30 + shift >= 27:   result below 2^35
static int64_t plane_distance(const gjk_iteration *it, int64_t error) {
  const gjk_simplex *s = &it->simplex;
  const gjk_unit3 u = gjk_unit(&it->direction.d);
  const int64_t plane = error - gjk_along(&u, &s->slot[s->order[s->count - 1]].w);
  const unsigned n = (unsigned)(30 + it->shift);
  return gjk_sar64(plane + gjk_shl64(1, n - 1), n) - gjk_convex_radii(it);
}

gjk_outcome gjk_distance_bounds(gjk_iteration *it, int64_t *lower, int64_t *upper) {
  *lower = plane_distance(it, -GJK_PLANE_ERROR) - 1 - (gjk_pair_is_curved(it) ? GJK_CURVED_ERROR : 0);
  if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
    *upper = -gjk_convex_radii(it);
    return GJK_OUTCOME_ENCLOSING;
  }
  *upper = plane_distance(it, GJK_PLANE_ERROR) + 1;
  return *upper <= 0 ? GJK_OUTCOME_NEAR : GJK_OUTCOME_LIMIT;
}

// Step 6: narrows the bounds by what the last iteration proves, which may settle the question.
static gjk_outcome narrow(gjk_iteration *it, gjk_distance_result *out) {
  int64_t lower, upper;
  const gjk_outcome outcome = gjk_distance_bounds(it, &lower, &upper);
  if (outcome == GJK_OUTCOME_LIMIT) {
    out->lower = lower > out->lower ? (gjk_q16)(lower < INT32_MAX ? lower : INT32_MAX) : out->lower;
    out->upper = upper < out->upper ? (gjk_q16)upper : out->upper;
  }
  return outcome;
}

// Step 1: runs at most limit iterations in all. Narrows the bounds when they do not suffice.
static gjk_outcome run_and_narrow(gjk_iteration *it, unsigned limit, bool points, const gjk_cache *cache,
                                  gjk_distance_result *out) {
  const gjk_outcome outcome =
      points ? gjk_search(it, GJK_GOAL_DISTANCE, cache, limit) : gjk_search_any(it, GJK_GOAL_DISTANCE, cache, limit);
  out->iterations = it->iterations;
  return outcome == GJK_OUTCOME_LIMIT ? narrow(it, out) : outcome;
}

void gjk_distance_report(const gjk_iteration *it, gjk_outcome outcome, bool points, gjk_cache *cache,
                         gjk_distance_result *out) {
  int64_t gap = 0;
  out->saturated = false;
  if (outcome == GJK_OUTCOME_NEAREST) {
    // Step 2.
    const int64_t plane = gjk_plane_of(it, &out->normal);
    if (gjk_convex_radii_touch(it, plane)) {  // Step 3
      outcome = GJK_OUTCOME_NEAR;
    } else {
      // Steps 4 and 5.
      gap = exact_distance(it, &out->normal, plane) - gjk_convex_radii(it);
      if (points) {
        gjk_witness_points(it, &out->normal, &out->point_a, &out->point_b, &out->saturated);
      }
    }
  }
  out->intersecting = outcome != GJK_OUTCOME_NEAREST;
  out->distance = gjk_saturate_noting(gap, &out->saturated);
  out->lower = out->distance;
  out->upper = out->distance;
  if (points) {
    gjk_iteration_certify(it, outcome, &out->certificate);
  }
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && cache != NULL) {
    gjk_iteration_keep(it, outcome, cache);
  }
}

static void start_distance(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_distance_result *out) {
  gjk_iteration_start(it, a, b, GJK_GOAL_DISTANCE, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
  out->lower = 0;
  out->upper = GJK_DISTANCE_MAX;
}

// Step 6: out->distance becomes the exact distance of the feature to the nearest LSB, and out->upper the same rounded
// up. Both are sharper than the plane's bound by up to 17 units of the frame, which a far frame keeps.
// False: the feature is within the convex radii, so the shapes intersect.
static bool take_feature(const gjk_iteration *it, int64_t plane, gjk_distance_result *out) {
  out->distance = out->upper;
  if (it->shift < 0) {
    return true;
  }
  const int64_t nearest = gjk_feature_distance(it, plane, GJK_ROUND_NEAREST);
  //@ assert nearest >= 0 && nearest <= INT64_C(1) << 31;
  const int64_t upper = settle_distance(it, nearest, nearest + 1, GJK_ROUND_UP) - gjk_convex_radii(it);
  out->distance = (gjk_q16)(nearest - gjk_convex_radii(it));
  out->upper = (gjk_q16)upper;
  return upper > 0;
}

// Step 6: reports the bounds and the nearest points so far.
// False: they prove that the shapes intersect; the caller reports that.
// Pre: it->direction is the feature's.
static bool stop_early(const gjk_iteration *it, gjk_distance_result *out) {
  if (!take_feature(it, gjk_plane_of(it, &out->normal), out)) {
    return false;
  }
  out->saturated = false;
  gjk_witness_points(it, &out->normal, &out->point_a, &out->point_b, &out->saturated);
  out->intersecting = false;
  out->certificate.proof = GJK_PROOF_NONE;
  out->certificate.count = 0;
  return true;
}

// gjk_distance of points and segments.
static gjk_status distance_round(const gjk_collider *a, const gjk_collider *b, gjk_distance_result *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  if (status == GJK_OK) {
    gjk_iteration it;
    gjk_iteration_start(&it, a, b, GJK_GOAL_DISTANCE, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
    const gjk_outcome outcome = gjk_search_whole(&it, GJK_GOAL_DISTANCE, NULL);
    if (gjk_search_has_ties(&it, GJK_GOAL_DISTANCE, outcome)) {
      (void)gjk_search_canonical(&it, true);
    }
    out->iterations = it.iterations;
    gjk_distance_report(&it, outcome, true, NULL, out);
  }
  return status;
}

gjk_status gjk_distance_with(const gjk_collider *a, const gjk_collider *b, gjk_distance_detail detail, gjk_cache *cache,
                             gjk_distance_result *out) {
  const bool points = detail != GJK_DISTANCE_ALONE;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return distance_round(a, b, out);
  }
  gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  gjk_iteration it;
  start_distance(&it, a, b, out);
  if (!GJK_SMALL) {
    it.scans = detail == GJK_DISTANCE_BY_SCANS;
  }
  gjk_outcome outcome = run_and_narrow(&it, GJK_NO_LIMIT, points, cache, out);
  if (GJK_SHAPES >= GJK_SHAPES_ALL && outcome == GJK_OUTCOME_LIMIT) {
    if (stop_early(&it, out)) {
      return GJK_ERROR_ITERATION_LIMIT;
    }
    outcome = GJK_OUTCOME_NEAR;
  }
  gjk_distance_report(&it, outcome, points, cache, out);
  return GJK_OK;
}

gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out) {
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {
    return distance_round(a, b, out);
  }
  return gjk_distance_with(a, b, GJK_DISTANCE_POINTS, cache, out);
}

gjk_status gjk_distance_until(const gjk_collider *a, const gjk_collider *b, const gjk_effort *effort, gjk_cache *cache,
                              gjk_distance_result *out) {
  gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK || effort == NULL) {
    return status != GJK_OK ? status : GJK_ERROR_NULL;
  }
  if (effort->error < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  gjk_iteration it;
  start_distance(&it, a, b, out);
  const unsigned ceiling = gjk_search_limit(&it);
  const bool limited = effort->iterations > 0 && effort->iterations < ceiling;
  const unsigned most = limited ? effort->iterations : ceiling;
  bool spent;
  // Each turn is one iteration, so there are at most `most` turns.
  do {
    const gjk_outcome outcome = run_and_narrow(&it, it.iterations + 1u, true, NULL, out);
    if (outcome != GJK_OUTCOME_LIMIT) {
      gjk_distance_report(&it, outcome, true, cache, out);
      return GJK_OK;
    }
    spent = effort->error > 0 && out->upper - out->lower <= effort->error;
  } while (!spent && it.iterations < most);
  if (!stop_early(&it, out)) {
    gjk_distance_report(&it, GJK_OUTCOME_NEAR, true, cache, out);
    return GJK_OK;
  }
  return spent || limited ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}
