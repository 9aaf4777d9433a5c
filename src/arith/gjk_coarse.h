// Products cut to 32 bits, for cores without a long multiplication: there they cost a fifth of one of 64.
//
// With v = 2^s vc + r, d = 2^t dc + q, all 0 <= r < 2^s, 0 <= q < 2^t, |vc| <= 2^13, |dc| <= 2^15 per component:
//   v . d / 2^(s + t) - vc . dc = vc . q / 2^t + r . d / 2^(s + t)
// is at most 3 2^13 + 3 2^15 in size, and |vc . dc| <= 3 2^28.
#ifndef GJK_SRC_COARSE_H
#define GJK_SRC_COARSE_H

#include "gjk_vector.h"

#define GJK_COARSE_ERROR (3 * INT32_C(8192) + 3 * INT32_C(32768))

// A direction and the shifts of vertices and direction.
typedef struct gjk_coarse {
  int32_t x, y, z;
  unsigned s, t;
} gjk_coarse;

// For vertices with components of at most 2^bits in size, 1 <= bits <= 31. Pre: d != 0.
static inline gjk_coarse gjk_coarse_direction(const gjk_vec3 *d, unsigned bits) {
  const unsigned d_bits = 32 - gjk_clz32(gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z));
  const unsigned s = bits > 13 ? bits - 13 : 0, t = d_bits > 15 ? d_bits - 15 : 0;
  const gjk_coarse coarse = {gjk_sar32(d->x, t), gjk_sar32(d->y, t), gjk_sar32(d->z, t), s, t};
  return coarse;
}

static inline int32_t gjk_coarse_dot(const gjk_coarse *c, const gjk_vec3 *v) {
  const int32_t x = gjk_sar32(v->x, c->s), y = gjk_sar32(v->y, c->s), z = gjk_sar32(v->z, c->s);
  //@ assert x >= -8192 && x <= 8192 && y >= -8192 && y <= 8192 && z >= -8192 && z <= 8192;
  //@ assert c->x >= -32768 && c->x <= 32768 && c->y >= -32768 && c->y <= 32768 && c->z >= -32768 && c->z <= 32768;
  return x * c->x + y * c->y + z * c->z;
}

#endif
