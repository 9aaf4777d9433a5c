// The penetration and the signed distance queries.
#include "gjk/penetration.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_unit.h"
#include "../depth/gjk_box_sat.h"
#include "../depth/gjk_epa.h"
#include "../gjk/gjk_search.h"
#include "../gjk/gjk_witness.h"
#include "gjk_distance.h"

size_t gjk_workspace_bytes(uint16_t vertices) {
  return vertices < 4 ? 0 : GJK_EPA_CELLS((size_t)vertices) * sizeof(gjk_epa_cell);
}

// An overlap while it is being measured.
typedef struct overlap {
  gjk_iteration it;
  gjk_facet facet;  // of the cores, when they overlap
  gjk_q16 lower;    // bounds of the cores' depth or, negative, of minus their distance
  gjk_q16 upper;
  uint16_t iterations;
  uint8_t proof;
} overlap;

// What rounding adds to the move along the normal, Q60: |u| (|t| 2^30 - depth |u|), at most 2^60.
static int64_t surplus(gjk_q16 depth, gjk_q30 u, gjk_q16 t) {
  const int32_t size = (int32_t)gjk_magnitude32(u), steps = (int32_t)gjk_magnitude32(t);
  return gjk_mul32(size, (int32_t)(gjk_shl64(steps, 30) - gjk_mul32(depth, size)));
}

// With u within 9/2 2^-30 of the exact normal and its own length within 7/4 2^-30 of 1, a move by t leaves at least
// depth + surplus - 8 (depth + 1) 2^-30 along the exact normal.
static bool surely_suffices(gjk_q16 depth, const gjk_unit3 *u, const gjk_vec3 *t) {
  return surplus(depth, u->x, t->x) + surplus(depth, u->y, t->y) + surplus(depth, u->z, t->z) >=
         gjk_shl64((int64_t)depth + 1, 33);
}

// Are the shapes apart or touching when B has moved by t? Exact. Overwrites the iteration. Pre: t parts the cores.
GJK_OUT_OF_LINE static bool is_apart_when_moved(gjk_iteration *it, const gjk_vec3 *t) {
  const gjk_collider *a = it->a, *b = it->b;
  // In the middle of the world, where there is room: they overlap, so their centres are at most 2^29 + 2^3 apart, and t is
  // not much longer.
  const gjk_vec3 origin = {0, 0, 0}, apart = gjk_sub(b->centre, a->centre);
  gjk_collider moved_a, moved_b;
  gjk_copy(&moved_a, a, sizeof moved_a);
  gjk_copy(&moved_b, b, sizeof moved_b);
  moved_a.centre = origin;
  moved_b.centre = gjk_add(apart, *t);
  const int64_t radius = gjk_convex_radii(it);
  gjk_iteration_start(it, &moved_a, &moved_b, GJK_GOAL_SIGNED, radius);
  //@ assert it->shift >= 0;
  gjk_u192 numerator, denominator;
  bool parted = false;
  if (gjk_search(it, GJK_GOAL_SIGNED, NULL, GJK_NO_LIMIT) == GJK_OUTCOME_NEAREST) {  // not reached: else, see above
    gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
    parted = gjk_compare_distance(&numerator, &denominator, (uint64_t)(2 * radius) << it->shift) >= 0;
  }
  it->a = a;
  it->b = b;
  return parted;
}

// Does the move take A - B behind the facet's plane? Exact.
static bool clears_facet(const overlap *o, const gjk_vec3 *t) {
  const gjk_vec3 *w = &o->facet.corner[0].w;
  const unsigned shift = (unsigned)o->it.shift;
  gjk_long3 n;
  gjk_triangle_normal(w, &o->facet.corner[1].w, &o->facet.corner[2].w, &n);
  // In LSB, at most 2^30 + 2^29.
  const gjk_vec3 rest = {gjk_sar32(w->x, shift) - t->x, gjk_sar32(w->y, shift) - t->y, gjk_sar32(w->z, shift) - t->z};
  return gjk_dot_sign(&n, &rest) <= 0;
}

static void grow_component(gjk_q30 *u) {
  if (*u != 0 && *u > -GJK_Q30_ONE && *u < GJK_Q30_ONE) {
    *u += *u > 0 ? 1 : -1;
  }
}

// Does the move part the shapes? Exact.
static bool does_part(overlap *o, const gjk_vec3 *t) {
  return o->proof == GJK_PROOF_FACET && gjk_convex_radii(&o->it) == 0 ? clears_facet(o, t)
                                                                      : is_apart_when_moved(&o->it, t);
}

// Rounds the normal away from 0 as far as the move by depth needs it. Once no component is less than the exact one, it
// suffices: 5 times. Too small a workspace leaves a bound, and no feature to ask.
static void widen_normal(overlap *o, gjk_status status, gjk_penetration_result *out) {
  for (int i = 0; i < 6 && out->depth > 0; i++) {  // not reached: 6, see above
    const gjk_unit3 *u = &out->normal;
    const gjk_vec3 t = {gjk_move_along(out->depth, u->x), gjk_move_along(out->depth, u->y),
                        gjk_move_along(out->depth, u->z)};
    if (surely_suffices(out->depth, u, &t) || (status == GJK_ERROR_CAPACITY ? i == 5 : does_part(o, &t))) {
      return;
    }
    grow_component(&out->normal.x);
    grow_component(&out->normal.y);
    grow_component(&out->normal.z);
  }
}

// Measures cores that intersect: the origin lies in the simplex.
static gjk_status measure_cores(overlap *o, const gjk_workspace *workspace) {
  gjk_iteration *it = &o->it;
  gjk_facet *facet = &o->facet;
  gjk_epa_outcome expansion = GJK_EPA_FACET;
  o->proof = GJK_PROOF_FACET;
  if (facet->found) {
    o->lower = facet->depth;
  } else {
    expansion = gjk_epa(it, workspace, facet, &o->lower, &o->iterations);
  }
  if (expansion == GJK_EPA_TOUCHES) {
    o->proof = GJK_PROOF_PLANE;
    o->upper = -o->lower;
    return GJK_OK;
  }
  o->upper = facet->depth;
  gjk_facet_load(facet, it);
  return expansion == GJK_EPA_FULL ? GJK_ERROR_CAPACITY : GJK_OK;
}

// Measures cores that are apart by plane in the frame, Q30: minus their distance, rounded up.
static void measure_gap(overlap *o, int64_t plane) {
  const gjk_iteration *it = &o->it;
  const unsigned n = (unsigned)(30 + it->shift);
  int64_t low = plane > GJK_PLANE_ERROR ? gjk_sar64(plane - GJK_PLANE_ERROR, n) : 0;
  const int64_t high = gjk_sar64(plane + GJK_PLANE_ERROR, n);
  //@ assert low >= 0 && low <= INT64_C(1) << 30 && high <= INT64_C(1) << 30;
  if (low < high) {
    gjk_u192 numerator, denominator;
    gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
    // At most 17 candidates, so 5 steps.
    low = gjk_round_distance(&numerator, &denominator, low, high, (unsigned)it->shift, GJK_ROUND_DOWN);
  }
  o->proof = GJK_PROOF_NEAREST;
  o->upper = -(gjk_q16)low + (gjk_pair_is_curved(it) ? GJK_CURVED_ERROR : 0);
  o->lower = -(gjk_q16)low - (gjk_pair_is_curved(it) ? GJK_CURVED_ERROR + 1 : 0);
}

static void certify(const overlap *o, gjk_certificate *out) {
  gjk_iteration_certify(&o->it, GJK_OUTCOME_NEAREST, out);
  if (gjk_pair_is_curved(&o->it)) {
    return;
  }
  out->proof = o->proof;
  if (o->proof == GJK_PROOF_FACET) {
    out->count = 3;
    for (int i = 0; i < 3; i++) {
      out->a[i] = o->facet.corner[i].a.vertex;
      out->b[i] = o->facet.corner[i].b;
    }
  }
}

// The distance of the cores' plane in the frame, Q30, and its normal.
static int64_t plane_of(const gjk_iteration *it, gjk_unit3 *normal) {
  *normal = gjk_unit(&it->direction.d);
  return -gjk_along(normal, &it->simplex.slot[it->simplex.order[0]].w);
}

// Reports an overlap. plane and the normal: when the cores are apart.
static gjk_status report_depth(overlap *o, gjk_outcome outcome, int64_t plane, const gjk_workspace *workspace,
                               gjk_penetration_result *out) {
  gjk_status status = GJK_OK;
  const gjk_q16 rounding = (gjk_q16)gjk_convex_radii(&o->it);
  bool saturated;
  if (outcome == GJK_OUTCOME_NEAREST) {
    measure_gap(o, plane);
  } else {
    status = measure_cores(o, workspace);
    out->normal = o->proof == GJK_PROOF_FACET ? o->facet.normal : gjk_unit(&o->it.direction.d);
  }
  out->intersecting = true;
  out->upper = o->upper + rounding;
  out->lower = o->lower + rounding > 0 ? o->lower + rounding : 0;
  // A bound is as far off as curved supports may be; the depth itself is told by the supports as they are.
  const gjk_q16 off = gjk_pair_is_curved(&o->it) && status == GJK_OK ? GJK_CURVED_ERROR : 0;
  out->depth = out->upper - off;
  out->iterations = o->iterations;
  gjk_witness_points(&o->it, &out->normal, &out->point_a, &out->point_b, &saturated);
  certify(o, &out->certificate);
  if (status == GJK_ERROR_CAPACITY) {
    out->certificate.proof = GJK_PROOF_NONE;
  }
  if (!gjk_pair_is_curved(&o->it)) {
    widen_normal(o, status, out);
  }
  return status;
}

// Searches from the cache, and again without it where the cores intersect: what is measured of them then starts from a
// simplex that depends on the pair alone.
static gjk_outcome search_overlap(overlap *o, gjk_goal goal, const gjk_cache *cache) {
  gjk_iteration *it = &o->it;
  const gjk_outcome outcome = gjk_search(it, goal, cache, GJK_NO_LIMIT);
  o->iterations = it->iterations;
  if (outcome != GJK_OUTCOME_ENCLOSING || cache == NULL) {
    return outcome;
  }
  gjk_iteration_start(it, it->a, it->b, goal, gjk_convex_radii(it));
  const gjk_outcome cold = gjk_search(it, goal, NULL, GJK_NO_LIMIT);
  o->iterations = (uint16_t)(o->iterations + it->iterations);
  return cold;
}

// Finds out how the shapes lie: boxes and the like by their facets, which then are found as well, others by iteration. A
// cached tetrahedron is of no use: it held the origin, and most likely still does.
static gjk_outcome start_overlap(overlap *o, gjk_goal goal, gjk_cache *cache) {
  gjk_iteration *it = &o->it;
  gjk_cache direction;
  const gjk_cache *from = !gjk_pair_is_curved(it) && cache != NULL && cache->count < 4 ? cache : NULL;
  o->facet.found = false;
  if (it->shift >= 0 && gjk_is_box_pair(it)) {
    const gjk_box_sat_answer answer = gjk_box_sat(it, &o->facet);
    if (answer == GJK_BOX_SAT_FACET) {
      o->iterations = 0;
      return GJK_OUTCOME_ENCLOSING;
    }
    o->facet.found = false;
    gjk_simplex_clear(&it->simplex);
    if (answer == GJK_BOX_SAT_APART && (goal == GJK_GOAL_DEPTH || cache == NULL)) {
      gjk_iteration_keep(it, GJK_OUTCOME_SEPARATED, &direction);
      from = &direction;
    }
  }
  const gjk_outcome outcome = search_overlap(o, goal, from);
  if (cache != NULL && outcome != GJK_OUTCOME_LIMIT) {
    gjk_iteration_keep(it, outcome, cache);
  }
  return outcome;
}

gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  overlap o;
  gjk_iteration *it = &o.it;
  if (!gjk_iteration_start(it, a, b, GJK_GOAL_DEPTH, (int64_t)a->shape->convex_radius + b->shape->convex_radius)) {
    out->intersecting = false;
    out->iterations = 0;
    out->certificate.proof = GJK_PROOF_SPHERES;
    out->certificate.count = 0;
    return GJK_OK;
  }
  const gjk_outcome outcome = start_overlap(&o, GJK_GOAL_DEPTH, cache);
  if (outcome == GJK_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  int64_t plane = 0;
  if (outcome == GJK_OUTCOME_NEAREST) {
    plane = plane_of(it, &out->normal);
  }
  if (outcome == GJK_OUTCOME_SEPARATED || (outcome == GJK_OUTCOME_NEAREST && !gjk_convex_radii_touch(it, plane))) {
    out->intersecting = false;
    out->iterations = o.iterations;
    gjk_iteration_certify(it, outcome, &out->certificate);
    return GJK_OK;
  }
  //@ assert it->shift >= 0;
  return report_depth(&o, outcome, plane, workspace, out);
}

static void report_signed(const gjk_penetration_result *overlapping, gjk_distance_result *out) {
  out->distance = -overlapping->depth;
  out->lower = -overlapping->upper;
  out->upper = -overlapping->lower;
  out->point_a = overlapping->point_a;
  out->point_b = overlapping->point_b;
  out->normal = overlapping->normal;
  out->intersecting = true;
  out->saturated = false;
  out->iterations = (uint8_t)(overlapping->iterations < UINT8_MAX ? overlapping->iterations : UINT8_MAX);
  out->certificate = overlapping->certificate;
}

static void report_bounds(gjk_iteration *it, gjk_distance_result *out) {
  int64_t lower, upper;
  bool saturated;
  (void)gjk_distance_bounds(it, &lower, &upper);
  out->lower = gjk_saturate_noting(lower, &saturated);
  out->upper = gjk_saturate_noting(upper, &saturated);
  out->iterations = it->iterations;
}

gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  overlap o;
  gjk_iteration *it = &o.it;
  gjk_iteration_start(it, a, b, GJK_GOAL_SIGNED, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
  const gjk_outcome outcome = start_overlap(&o, GJK_GOAL_SIGNED, cache);
  if (outcome == GJK_OUTCOME_LIMIT) {
    report_bounds(it, out);
    return GJK_ERROR_ITERATION_LIMIT;
  }
  gjk_penetration_result overlapping;
  int64_t plane = 0;
  if (outcome == GJK_OUTCOME_NEAREST) {
    plane = plane_of(it, &overlapping.normal);
    if (!gjk_convex_radii_touch(it, plane)) {
      out->iterations = it->iterations;
      gjk_distance_report(it, outcome, NULL, out);
      return GJK_OK;
    }
  }
  //@ assert it->shift >= 0;
  const gjk_status measured = report_depth(&o, outcome, plane, workspace, &overlapping);
  report_signed(&overlapping, out);
  return measured;
}
