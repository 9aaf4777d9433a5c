// Products of directions and vertices truncated to 32 bits: a filter for cores without a long multiplication.
//
// A 32-bit product costs a fifth of a 64-bit one there. The truncated product tells the exact one to within
// GJK_COARSE_ERROR:
//
//   v = 2^vertex_shift vc + r,  0 <= r < 2^vertex_shift,  |vc| <= 2^13     per component
//   d = 2^shift dc + q,         0 <= q < 2^shift,         |dc| <= 2^15     per component
//
//   v . d / 2^(vertex_shift + shift) - vc . dc
//     = vc . q / 2^shift                                  |...| <= 3 2^13
//     + r . d / 2^(vertex_shift + shift)                  |...| <= 3 2^15
//   |vc . dc| <= 3 2^28
#ifndef GJK_SRC_COARSE_H
#define GJK_SRC_COARSE_H

#include "gjk_vector.h"

#define GJK_COARSE_ERROR (3 * INT32_C(8192) + 3 * INT32_C(32768))

// A truncated direction, and how many bits direction and vertices lose.
typedef struct gjk_coarse {
  int32_t x, y, z;
  unsigned vertex_shift, shift;
} gjk_coarse;

// For vertices with components of at most 2^bits in size, 1 <= bits <= 31. Pre: d != 0.
static inline gjk_coarse gjk_coarse_direction(const gjk_vec3 *d, unsigned bits) {
  const uint32_t size = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);
  const unsigned d_bits = !GJK_SMALL && size >> 29 == 1 ? 30 : 32 - gjk_clz32(size);  // mostly 30
  const unsigned vertex_shift = bits > 13 ? bits - 13 : 0, shift = d_bits > 15 ? d_bits - 15 : 0;
  const gjk_coarse coarse = {gjk_sar32(d->x, shift), gjk_sar32(d->y, shift), gjk_sar32(d->z, shift), vertex_shift,
                             shift};
  return coarse;
}

// vc . dc
static inline int32_t gjk_coarse_dot(const gjk_coarse *c, const gjk_vec3 *v) {
  const unsigned shift = c->vertex_shift;
  const int32_t x = gjk_sar32(v->x, shift), y = gjk_sar32(v->y, shift), z = gjk_sar32(v->z, shift);
  //@ assert x >= -8192 && x <= 8192 && y >= -8192 && y <= 8192 && z >= -8192 && z <= 8192;
  //@ assert c->x >= -32768 && c->x <= 32768 && c->y >= -32768 && c->y <= 32768 && c->z >= -32768 && c->z <= 32768;
  return x * c->x + y * c->y + z * c->z;
}

#endif
