// Casts and rays.
//
//   1. Check the way. The bounding spheres do not meet on it: miss.
//   2. Find where the line of the way enters A - B (gjk_portal.h), exactly.
//   3. Report a hit: the fraction is a quotient of integers, and so is each coordinate of a resting place.
//   4. With a convex radius or a margin, or a curved shape: bracket the fraction, which nearly always decides as well
//      (gjk_advance.h). A way that grazes is decided exactly, by the shape that B sweeps (gjk_swept.h).
//
// What is rounded, of shapes without radius and margin:
//   fraction         down to 2^-30
//   rest_a           to the nearest LSB
//   rest_b           rest_a, and B's place relative to A's: away from A along an axis across which the plane lies at a slant,
//                    elsewhere to the nearest
//   points           to within 1 LSB
//   normal           to 2^-28
#include "gjk/cast.h"

#include "gjk/intersect.h"
#include "gjk_advance.h"
#include "gjk_cast_report.h"
#include "gjk_slab.h"
#include "gjk_spheres.h"
#include "gjk_swept.h"

static void report_miss(gjk_cast_result *out, gjk_cast_proof proof, uint8_t iterations) {
  out->hit = false;
  out->iterations = iterations;
  out->certificate.proof = (uint8_t)proof;
  out->certificate.count = 0;
}

// Iterations of two searches, as far as the result can tell them.
static uint8_t add_iterations(uint8_t first, uint8_t second) {
  return first + second < UINT8_MAX ? (uint8_t)(first + second) : UINT8_MAX;
}

// Steps 2 and 3: shapes without radius and margin. Out of line, as step 4: one of their frames on the stack at a time.
// slabs: a box and a point, whose spheres have not been asked yet.
GJK_OUT_OF_LINE static gjk_status cast_polytopes(const gjk_collider *a, const gjk_collider *b, const gjk_way *way,
                                                 bool slabs, gjk_cast_result *out) {
  gjk_portal p;
  gjk_passage passage = slabs ? gjk_slab_find(&p, a, b, way) : GJK_PASSAGE_LIMIT;
  if (passage == GJK_PASSAGE_LIMIT) {
    if (slabs && gjk_spheres_part(a, b, way, 0)) {
      report_miss(out, GJK_CAST_PROOF_SPHERES, 0);
      return GJK_OK;
    }
    passage = gjk_portal_find(&p, a, b, way);
  }
  out->iterations = p.iterations;
  if (passage == GJK_PASSAGE_LIMIT) {
    // Nothing is proven but that no contact is before the start.
    gjk_cast_report_start(a, b, out);
    out->hit = false;
    out->inside = false;
    gjk_set(&a->centre, &out->point_a);
    gjk_set(&b->centre, &out->point_b);
    out->certificate.proof = GJK_CAST_PROOF_NONE;
    return GJK_ERROR_ITERATION_LIMIT;
  }
  if (passage == GJK_PASSAGE_FACET) {
    gjk_cast_report_entry(&p, way, out);
  } else if (passage == GJK_PASSAGE_INSIDE) {
    gjk_cast_report_start(a, b, out);
  } else if (passage == GJK_PASSAGE_SHORT) {
    report_miss(out, GJK_CAST_PROOF_SHORT, p.iterations);
    gjk_cast_name_plane(&p, &out->certificate);
  } else {
    report_miss(out, GJK_CAST_PROOF_BESIDE, p.iterations);
    out->certificate.direction = p.g;
  }
  return GJK_OK;
}

// Do two polytopes come within the margin of each other on the way? Exact where the way can be swept; where it can't, a
// way that may is taken for one that does.
GJK_OUT_OF_LINE static bool comes_within(const gjk_collider *a, const gjk_collider *b, const gjk_way *way,
                                         gjk_q16 margin, gjk_cast_result *out) {
  gjk_swept swept;
  gjk_decision decision;
  if (!gjk_swept_set(&swept, a, b, way)) {
    return true;
  }
  gjk_within(&swept.still, &swept.swept, margin, NULL, &decision);
  out->iterations = add_iterations(out->iterations, decision.iterations);
  return decision.yes;
}

// Are two polytopes within the margin at the start?
GJK_OUT_OF_LINE static bool starts_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin,
                                          gjk_cast_result *out) {
  gjk_decision decision;
  gjk_within(a, b, margin, NULL, &decision);
  out->iterations = add_iterations(out->iterations, decision.iterations);
  return decision.yes;
}

// Step 4: shapes with a convex radius or a margin, and curved ones.
GJK_OUT_OF_LINE static gjk_status cast_rounded(const gjk_collider *a, const gjk_collider *b, const gjk_way *way,
                                               gjk_q16 margin, gjk_cast_result *out) {
  const bool curved = gjk_is_curved(a->shape) || gjk_is_curved(b->shape);
  const uint8_t proof = curved ? GJK_CAST_PROOF_NONE : GJK_CAST_PROOF_SWEPT;
  gjk_advance_answer answer = gjk_advance(a, b, way, margin, out);
  if (answer == GJK_ADVANCE_START) {
    answer = starts_within(a, b, margin, out) ? GJK_ADVANCE_INSIDE : GJK_ADVANCE_OPEN;
  }
  if (answer == GJK_ADVANCE_INSIDE) {
    gjk_cast_report_start(a, b, out);
    out->certificate.proof = curved ? GJK_CAST_PROOF_NONE : GJK_CAST_PROOF_INSIDE;
    return GJK_OK;
  }
  out->hit = answer == GJK_ADVANCE_HIT || (answer == GJK_ADVANCE_OPEN && comes_within(a, b, way, margin, out));
  out->certificate.proof = proof;
  out->certificate.count = 0;
  return answer == GJK_ADVANCE_LIMIT ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

gjk_status gjk_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  gjk_way way;
  gjk_status status = gjk_check_pair(a, b, out);
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return GJK_ERROR_UNSUPPORTED;  // a point on its way is a segment
  }
  if (status == GJK_OK) {
    status = gjk_way_set(&way, a, b, path);
  }
  if (status != GJK_OK) {
    return status;
  }
  // Convex radii are below 2^28 each, the margin is below 2^31.
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + path->margin;
  const bool slabs = radius == 0 && gjk_slab_may_find(a, b);  // a short way, which comes before the spheres
  if (!slabs && gjk_spheres_part(a, b, &way, radius)) {
    report_miss(out, GJK_CAST_PROOF_SPHERES, 0);
    return GJK_OK;
  }
  if (radius > 0 || gjk_is_curved(a->shape) || gjk_is_curved(b->shape)) {
    return cast_rounded(a, b, &way, path->margin, out);
  }
  return cast_polytopes(a, b, &way, slabs, out);
}

// The core radius of a posed point: what gjk_collider_init adds for rounding.
#define POINT_RADIUS 4

// A point at a place: what gjk_collider_init and gjk_collider_pose make of it.
static void place_as_point(gjk_collider *c, const gjk_shape *shape, const gjk_vec3 *at) {
  const gjk_vec3 origin = {0, 0, 0};
  c->shape = shape;
  c->buffer = NULL;
  c->position = *at;
  c->centre = *at;
  c->local_centre = origin;
  for (int i = 0; i < 3; i++) {
    c->frame[i] = origin;
    c->fraction[i] = 0;
  }
  c->core_radius = POINT_RADIUS;
  c->radius = POINT_RADIUS;
  c->bits = 3;
  c->count = 0;
  c->state = GJK_STATE_POSED;
}

gjk_status gjk_cast_ray(const gjk_collider *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  static const gjk_shape point = GJK_POINT;
  gjk_collider b;
  if (from == NULL || to == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_cast_path path = {NULL, to, 0};
  place_as_point(&b, &point, from);
  return gjk_cast(a, &b, &path, out);
}
