// The witness points, by the weights of the feature's vertices.
#include "gjk2_witness.h"

// One coordinate of u + weight (v - u), weight in Q31, moved by convex_radius along the normal; rounded once.
//   u, v      at most 2^28:        weight (v - u) at most 2^60
//   normal    at most 2^30 + 2:    times twice the convex radius at most 2^59 + 2^30
static inline int32_t plane_offset(int32_t u, int32_t v, int32_t weight, gjk_q30 normal, gjk_q16 convex_radius) {
  const int64_t sum = gjk_mac32(INT64_C(1) << 30, v - u, weight);
  return u + (int32_t)gjk_sar64(gjk_mac32(sum, normal, 2 * convex_radius), 31);
}

// A point of one shape. toward: 1 for A, which the normal leads away from, -1 for B. Returns whether it has saturated.
GJK_ONCE static bool report_point(const gjk2_collider *c, gjk2_vec p, const gjk2_vec *q, int32_t weight,
                                  const gjk2_unit *normal, int toward, gjk2_vec *point) {
  bool saturated = false;
  const gjk_q16 convex_radius = toward * c->shape->convex_radius;
  if (p.x != q->x || p.y != q->y || convex_radius != 0) {
    p.x = plane_offset(p.x, q->x, weight, normal->x, convex_radius);
    p.y = plane_offset(p.y, q->y, weight, normal->y, convex_radius);
  }
  point->x = gjk_saturate_noting((int64_t)c->centre.x + p.x, &saturated);
  point->y = gjk_saturate_noting((int64_t)c->centre.y + p.y, &saturated);
  return saturated;
}

bool gjk2_witness_points(const gjk2_search *s, const gjk2_vertex *p, const gjk2_vertex *q, const gjk2_length *length,
                         const gjk2_unit *normal, gjk2_vec *point_a, gjk2_vec *point_b) {
  int32_t weight = 0;  // of q
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && q != NULL) {
    const int64_t part = gjk2_dot(p->w, gjk2_sub(p->w, q->w)), whole = (int64_t)length->squared;
    weight = gjk2_weight(length, whole >> (2 * GJK2_FINE_LENGTH) != 0, part < whole ? part : whole);
  } else {
    q = p;
  }
  const bool saturated = report_point(s->a, p->a.offset, &q->a.offset, weight, normal, 1, point_a);
  return report_point(s->b, p->b.offset, &q->b.offset, weight, normal, -1, point_b) || saturated;
}
