// The witness points, by the weights of the feature's vertices.
#include "gjk2_witness.h"

// Edges from this length on, in LSB, take weights that are right to the last bit: 2^-27 of 2^21 is 2^-6 LSB.
#define FINE_LENGTH 21

// One coordinate: core = u + weight (v - u) from the centre, weight in Q31, moved by convex_radius along the normal.
//   u, v      at most 2^28:        weight (v - u) at most 2^60
//   normal    at most 2^30 + 2:    times twice the convex radius at most 2^59 + 2^30
static inline gjk_q16 plane_coordinate(int32_t u, int32_t v, int32_t weight, gjk_q16 centre, gjk_q30 normal,
                                       gjk_q16 convex_radius, bool *saturated) {
  const int64_t half = INT64_C(1) << 30;
  int32_t offset = u;
  if (u != v || convex_radius != 0) {
    const int64_t sum = gjk_mac32(half, v - u, weight);
    offset += (int32_t)gjk_sar64(gjk_mac32(sum, normal, 2 * convex_radius), 31);
  }
  return gjk_saturate_noting((int64_t)centre + offset, saturated);
}

// A point of one shape. toward: 1 for A, which the normal leads away from, -1 for B.
GJK_ONCE static void report_point(const gjk2_collider *c, const gjk2_vec *p, const gjk2_vec *q, int32_t weight,
                                  const gjk2_unit *normal, int toward, gjk2_vec *point, bool *saturated) {
  const gjk_q16 convex_radius = toward * c->shape->convex_radius;
  point->x = plane_coordinate(p->x, q->x, weight, c->centre.x, normal->x, convex_radius, saturated);
  point->y = plane_coordinate(p->y, q->y, weight, c->centre.y, normal->y, convex_radius, saturated);
}

void gjk2_witness_points(const gjk2_search *s, const gjk2_vertex *p, const gjk2_vertex *q, const gjk2_length *length,
                         const gjk2_unit *normal, gjk2_vec *point_a, gjk2_vec *point_b, bool *saturated) {
  int32_t weight = 0;  // of q
  if (q != NULL) {
    const int64_t part = gjk2_dot(p->w, gjk2_sub(p->w, q->w)), whole = (int64_t)length->squared;
    weight = gjk2_weight(length, part < whole ? part : whole, whole >> (2 * FINE_LENGTH) != 0);
  } else {
    q = p;
  }
  report_point(s->a, &p->of_a, &q->of_a, weight, normal, 1, point_a, saturated);
  report_point(s->b, &p->of_b, &q->of_b, weight, normal, -1, point_b, saturated);
}
