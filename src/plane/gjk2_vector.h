// Vectors of the plane: exact sums, dot and cross products.
#ifndef GJK2_SRC_VECTOR_H
#define GJK2_SRC_VECTOR_H

#include "../arith/gjk_wide.h"
#include "gjk2/format.h"

// a + b. Pre: each component of the sum fits.
static inline gjk2_vec gjk2_add(gjk2_vec a, gjk2_vec b) {
  gjk2_vec sum = {a.x + b.x, a.y + b.y};
  return sum;
}

// a - b. Pre: each component of the difference is below 2^31 in size, so that gjk2_negate may take it.
static inline gjk2_vec gjk2_sub(gjk2_vec a, gjk2_vec b) {
  gjk2_vec difference = {a.x - b.x, a.y - b.y};
  return difference;
}

// -a. Pre: no component is INT32_MIN.
static inline gjk2_vec gjk2_negate(gjk2_vec a) {
  gjk2_vec opposite = {-a.x, -a.y};
  return opposite;
}

// a . b. Pre: |a| |b| < 2^63, lengths.
static inline int64_t gjk2_dot(gjk2_vec a, gjk2_vec b) {
  return gjk_mac32(gjk_mul32(a.x, b.x), a.y, b.y);
}

// a x b: positive where b lies to the left of a. Pre: as of gjk2_dot; a.y is not INT32_MIN.
static inline int64_t gjk2_cross(gjk2_vec a, gjk2_vec b) {
  return gjk_mac32(gjk_mul32(a.x, b.y), -a.y, b.x);
}

// |x| + |y|. Pre: at most 2^32 - 1.
static inline uint32_t gjk2_norm1(gjk2_vec v) {
  return gjk_magnitude32(v.x) + gjk_magnitude32(v.y);
}

// *to = *from. Copies of more than a word go by parts: GCC makes others calls of memcpy on ARMv6-M and RISC-V.
static inline void gjk2_copy(gjk2_vec *to, const gjk2_vec *from) {
  to->x = from->x;
  to->y = from->y;
}

static inline bool gjk2_equal(gjk2_vec a, gjk2_vec b) {
  return a.x == b.x && a.y == b.y;
}

// The outward normal of an edge that a counterclockwise hull has: the edge turned to the right.
static inline gjk2_vec gjk2_outward(gjk2_vec edge) {
  gjk2_vec normal = {edge.y, -edge.x};
  return normal;
}

#endif
