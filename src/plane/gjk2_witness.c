// The witness points, by the weights of the feature's vertices.
#include "gjk2_witness.h"

// Edges from this length on, in LSB, take weights that are right to the last bit: 2^-27 of 2^21 is 2^-6 LSB.
#define FINE_LENGTH 21

// One coordinate: core = u + weight (v - u) from the centre, in Q31, moved by convex_radius along the normal.
//   u, v      at most 2^28:        2^31 u and weight (v - u) at most 2^60
//   normal    at most 2^30 + 2:    times twice the convex radius at most 2^59 + 2^30
static gjk_q16 coordinate(int32_t u, int32_t v, int32_t weight, gjk_q16 centre, gjk_q30 normal, gjk_q16 convex_radius,
                          bool *saturated) {
  int64_t sum = gjk_shl64(2 * (int64_t)u + 1, 30);
  if (u != v) {
    sum = gjk_mac32(sum, v - u, weight);
  }
  if (convex_radius != 0) {
    sum = gjk_mac32(sum, normal, 2 * convex_radius);
  }
  return gjk_saturate_noting(centre + gjk_sar64(sum, 31), saturated);
}

// The vertex of B, from B's centre.
static gjk2_vec offset_of_b(const gjk2_search *s, const gjk2_vertex *v) {
  const gjk2_vec *a = &s->a->centre, *b = &s->b->centre;
  gjk2_vec offset;
  if (s->far == 0) {
    return gjk2_sub(gjk2_add(s->delta, v->of_a), v->w);
  }
  offset.x = (int32_t)((int64_t)a->x - b->x + v->of_a.x - gjk_shl64(v->w.x, s->far));
  offset.y = (int32_t)((int64_t)a->y - b->y + v->of_a.y - gjk_shl64(v->w.y, s->far));
  return offset;
}

void gjk2_witness_points(const gjk2_search *s, const gjk2_vertex *p, const gjk2_vertex *q, gjk2_unit normal,
                         gjk2_vec *point_a, gjk2_vec *point_b, bool *saturated) {
  int32_t weight = 0;  // of q
  const gjk2_vec pb = offset_of_b(s, p), pa = p->of_a;
  gjk2_vec qb = pb, qa = pa;
  if (q != NULL) {
    gjk2_length length;
    const gjk2_vec edge = gjk2_sub(q->w, p->w);
    gjk2_length_set(&length, edge);
    const int64_t part = -gjk2_dot(p->w, edge), whole = (int64_t)length.squared;
    weight = gjk2_weight(&length, part < whole ? part : whole, whole >> (2 * FINE_LENGTH) != 0);
    qb = offset_of_b(s, q);
    qa = q->of_a;
  }
  const gjk_q16 ra = s->a->shape->convex_radius, rb = s->b->shape->convex_radius;
  point_a->x = coordinate(pa.x, qa.x, weight, s->a->centre.x, normal.x, ra, saturated);
  point_a->y = coordinate(pa.y, qa.y, weight, s->a->centre.y, normal.y, ra, saturated);
  point_b->x = coordinate(pb.x, qb.x, weight, s->b->centre.x, normal.x, -rb, saturated);
  point_b->y = coordinate(pb.y, qb.y, weight, s->b->centre.y, normal.y, -rb, saturated);
}
