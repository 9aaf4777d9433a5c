// The nearest feature of two cores that are apart, and all that follows from it, where registers hold 64 bits.
//
// Distance, normal and points have the same roundings as elsewhere (gjk2_distance.c, gjk2_meeting.c). Coordinates are scalars
// of 64 bits: GCC makes vectors of pairs, which costs more than it saves.
#ifndef GJK2_SRC_FEATURE_H
#define GJK2_SRC_FEATURE_H

#include "gjk2/distance.h"
#include "gjk2_close.h"
#include "gjk2_outward.h"
#include "gjk2_witness.h"

#if GJK_64_BIT && !GJK_SMALL

// A vertex of A - B, or an edge from there with the origin O on its right; frame as of gjk2_search.h, near.
typedef struct gjk2_feature {
  int64_t w_x, w_y;            // the vertex
  int64_t edge_x, edge_y;      // to the other one, or 0
  int64_t d_x, d_y;            // from the feature to O
  int64_t base;                // d . w, below 0
  int64_t a_x, a_y;            // of A's vertex, relative to its centre
  int64_t edge_a_x, edge_a_y;  // to the other one's, or 0
  bool is_edge;
} gjk2_feature;

// The point of a shape on the feature: from its vertex (x, y) there, by the weight of the other end of its edge, and moved by
// the convex radius. toward: 1 for A, which the normal leads away from, -1 for B. Bounds: plane_offset of gjk2_witness.c.
GJK_ONCE static bool feature_point(const gjk2_collider *c, int64_t x, int64_t y, int64_t edge_x, int64_t edge_y,
                                   int32_t weight, const gjk2_unit *normal, int toward, gjk2_vec *point) {
  const int64_t half = INT64_C(1) << 30, reach = INT64_C(1) << 31;
  const int64_t twice = 2 * toward * c->shape->convex_radius;
  x += gjk_sar64(half + edge_x * weight + normal->x * twice, 31);
  y += gjk_sar64(half + edge_y * weight + normal->y * twice, 31);
  point->x = (int32_t)x;
  point->y = (int32_t)y;
  if (((uint64_t)(x + reach) | (uint64_t)(y + reach)) >> 32 == 0) {
    return false;
  }
  point->x = gjk_saturate(x);
  point->y = gjk_saturate(y);
  return true;
}

// Both points. Returns whether one is saturated. circles: of two points.
GJK_ONCE static bool feature_points(const gjk2_collider *a, const gjk2_collider *b, const gjk2_feature *of,
                                    bool circles, const gjk2_length *length, const gjk2_unit *across,
                                    gjk2_distance_result *out) {
  int64_t a_x = a->centre.x, a_y = a->centre.y, b_x = b->centre.x, b_y = b->centre.y, w_x = 0, w_y = 0, e_x = 0,
          e_y = 0;
  int32_t weight = 0;
  if (!circles) {
    a_x += of->a_x;
    a_y += of->a_y;
    // What A's vertex is ahead of that of A - B, B's vertex is, from centre to centre.
    b_x = a_x - of->w_x;
    b_y = a_y - of->w_y;
    w_x = of->edge_a_x;
    w_y = of->edge_a_y;
    e_x = w_x - of->edge_x;
    e_y = w_y - of->edge_y;
    if (of->is_edge) {
      const int64_t part = -(of->w_x * of->edge_x + of->w_y * of->edge_y), whole = (int64_t)length->squared;
      weight = gjk2_weight(length, whole >> (2 * GJK2_FINE_LENGTH) != 0, part < whole ? part : whole);
    }
  }
  const bool saturated = feature_point(a, a_x, a_y, w_x, w_y, weight, across, 1, &out->point_a);
  return feature_point(b, b_x, b_y, e_x, e_y, weight, across, -1, &out->point_b) || saturated;
}

// gjk2_is_within of h and d, mostly by the leading bits of h / |d|.
static inline bool feature_touches(int64_t h, gjk2_vec d, int32_t radius, uint32_t leading, unsigned shift) {
  if (shift >= 38 && shift <= 62) {
    const int64_t beyond = (int64_t)leading - gjk_shl64(radius, shift - 32);  // off by less than 10
    if (beyond > 10 || beyond < -10) {
      return beyond < 0;
    }
  }
  return gjk2_is_within(h, d, radius);
}

// Where the cores are at most an LSB farther apart than the radius: whether they overlap, distance and normal. Returns
// whether points are asked for, too.
GJK_OUT_OF_LINE static bool feature_near(gjk2_vec d, int64_t base, int32_t radius, const gjk2_length *length,
                                         const gjk2_unit *across, unsigned parts, gjk2_distance_result *out) {
  unsigned shift;
  const uint32_t leading = (uint32_t)(gjk2_inline_quotient(length, &shift, (uint64_t)-base) >> 32);
  const bool overlaps = radius > 0 && feature_touches(-base, d, radius, leading, shift);
  const bool complete = (parts & (overlaps ? GJK2_TOUCH_DEPTH : GJK2_TOUCH_POINTS | GJK2_TOUCH_GAP)) != 0;
  out->intersecting = overlaps;
  out->certificate.proof = overlaps && !complete ? GJK2_PROOF_NEAR : GJK2_PROOF_NEAREST;
  if (!overlaps || complete) {
    out->normal.x = across->x;
    out->normal.y = across->y;
  }
  if (complete) {
    const gjk2_round_to to = overlaps ? GJK2_ROUND_DOWN : GJK2_ROUND_NEAREST;
    out->distance = (int32_t)gjk2_inline_rounded(length, to, (uint64_t)-base, leading, shift) - radius;
  }
  if (overlaps && out->distance < 0 && !gjk2_inline_exceeds(leading, shift, -out->distance)) {
    gjk2_outward_normal(d, base, radius, length, -out->distance, &out->normal);
  }
  return complete;
}

// What follows from the feature, but for the names of its vertices. circles: of two points, of which d and base alone are
// set.
GJK_ONCE static void gjk2_feature_measure(const gjk2_collider *a, const gjk2_collider *b, const gjk2_feature *of,
                                          bool circles, unsigned parts, gjk2_distance_result *out) {
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  const uint64_t h = (uint64_t)-of->base;
  const gjk2_vec d = {(int32_t)of->d_x, (int32_t)of->d_y};
  out->iterations = 1;
  out->certificate.direction.x = d.x;
  out->certificate.direction.y = d.y;
  out->certificate.count = !circles && of->is_edge ? 2 : 1;
  out->certificate.proof = GJK2_PROOF_NEAREST;
  if (parts == 0) {
    out->intersecting = radius > 0 && gjk2_is_within(-of->base, d, radius);
    return;
  }
  gjk2_length length;
  gjk2_unit across;
  unsigned shift;
  gjk2_quick_length(&length, d);
  gjk2_quick_unit(&across, &length, d);
  const uint32_t leading = (uint32_t)(gjk2_inline_quotient(&length, &shift, h) >> 32);
  const int32_t core = (int32_t)gjk2_inline_rounded(&length, GJK2_ROUND_NEAREST, h, leading, shift);
  bool points = (parts & GJK2_TOUCH_POINTS) != 0;
  if (core > radius) {
    out->intersecting = false;
    out->normal.x = across.x;
    out->normal.y = across.y;
    out->distance = core - radius;
  } else {
    out->distance = 0;
    points = feature_near(d, of->base, radius, &length, &across, parts, out) && parts != GJK2_TOUCH_GAP;
  }
  out->lower = out->distance;
  out->upper = out->distance;
  out->saturated = points && feature_points(a, b, of, circles, &length, &across, out) && !out->intersecting;
}

#endif

#endif
