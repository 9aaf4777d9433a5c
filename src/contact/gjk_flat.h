// Two polygons seen along their direction, on a grid of 30 bits: filters for signs, and ways to crossings.
//
// The direction's longest component is d.m, along the axis m; the others follow it in turn, m + 1 and m + 2. A point p of the
// pair, relative to a corner o of A, stands at
//   u = d.m (p - o).(m + 1) - d.(m + 1) (p - o).m        v = the same for m + 2
// so moves along d do not change it. Both are shifted right to 29 bits, and u takes the sign of d.m. Then for edges and
// ways between points, with e x f for e.u f.v - e.v f.u:
//   e x f has the sign of direction . (e x f) in space, up to the rounding
#ifndef GJK_SRC_FLAT_H
#define GJK_SRC_FLAT_H

#include "gjk_contact_polygon.h"

// A point on the grid: components below 2^29 in size, each off by less than 1, downwards.
typedef struct gjk_flat_point {
  int32_t u, v;
} gjk_flat_point;

typedef struct gjk_flat {
  gjk_flat_point a[GJK_POLYGON_CORNERS], b[GJK_POLYGON_CORNERS];  // the corners of both polygons
  unsigned bits;                                                  // corners are less than 2^bits LSB apart per axis
  uint32_t size;                                                  // of d.m
} gjk_flat;

// An edge or a way to a corner: components below 2^30 in size, each off by less than 1.
static inline gjk_flat_point gjk_flat_way(const gjk_flat_point *from, const gjk_flat_point *to) {
  const gjk_flat_point way = {to->u - from->u, to->v - from->v};
  return way;
}

// e x f: below 2^61 in size.
static inline int64_t gjk_flat_cross(gjk_flat_point e, gjk_flat_point f) {
  return gjk_mul32(e.u, f.v) - gjk_mul32(e.v, f.u);
}

// |e.u| + |e.v|, below 2^31.
static inline uint32_t gjk_flat_length(gjk_flat_point e) {
  return gjk_magnitude32(e.u) + gjk_magnitude32(e.v);
}

// By how much e x f may be off, for any way f: less than |e.u| + |e.v| + |f.u| + |f.v| + 2.
static inline int64_t gjk_flat_error(gjk_flat_point e) {
  return (int64_t)gjk_flat_length(e) + (INT64_C(1) << 31) + 2;
}

// Puts both polygons on the grid. Pre: corners are less than 2^31 apart; a->direction is a unit vector.
void gjk_flat_set(gjk_flat *flat, const gjk_polygon *a, const gjk_polygon *b);

// A length of near LSB, at a right angle to the direction, on the grid. Pre: near < 2^bits.
static inline uint32_t gjk_flat_near(const gjk_flat *flat, uint32_t near) {
  return (uint32_t)(gjk_umul32(near, flat->size) >> (flat->bits + 2));  // below 2^(bits + 30 - bits - 2)
}

#endif
