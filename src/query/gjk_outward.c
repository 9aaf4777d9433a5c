// How a normal is rounded outward so that moving by the depth along it parts the shapes: the steps of gjk_outward.h.
#include "gjk_outward.h"

#include "../gjk/gjk_frame.h"
#include "../gjk/gjk_search.h"
#include "gjk_distance.h"

// depth u / 2^30, rounded away from 0.
//   |depth u| <= 2^31 2^30 = 2^61, and 2^30 - 1 more: size < 2^62, size / 2^30 < 2^31 for the depths there are
static gjk_q16 move_outward(gjk_q16 depth, gjk_q30 u) {
  const uint64_t size = gjk_magnitude64(gjk_mul32(depth, u)) + ((UINT32_C(1) << 30) - 1);
  const gjk_q16 steps = (gjk_q16)(size >> 30);
  return u < 0 ? -steps : steps;
}

gjk_vec3 gjk_outward_move(gjk_q16 depth, const gjk_unit3 *normal) {
  const gjk_vec3 t = {move_outward(depth, normal->x), move_outward(depth, normal->y), move_outward(depth, normal->z)};
  return t;
}

// What step 1 adds to u t, Q60: |u| (|t| 2^30 - depth |u|).
//   the bracket is what rounding depth |u| up has added, below 2^30; the product is at most 2^60
GJK_ONCE static int64_t surplus(gjk_q16 depth, gjk_q30 u, gjk_q16 t) {
  const int32_t size = (int32_t)gjk_magnitude32(u), steps = (int32_t)gjk_magnitude32(t);
  return gjk_mul32(size, (int32_t)(gjk_shl64(steps, 30) - gjk_mul32(depth, size)));
}

// Step 2. n is the exact normal; u and t are the rounded normal and move; all of length 1 = 2^30:
//   u t             depth |u|^2 + surplus
//   |u|^2           at least 1 - 7/2 2^-30:                             loses 7/2 2^-30 depth
//   |n - u|         at most 9/2 2^-30, |t| at most depth + sqrt(3):     loses 9/2 2^-30 (depth + sqrt(3))
//   n t             at least depth + surplus - 8 (depth + 1) 2^-30
static bool surely_suffices(gjk_q16 depth, const gjk_unit3 *u, const gjk_vec3 *t) {
  return surplus(depth, u->x, t->x) + surplus(depth, u->y, t->y) + surplus(depth, u->z, t->z) >=
         gjk_shl64((int64_t)depth + 1, 33);
}

bool gjk_outward_clears(const gjk_vec3 *w, int shift, const gjk_long3 *n, const gjk_vec3 *t) {
  const unsigned s = (unsigned)shift;
  // In LSB, at most 2^30 + 2^29 in size. The shifts lose nothing: w is a multiple of 2^shift.
  const gjk_vec3 rest = {gjk_sar32(w->x, s) - t->x, gjk_sar32(w->y, s) - t->y, gjk_sar32(w->z, s) - t->z};
  return gjk_dot_sign(n, &rest) <= 0;
}

// Step 3 for cores alone: does the move take all of A - B behind the facet's plane? Exact.
static bool clears_facet(const gjk_iteration *it, const gjk_facet *facet, const gjk_vec3 *t) {
  const gjk_vec3 *w = &facet->corner[0].w;
  gjk_long3 n;
  gjk_triangle_normal(w, &facet->corner[1].w, &facet->corner[2].w, &n);
  return gjk_outward_clears(w, it->shift, &n, t);
}

// Step 3 for convex radii: are the shapes apart or touching when B has moved by t? Exact. Overwrites the iteration.
// Pre: t parts the cores.
static bool is_apart_when_moved(gjk_iteration *it, const gjk_vec3 *t) {
  // The shapes overlap, and the move makes them touch. So along t the centres are at most the sum of the radii apart, which is
  // below 2^29, and across it as well:  |delta| < 2^30
  const gjk_vec3 delta = gjk_sub(gjk_sub(it->a->centre, it->b->centre), *t);
  const int64_t radius = gjk_convex_radii(it);  // below 2^29
  gjk_u192 numerator, denominator;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return gjk_dot(&delta, &delta) >= gjk_mul32((int32_t)radius, (int32_t)radius);
  }
  gjk_frame_set_near(it, &delta, radius);
  it->iterations = 0;
  gjk_simplex_clear(&it->simplex);
  // not reached: any other outcome, since t parts the cores
  if (gjk_search_whole(it, GJK_GOAL_SIGNED, NULL) != GJK_OUTCOME_NEAREST) {
    return false;
  }
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)(2 * radius) << it->shift) >= 0;
}

// Step 3.
static bool does_part(gjk_iteration *it, const gjk_facet *facet, const gjk_vec3 *t) {
  // Cores of points and segments have the depth 0, which no facet is asked about.
  return GJK_SHAPES >= GJK_SHAPES_BOXES && facet != NULL ? clears_facet(it, facet, t) : is_apart_when_moved(it, t);
}

// Step 4. A component of 0 is exact, and none exceeds 1.
static void grow_component(gjk_q30 *u) {
  if (*u != 0 && *u > -GJK_Q30_ONE && *u < GJK_Q30_ONE) {
    *u += *u > 0 ? 1 : -1;
  }
}

// Along an axis of the frame, where step 4 changes nothing.
static bool is_axis(const gjk_unit3 *u) {
  return (gjk_magnitude32(u->x) | gjk_magnitude32(u->y) | gjk_magnitude32(u->z)) == GJK_Q30_ONE;
}

void gjk_outward_normal(gjk_iteration *it, const gjk_facet *facet, bool exact, gjk_q16 depth, gjk_unit3 *normal) {
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && is_axis(normal)) {
    return;
  }
  for (int i = 0; i < 6 && depth > 0; i++) {  // not reached: 6, growing 5 times suffices
    const gjk_vec3 t = gjk_outward_move(depth, normal);
    if (surely_suffices(depth, normal, &t) || (exact ? does_part(it, facet, &t) : i == 5)) {
      return;
    }
    grow_component(&normal->x);
    grow_component(&normal->y);
    grow_component(&normal->z);
  }
}
