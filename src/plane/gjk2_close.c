// The nearest feature of points, segments and boxes with two half axes in all, without a search.
//
// A point has no half axis, a segment one, a box two. With two in all, x and y, A - B is the parallelogram
// centre + s x + t y with s and t from -1 to 1. u leads from its centre to the origin O. Signs alone find the feature:
//
//   1. Flip x and y so that u = alpha x + beta y with alpha and beta at least 0. Both at most 1: O lies within.
//   2. alpha > 1: O lies beyond the edge at x. Where its foot is inside the edge, that is the nearest feature. Where the foot
//      is beyond the end x - y, that corner is nearest: distances rise from there along the edges that O sees.
//   3. beta > 1: the same of the edge at y. What is left is the corner x + y.
//   4. Where x and y are parallel, or one is 0, A - B is the segment centre +- z: its inside, or an end.
//
// The feature is canonical as it is (gjk2_canonical.h): edges of a parallelogram are whole, and so is the segment.
//   |u| <= 2^30, |x|, |y| < 2^28:  sums of them below 3 2^29, products below 2^60
#include "gjk2_close.h"

#include "gjk2_outward.h"
#include "gjk2_search.h"
#include "gjk2_witness.h"

// The half axes of both shapes, those of A first, and the feature.
typedef struct close_pair {
  gjk2_vec delta;  // centre_a - centre_b
  gjk2_vec x, y;
  unsigned of_a;  // how many half axes are A's
  // The feature: the corner with these signs, or the edge from there to the corner whose signs differ as told.
  bool minus_x, minus_y, x_differs, y_differs;
  gjk2_vec w;     // of the corner
  gjk2_vec edge;  // to the other one, O on its right
  gjk2_vec d;     // from the feature to O
  int64_t base;   // d . w
} close_pair;

static inline gjk2_vec turned(gjk2_vec v, bool minus) {
  const gjk2_vec signed_v = {minus ? -v.x : v.x, minus ? -v.y : v.y};
  return signed_v;
}

// Makes a corner the feature.
static inline gjk2_outcome take_corner(close_pair *of, bool minus_x, bool minus_y) {
  const gjk2_vec x = turned(of->x, minus_x), y = turned(of->y, minus_y);
  of->minus_x = minus_x;
  of->minus_y = minus_y;
  of->x_differs = false;
  of->y_differs = false;
  of->w.x = of->delta.x + x.x + y.x;
  of->w.y = of->delta.y + x.y + y.y;
  of->edge.x = 0;
  of->edge.y = 0;
  of->d = gjk2_negate(of->w);
  of->base = -gjk2_dot(of->w, of->w);
  return of->base != 0 ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_ENCLOSING;
}

// Makes the edge from a corner to the one with other signs the feature, or the edge back.
static inline gjk2_outcome take_edge(close_pair *of, bool minus_x, bool minus_y, bool x_differs, bool y_differs) {
  const gjk2_vec x = turned(of->x, minus_x), y = turned(of->y, minus_y);
  gjk2_vec edge = {-2 * ((x_differs ? x.x : 0) + (y_differs ? y.x : 0)),
                   -2 * ((x_differs ? x.y : 0) + (y_differs ? y.y : 0))};
  gjk2_vec w = {of->delta.x + x.x + y.x, of->delta.y + x.y + y.y};
  int64_t base = gjk2_cross(w, edge);
  of->minus_x = minus_x;
  of->minus_y = minus_y;
  of->x_differs = x_differs;
  of->y_differs = y_differs;
  if (base > 0) {
    of->minus_x = minus_x != x_differs;
    of->minus_y = minus_y != y_differs;
    w.x += edge.x;
    w.y += edge.y;
    edge = gjk2_negate(edge);
    base = -base;
  }
  of->w = w;
  of->edge = edge;
  of->d.x = edge.y;
  of->d.y = -edge.x;
  of->base = base;
  return base != 0 ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_ENCLOSING;
}

// Step 4
static gjk2_outcome close_segment(close_pair *of) {
  const gjk2_vec x = of->x, y = of->y, u = gjk2_negate(of->delta);
  const bool opposite = gjk2_dot(x, y) < 0;
  const gjk2_vec z = opposite ? gjk2_sub(x, y) : gjk2_add(x, y);
  const int64_t along = gjk2_dot(u, z), most = gjk2_dot(z, z);
  if (along < most && along > -most) {
    return take_edge(of, false, opposite, true, true);
  }
  return take_corner(of, along < 0, (along < 0) != opposite);
}

// Steps 1 to 4. LIMIT: O lies within, or the shapes have other cores.
GJK_ONCE static gjk2_outcome find_closest(const gjk2_collider *a, const gjk2_collider *b, close_pair *of) {
  // Counts are 1, 2 and 4, but for curved shapes, triangles and polygons.
  if (((1u << (a->count & 7u) | 1u << (b->count & 7u)) & ~0x16u) != 0 || a->count + b->count > 5 ||
      a->shape->type->buffered || b->shape->type->buffered) {
    return GJK2_OUTCOME_LIMIT;
  }
  of->delta = gjk2_sub(a->centre, b->centre);
  of->of_a = a->count >> 1;
  of->x = of->of_a > 0 ? a->frame[0] : b->frame[0];
  of->y = of->of_a > 1 ? a->frame[1] : b->frame[1 - of->of_a];
  const gjk2_vec x = of->x, y = of->y, u = gjk2_negate(of->delta);
  const int64_t area = gjk2_cross(x, y);
  if (area == 0) {
    return close_segment(of);
  }
  // Step 1
  const int64_t alpha = gjk2_cross(u, y), beta = gjk2_cross(x, u);
  const bool minus_x = (alpha < 0) != (area < 0), minus_y = (beta < 0) != (area < 0);
  const uint64_t size = gjk_magnitude64(area);
  const bool beyond_x = gjk_magnitude64(alpha) > size, beyond_y = gjk_magnitude64(beta) > size;
  const gjk2_vec px = turned(x, minus_x), py = turned(y, minus_y);
  if (beyond_x) {  // Step 2
    const int64_t along = gjk2_dot(gjk2_sub(u, px), py), most = gjk2_dot(y, y);
    if (along < most && along > -most) {
      return take_edge(of, minus_x, minus_y, false, true);
    }
    if (along < 0) {
      return take_corner(of, minus_x, !minus_y);
    }
  }
  if (beyond_y) {  // Step 3
    const int64_t along = gjk2_dot(gjk2_sub(u, py), px), most = gjk2_dot(x, x);
    if (along < most && along > -most) {
      return take_edge(of, minus_x, minus_y, true, false);
    }
    if (along < 0) {
      return take_corner(of, !minus_x, minus_y);
    }
  }
  return beyond_x || beyond_y ? take_corner(of, minus_x, minus_y) : GJK2_OUTCOME_LIMIT;
}

// The corner of each shape with these signs.
static inline void set_corners(const gjk2_collider *a, const gjk2_collider *b, const close_pair *of, bool minus_x,
                               bool minus_y, gjk2_support *of_a, gjk2_support *of_b) {
  const gjk2_vec x = turned(of->x, minus_x), y = turned(of->y, minus_y);
  const unsigned plus = (minus_x ? 0u : 1u) | (minus_y ? 0u : 2u), n = of->of_a;
  of_a->offset.x = (n > 0 ? x.x : 0) + (n > 1 ? y.x : 0);
  of_a->offset.y = (n > 0 ? x.y : 0) + (n > 1 ? y.y : 0);
  of_b->offset.x = -((n > 0 ? 0 : x.x) + (n > 1 ? 0 : y.x));
  of_b->offset.y = -((n > 0 ? 0 : x.y) + (n > 1 ? 0 : y.y));
  of_a->vertex = (uint16_t)(plus & (a->count - 1u));
  of_b->vertex = (uint16_t)(~plus >> n & (b->count - 1u));
}

gjk2_outcome gjk2_close_axes(gjk2_search *s) {
  close_pair of;
  const gjk2_outcome outcome = find_closest(s->a, s->b, &of);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    return outcome;
  }
  const bool edge = of.x_differs || of.y_differs;
  gjk2_vertex *p = edge ? s->first : s->apex, *q = s->last;
  s->count = edge ? 2 : 1;
  s->alone = !edge;
  s->d = of.d;
  s->base = of.base;
  gjk2_copy(&p->w, &of.w);
  set_corners(s->a, s->b, &of, of.minus_x, of.minus_y, &p->a, &p->b);
  if (edge) {
    q->w = gjk2_add(of.w, of.edge);
    set_corners(s->a, s->b, &of, of.minus_x != of.x_differs, of.minus_y != of.y_differs, &q->a, &q->b);
  }
  return outcome;
}

#if !GJK_SMALL
// The point of a shape on the feature, from its corner there, by the weight of the other end of its edge. toward: as of
// gjk2_witness_corner.
static inline void set_point(const gjk2_collider *c, gjk2_vec corner, gjk2_vec edge, int32_t weight,
                             const gjk2_unit *normal, int toward, gjk2_vec *point, bool *saturated) {
  const int64_t half = INT64_C(1) << 30;
  const gjk_q16 twice = 2 * toward * c->shape->convex_radius;  // bounds: plane_offset of gjk2_witness.c
  const int64_t x = gjk_mac32(gjk_mac32(half, edge.x, weight), normal->x, twice);
  const int64_t y = gjk_mac32(gjk_mac32(half, edge.y, weight), normal->y, twice);
  point->x = gjk_saturate_noting((int64_t)c->centre.x + corner.x + gjk_sar64(x, 31), saturated);
  point->y = gjk_saturate_noting((int64_t)c->centre.y + corner.y + gjk_sar64(y, 31), saturated);
}

// The points and the certificate.
static inline void set_touch(const gjk2_collider *a, const gjk2_collider *b, const close_pair *of,
                             const gjk2_length *length, const gjk2_unit *across, gjk2_touch *out) {
  gjk2_support of_a, of_b;
  gjk2_vec edge_a = {0, 0}, edge_b = {0, 0};
  int32_t weight = 0;
  set_corners(a, b, of, of->minus_x, of->minus_y, &of_a, &of_b);
  out->certificate.count = 1;
  out->certificate.a[0] = of_a.vertex;
  out->certificate.b[0] = of_b.vertex;
  if (of->x_differs || of->y_differs) {
    gjk2_support to_a, to_b;
    const int64_t part = -gjk2_dot(of->w, of->edge), whole = (int64_t)length->squared;
    weight = gjk2_weight(length, whole >> (2 * GJK2_FINE_LENGTH) != 0, part < whole ? part : whole);
    set_corners(a, b, of, of->minus_x != of->x_differs, of->minus_y != of->y_differs, &to_a, &to_b);
    edge_a = gjk2_sub(to_a.offset, of_a.offset);
    edge_b = gjk2_sub(to_b.offset, of_b.offset);
    out->certificate.count = 2;
    out->certificate.a[1] = to_a.vertex;
    out->certificate.b[1] = to_b.vertex;
  }
  out->saturated = false;
  set_point(a, of_a.offset, edge_a, weight, across, 1, &out->point_a, &out->saturated);
  set_point(b, of_b.offset, edge_b, weight, across, -1, &out->point_b, &out->saturated);
}

bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, gjk2_touch *out) {
  close_pair of;
  if (!gjk2_frame_is_near(a, b) || find_closest(a, b, &of) != GJK2_OUTCOME_NEAREST) {
    return false;
  }
  gjk2_length length;
  gjk2_unit across;
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  const uint64_t h = (uint64_t)-of.base;
  gjk2_inline_length(&length, of.d);
  gjk2_inline_unit(&across, &length, of.d);
  int32_t distance = (int32_t)gjk2_inline_distance(&length, GJK2_ROUND_DOWN, h) - radius;
  out->normal.x = across.x;
  out->normal.y = across.y;
  out->overlaps = radius > 0 && (distance < 0 || (distance == 0 && gjk2_is_within(-of.base, of.d, radius)));
  if (!out->overlaps) {
    distance = (int32_t)gjk2_inline_distance(&length, GJK2_ROUND_NEAREST, h) - radius;
  } else if (distance < 0 && !gjk2_outward_is_clear(of.d, of.base, radius, &length, -distance, &across)) {
    gjk2_outward_normal(of.d, of.base, radius, &length, -distance, &out->normal);
  }
  out->distance = distance;
  gjk2_copy(&out->certificate.direction, &of.d);
  out->certificate.proof = GJK2_PROOF_NEAREST;
  set_touch(a, b, &of, &length, &across, out);
  return true;
}
#endif
