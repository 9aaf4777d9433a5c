// Square roots of integers, and their reciprocals.
#ifndef GJK_SRC_ROOT_H
#define GJK_SRC_ROOT_H

#include "gjk_wide.h"

// A step of Newton's iteration for y = 2^46 / sqrt(x): with x = 2^32 u and y = 2^30 Y, Y + Y (1 - u Y^2) / 2. Rounding: the
// square is too small by less than 1 in at least 2^30, which raises y by less than 1/2. The other shifts lower it by less
// than 3/2. Pre: y is within 10 % of its limit, and below 2^31.
static inline uint32_t gjk_root_step(uint32_t x, uint32_t y) {
  //@ assert y <= INT32_MAX;
  const uint32_t square = (uint32_t)(gjk_umul32(y, y) >> 30);                   // y < 2^31:  square < 2^32
  const int64_t rest = gjk_int64((UINT64_C(1) << 62) - gjk_umul32(x, square));  // |rest| <= 2^60
  //@ assert rest >= -(INT64_C(1) << 60) && rest <= INT64_C(1) << 60;
  // (y / 2) (rest / 2^62) = (y without its last bit) (rest / 2^31) / 2^32:  at most 2^29 in size
  const int32_t even = (int32_t)(y & ~UINT32_C(1));
  return (uint32_t)((int32_t)y + gjk_high32(gjk_mul32(even, (int32_t)gjk_sar64(rest, 31))));
}

// 2^46 / sqrt(x), at most 1.5 too small, at most 0.5 too large, and below 2^31. Pre: x >= 2^30.
uint32_t gjk_reciprocal_root(uint32_t x);

// floor(sqrt(x)).
uint32_t gjk_isqrt64(uint64_t x);

// The root of x to the nearest. Pre: x < 2^64 - 2^32, so that it fits.
static inline uint32_t gjk_nearest_root(uint64_t x) {
  const uint32_t root = gjk_isqrt64(x);
  return root + (x - gjk_umul32(root, root) > root ? 1u : 0u);  // x > root^2 + root:  x >= (root + 1/2)^2
}

#endif
