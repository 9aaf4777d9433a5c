// The penetration and the signed distance queries.
//
//   1. Find out how the cores lie: points, segments and boxes by separating axes, which also give the nearest facet;
//      others by GJK.
//   2. Cores apart, by less than the convex radii: the depth is the radii less that distance.
//   3. Cores that intersect: the depth is the radii plus the height of the facet of A - B nearest to the origin, from
//      step 1 or by EPA.
//   4. Find the point of each shape on that feature, and name its vertices in the certificate.
//   5. Round the normal outwards (gjk_outward.h).
//
// What is rounded:
//   posing   only there is geometry rounded; from then on shapes are integers
//   depth    up to the next LSB: step 2 rounds the distance of the cores down, step 3 the height up, both exactly. The
//            bounds of a curved pair are 2 LSB above the depth and 3 below, for the error of its support points
//   points   per component to the nearest LSB, within 1 LSB of the shape
//   normal   within 2^-28, then outward
#include "gjk/penetration.h"

#include "../arith/gjk_unit.h"
#include "../depth/gjk_box_heights.h"
#include "../depth/gjk_box_sat.h"
#include "../depth/gjk_epa.h"
#include "../gjk/gjk_search.h"
#include "../gjk/gjk_witness.h"
#include "gjk_distance.h"
#include "gjk_outward.h"

size_t gjk_workspace_bytes(uint16_t vertices) {
  return vertices < 4 ? 0 : GJK_EPA_CELLS((size_t)vertices) * sizeof(gjk_epa_cell);
}

// An overlap while it is being measured.
typedef struct overlap {
  gjk_iteration it;
  gjk_facet facet;  // of the cores, when they intersect
  gjk_q16 lower;    // bounds of the cores' depth, or of minus their distance; without the convex radii
  gjk_q16 upper;
  uint16_t iterations;  // support scans of all steps
  uint8_t proof;        // a gjk_proof
  bool points;          // are points and a certificate asked for?
} overlap;

// A build for size always finds the points.
static bool has_points(const overlap *o) {
  return GJK_SMALL || o->points;
}

// Step 3. Pre: the origin lies in the simplex, or the facet is found.
static gjk_status measure_cores(overlap *o, const gjk_workspace *workspace) {
  gjk_iteration *it = &o->it;
  gjk_facet *facet = &o->facet;
  gjk_epa_outcome expansion = GJK_EPA_FACET;
  o->proof = GJK_PROOF_FACET;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && facet->found) {
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
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && has_points(o)) {
    gjk_facet_load(facet, it);
  }
  return expansion == GJK_EPA_FULL ? GJK_ERROR_CAPACITY : GJK_OK;
}

// Measures cores that are apart by plane in the frame, Q30: minus their distance, rounded up.
static void measure_gap(overlap *o, int64_t plane) {
  const gjk_iteration *it = &o->it;
  const gjk_q16 gap = (gjk_q16)gjk_feature_distance(it, plane, GJK_ROUND_DOWN);
  //@ assert gap >= 0 && gap <= INT32_C(1) << 30;
  o->proof = GJK_PROOF_NEAREST;
  o->upper = -gap + (gjk_pair_is_curved(it) ? GJK_CURVED_ERROR : 0);
  o->lower = -gap - (gjk_pair_is_curved(it) ? GJK_CURVED_ERROR + 1 : 0);
}

// Step 4: names the vertices of the feature, or of the facet.
static void certify(const overlap *o, gjk_certificate *out) {
  gjk_iteration_certify(&o->it, GJK_OUTCOME_NEAREST, out);
  if (gjk_pair_is_curved(&o->it)) {
    return;
  }
  out->proof = o->proof;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && o->proof == GJK_PROOF_FACET) {
    out->count = 3;
    for (int i = 0; i < 3; i++) {
      out->a[i] = o->facet.corner[i].a.vertex;
      out->b[i] = o->facet.corner[i].b;
    }
  }
}

// Steps 2 to 5. When the outcome is NEAREST, plane and out->normal are those of gjk_plane_of.
static gjk_status report_depth(overlap *o, gjk_outcome outcome, int64_t plane, const gjk_workspace *workspace,
                               gjk_penetration_result *out) {
  gjk_status status = GJK_OK;
  const gjk_q16 radii = (gjk_q16)gjk_convex_radii(&o->it);
  bool saturated;
  if (outcome == GJK_OUTCOME_NEAREST) {
    measure_gap(o, plane);
  } else {
    status = measure_cores(o, workspace);
    const bool facet = GJK_SHAPES >= GJK_SHAPES_ROUND && o->proof == GJK_PROOF_FACET;
    out->normal = facet ? o->facet.normal : gjk_unit(&o->it.direction.d);
  }
  out->intersecting = true;
  out->upper = o->upper + radii;
  out->lower = o->lower + radii > 0 ? o->lower + radii : 0;
  // The bounds of a curved pair leave room for the error of its supports. The depth is in the middle of that room.
  const gjk_q16 error = gjk_pair_is_curved(&o->it) && status == GJK_OK ? GJK_CURVED_ERROR : 0;
  out->depth = out->upper - error;
  out->iterations = o->iterations;
  // Step 4.
  if (has_points(o)) {
    gjk_witness_points(&o->it, &out->normal, &out->point_a, &out->point_b, &saturated);
    certify(o, &out->certificate);
  }
  if (status == GJK_ERROR_CAPACITY) {
    out->certificate.proof = GJK_PROOF_NONE;
  }
  if (!gjk_pair_is_curved(&o->it)) {
    // Step 5. The facet's plane decides only where the shapes have no convex radii.
    const gjk_facet *facet = o->proof == GJK_PROOF_FACET && radii == 0 ? &o->facet : NULL;
    gjk_outward_normal(&o->it, facet, status != GJK_ERROR_CAPACITY, out->depth, &out->normal);
  }
  return status;
}

// The search for what is reported. Boxes that lie face to face need no points where none are asked for.
static gjk_outcome search_pair(overlap *o, gjk_goal goal, const gjk_cache *cache) {
  gjk_iteration *it = &o->it;
  const gjk_outcome outcome = gjk_search_whole(it, goal, cache);
  const bool level = gjk_search_has_ties(it, goal, outcome);
  o->points = level ? gjk_search_canonical(it, has_points(o)) : true;
  return outcome;
}

// Searches from the cache, and once more from a cold start where the cores intersect: step 3 continues from that
// simplex, and may depend on the pair alone.
static gjk_outcome search_overlap(overlap *o, gjk_goal goal, const gjk_cache *cache) {
  gjk_iteration *it = &o->it;
  const gjk_outcome outcome = search_pair(o, goal, cache);
  o->iterations = it->iterations;
  if (GJK_SHAPES <= GJK_SHAPES_ROUND || outcome != GJK_OUTCOME_ENCLOSING || cache == NULL) {
    return outcome;
  }
  gjk_iteration_start(it, it->a, it->b, goal, gjk_convex_radii(it));
  const gjk_outcome cold = search_pair(o, goal, NULL);
  o->iterations = (uint16_t)(o->iterations + it->iterations);
  return cold;
}

// Are the cores of boxes likely to be apart? They are where the cache's last answer was a feature and no plane; and where
// there is a convex radius, unless a plane was the last answer.
static bool are_cores_apart(const overlap *o, gjk_goal goal, const gjk_cache *cache) {
  if (cache != NULL && cache->a[3] != 0) {
    return false;
  }
  const bool had_feature = cache != NULL && cache->count > 0 && cache->count < 4;
  return (had_feature && goal == GJK_GOAL_SIGNED) || gjk_convex_radii(&o->it) > 0;
}

// Keeps what the next query starts from. A feature leaves no plane.
static void keep_apart(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache) {
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && cache != NULL && outcome != GJK_OUTCOME_LIMIT) {
    gjk_iteration_keep(it, outcome, cache);
    cache->a[3] = outcome == GJK_OUTCOME_NEAREST ? 0 : cache->a[3];
  }
}

// Step 1. A cached tetrahedron is of no use: it contained the origin and likely still does, and then the search runs
// cold anyway.
static gjk_outcome start_overlap(overlap *o, gjk_goal goal, gjk_cache *cache) {
  gjk_iteration *it = &o->it;
  gjk_cache direction;
  const gjk_cache *from = !gjk_pair_is_curved(it) && cache != NULL && cache->count < 4 ? cache : NULL;
  o->facet.found = false;
  // Points and segments are always flat: the search alone tells how they lie.
  if (GJK_SHAPES <= GJK_SHAPES_ROUND || it->shift < 0 || (GJK_SHAPES >= GJK_SHAPES_POLYTOPES && !gjk_is_box_pair(it))) {
    o->points = true;
  } else {
    if (are_cores_apart(o, goal, cache)) {
      const bool points = o->points;
      const gjk_outcome outcome = search_pair(o, goal, from);
      if (outcome != GJK_OUTCOME_ENCLOSING) {
        o->iterations = it->iterations;
        keep_apart(it, outcome, cache);
        return outcome;
      }
      o->points = points;
      it->iterations = 0;
    }
    unsigned plane = cache != NULL && cache->a[3] > 0 ? cache->a[3] - 1u : GJK_BOX_PLANES;
    const gjk_box_sat_answer answer = gjk_box_sat(it, &plane, &o->points, &o->facet);
    if (answer == GJK_BOX_SAT_FACET) {
      if (cache != NULL) {
        // A feature has three pairs at most, so the plane takes the place of a fourth.
        cache->a[3] = (uint16_t)(plane + 1);
        cache->count = cache->count > 3 ? 3 : cache->count;
      }
      o->iterations = 0;
      return GJK_OUTCOME_ENCLOSING;
    }
    o->facet.found = false;
    gjk_simplex_clear(&it->simplex);
    if (answer == GJK_BOX_SAT_APART && (goal == GJK_GOAL_DEPTH || cache == NULL)) {
      // The search starts along the axis that separates the cores.
      gjk_iteration_keep(it, GJK_OUTCOME_SEPARATED, &direction);
      from = &direction;
    }
  }
  const gjk_outcome outcome = search_overlap(o, goal, from);
  keep_apart(it, outcome, cache);
  return outcome;
}

gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  overlap o;
  o.points = true;
  gjk_iteration *it = &o.it;
  if (!gjk_iteration_start(it, a, b, GJK_GOAL_DEPTH, (int64_t)a->shape->convex_radius + b->shape->convex_radius)) {
    out->intersecting = false;
    out->iterations = 0;
    out->certificate.proof = GJK_PROOF_SPHERES;
    out->certificate.count = 0;
    return GJK_OK;
  }
  const gjk_outcome outcome = start_overlap(&o, GJK_GOAL_DEPTH, cache);
  if (GJK_SHAPES >= GJK_SHAPES_ALL && outcome == GJK_OUTCOME_LIMIT) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  int64_t plane = 0;
  if (outcome == GJK_OUTCOME_NEAREST) {
    plane = gjk_plane_of(it, &out->normal);
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

// A depth as a distance: negative, its bounds exchanged. iterations stops counting at 255.
static void report_signed(const gjk_penetration_result *overlapping, bool points, gjk_distance_result *out) {
  out->distance = -overlapping->depth;
  out->lower = -overlapping->upper;
  out->upper = -overlapping->lower;
  out->normal = overlapping->normal;
  out->intersecting = true;
  out->saturated = false;
  out->iterations = (uint8_t)(overlapping->iterations < UINT8_MAX ? overlapping->iterations : UINT8_MAX);
  if (points) {
    out->point_a = overlapping->point_a;
    out->point_b = overlapping->point_b;
    out->certificate = overlapping->certificate;
  }
}

// The bounds of the distance, or of minus the depth, that the last iteration proves.
static void report_bounds(gjk_iteration *it, gjk_distance_result *out) {
  int64_t lower, upper;
  (void)gjk_distance_bounds(it, &lower, &upper);
  out->lower = gjk_saturate(lower);
  out->upper = gjk_saturate(upper);
  out->iterations = it->iterations;
}

gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out) {
  bool points = true;
  return gjk_signed_distance_along(a, b, cache, workspace, &points, out);
}

gjk_status gjk_signed_distance_along(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                                     const gjk_workspace *workspace, bool *points, gjk_distance_result *out) {
  const gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK) {
    return status;
  }
  overlap o;
  gjk_iteration *it = &o.it;
  o.points = *points;
  gjk_iteration_start(it, a, b, GJK_GOAL_SIGNED, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
  const gjk_outcome outcome = start_overlap(&o, GJK_GOAL_SIGNED, cache);
  *points = o.points;
  if (GJK_SHAPES >= GJK_SHAPES_ALL && outcome == GJK_OUTCOME_LIMIT) {
    report_bounds(it, out);
    return GJK_ERROR_ITERATION_LIMIT;
  }
  gjk_penetration_result overlapping;
  int64_t plane = 0;
  if (outcome == GJK_OUTCOME_NEAREST) {
    plane = gjk_plane_of(it, &overlapping.normal);
    if (!gjk_convex_radii_touch(it, plane)) {
      out->iterations = it->iterations;
      gjk_distance_report(it, outcome, has_points(&o), NULL, out);
      return GJK_OK;
    }
  }
  //@ assert it->shift >= 0;
  const gjk_status measured = report_depth(&o, outcome, plane, workspace, &overlapping);
  report_signed(&overlapping, has_points(&o), out);
  return measured;
}
