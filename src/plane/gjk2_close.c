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
#include "gjk2_search.h"

// The half axes of both shapes, those of A first.
typedef struct axes_pair {
  gjk2_vec axis[2];
  unsigned of_a;  // how many are A's
} axes_pair;

// Sets a vertex of A - B by the signs of the half axes.
static void set_by_signs(const gjk2_search *s, const axes_pair *of, bool minus_x, bool minus_y, gjk2_vertex *out) {
  const gjk2_vec x = minus_x ? gjk2_negate(of->axis[0]) : of->axis[0];
  const gjk2_vec y = minus_y ? gjk2_negate(of->axis[1]) : of->axis[1];
  const unsigned plus = (minus_x ? 0u : 1u) | (minus_y ? 0u : 2u);
  gjk2_vec a = {0, 0}, b = {0, 0};
  out->w.x = s->delta.x + x.x + y.x;
  out->w.y = s->delta.y + x.y + y.y;
  if (of->of_a == 2) {
    a = gjk2_add(x, y);
  } else if (of->of_a == 1) {
    a = x;
    b = gjk2_negate(y);
  } else {
    b = gjk2_negate(gjk2_add(x, y));
  }
  gjk2_copy(&out->a.offset, &a);
  gjk2_copy(&out->b.offset, &b);
  out->a.vertex = (uint16_t)(plus & (s->a->count - 1u));
  out->b.vertex = (uint16_t)(~plus >> of->of_a & (s->b->count - 1u));
}

// Makes the one vertex of two points the feature.
static gjk2_outcome take_point(gjk2_search *s) {
  static const gjk2_support none = {{0, 0}, 0};
  gjk2_vertex *p = s->apex;
  gjk2_copy(&p->w, &s->delta);
  gjk2_copy_support(&p->a, &none);
  gjk2_copy_support(&p->b, &none);
  s->count = 1;
  s->alone = true;
  s->d = gjk2_negate(p->w);
  s->base = -gjk2_dot(p->w, p->w);
  return s->base != 0 ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_ENCLOSING;
}

// Makes the vertex with these signs the feature.
static gjk2_outcome take_vertex(gjk2_search *s, const axes_pair *of, bool minus_x, bool minus_y) {
  set_by_signs(s, of, minus_x, minus_y, s->apex);
  s->count = 1;
  s->alone = true;
  s->d = gjk2_negate(s->apex->w);
  s->base = -gjk2_dot(s->d, s->d);
  return s->base != 0 ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_ENCLOSING;
}

// Makes the edge between two vertices, whose signs differ as told, the feature.
GJK_ONCE static gjk2_outcome take_edge(gjk2_search *s, const axes_pair *of, bool minus_x, bool minus_y, bool x_differs,
                                       bool y_differs) {
  gjk2_vertex *p = s->first, *q = s->last;
  set_by_signs(s, of, minus_x, minus_y, p);
  set_by_signs(s, of, minus_x != x_differs, minus_y != y_differs, q);
  int64_t base = gjk2_cross(p->w, q->w);
  if (base > 0) {
    s->first = q;
    s->last = p;
    q = p;
    p = s->first;
    base = -base;
  }
  s->base = base;
  s->count = 2;
  s->d.x = q->w.y - p->w.y;
  s->d.y = p->w.x - q->w.x;
  return base != 0 ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_ENCLOSING;
}

// Step 4
static gjk2_outcome close_segment(gjk2_search *s, const axes_pair *of) {
  const gjk2_vec x = of->axis[0], y = of->axis[1], u = gjk2_negate(s->delta);
  const bool opposite = gjk2_dot(x, y) < 0;
  const gjk2_vec z = opposite ? gjk2_sub(x, y) : gjk2_add(x, y);
  const int64_t along = gjk2_dot(u, z), most = gjk2_dot(z, z);
  if (along < most && along > -most) {
    return take_edge(s, of, false, opposite, true, true);
  }
  return take_vertex(s, of, along < 0, (along < 0) != opposite);
}

gjk2_outcome gjk2_close_axes(gjk2_search *s) {
  const gjk2_collider *a = s->a, *b = s->b;
  // Counts are 1, 2 and 4, but for curved shapes, triangles and polygons; those without area have no order either.
  if (((1u << (a->count & 7u) | 1u << (b->count & 7u)) & ~0x16u) != 0 || a->count + b->count > 5 ||
      a->shape->type->buffered || b->shape->type->buffered) {
    return GJK2_OUTCOME_LIMIT;
  }
  if (a->count + b->count == 2) {
    return take_point(s);
  }
  axes_pair of;
  of.of_a = a->count >> 1;
  of.axis[0] = of.of_a > 0 ? a->frame[0] : b->frame[0];
  of.axis[1] = of.of_a > 1 ? a->frame[1] : b->frame[1 - of.of_a];
  const gjk2_vec x = of.axis[0], y = of.axis[1], u = gjk2_negate(s->delta);
  const int64_t area = gjk2_cross(x, y);
  if (area == 0) {
    return close_segment(s, &of);
  }
  // Step 1
  const int64_t alpha = gjk2_cross(u, y), beta = gjk2_cross(x, u);
  const bool minus_x = (alpha < 0) != (area < 0), minus_y = (beta < 0) != (area < 0);
  const uint64_t size = gjk_magnitude64(area);
  const bool beyond_x = gjk_magnitude64(alpha) > size, beyond_y = gjk_magnitude64(beta) > size;
  const gjk2_vec px = minus_x ? gjk2_negate(x) : x, py = minus_y ? gjk2_negate(y) : y;
  if (beyond_x) {  // Step 2
    const int64_t along = gjk2_dot(gjk2_sub(u, px), py), most = gjk2_dot(y, y);
    if (along < most && along > -most) {
      return take_edge(s, &of, minus_x, minus_y, false, true);
    }
    if (along < 0) {
      return take_vertex(s, &of, minus_x, !minus_y);
    }
  }
  if (beyond_y) {  // Step 3
    const int64_t along = gjk2_dot(gjk2_sub(u, py), px), most = gjk2_dot(x, x);
    if (along < most && along > -most) {
      return take_edge(s, &of, minus_x, minus_y, true, false);
    }
    if (along < 0) {
      return take_vertex(s, &of, !minus_x, minus_y);
    }
  }
  return beyond_x || beyond_y ? take_vertex(s, &of, minus_x, minus_y) : GJK2_OUTCOME_LIMIT;
}
