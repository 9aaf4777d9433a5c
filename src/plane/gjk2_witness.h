// The witness points of the plane: where a feature of A - B is nearest to the origin, as a point on each shape.
#ifndef GJK2_SRC_WITNESS_H
#define GJK2_SRC_WITNESS_H

#include "gjk2_search.h"

// Edges from this length on, in LSB, take weights that are right to the last bit: 2^-27 of 2^21 is 2^-6 LSB.
#define GJK2_FINE_LENGTH 21

// The point nearest to the origin of the edge from p to q, or p itself where q is NULL, as a point of each core, moved
// by the convex radius along the normal (A) and against it (B) and then rounded once. World frame. Returns
// whether a coordinate does not fit Q16.16 and is saturated. length: of the edge, or of a vector across it.
bool gjk2_witness_points(const gjk2_search *s, const gjk2_vertex *p, const gjk2_vertex *q, const gjk2_length *length,
                         const gjk2_unit *normal, gjk2_vec *point_a, gjk2_vec *point_b);

// A corner of a shape, moved by its convex radius along the normal: the point of a feature that is that corner. toward: 1
// for A, -1 for B.
static inline void gjk2_witness_corner(const gjk2_collider *c, gjk2_vec offset, const gjk2_unit *normal, int toward,
                                       gjk2_vec *point, bool *saturated) {
  const int64_t half = INT64_C(1) << 30;
  const gjk_q16 twice = 2 * toward * c->shape->convex_radius;  // times the normal at most 2^59 + 2^30
  const int32_t x = offset.x + (int32_t)gjk_sar64(gjk_mac32(half, normal->x, twice), 31);
  const int32_t y = offset.y + (int32_t)gjk_sar64(gjk_mac32(half, normal->y, twice), 31);
  point->x = gjk_saturate_noting((int64_t)c->centre.x + x, saturated);
  point->y = gjk_saturate_noting((int64_t)c->centre.y + y, saturated);
}

#endif
