// Square roots by Newton's iteration for the reciprocal.
#include "gjk_root.h"

// The line is within 10 %. A step takes a relative error e to 3/2 e^2 below: 1.5 %, 2^-11, 2^-22, 2^-43.
// Roundings of the last step: square is low by less than 1 in at least 2^30, which raises y by less than 1/2;
// the others lower it by less than 3/2.
uint32_t gjk_reciprocal_root(uint32_t x) {
  uint32_t y = UINT32_C(2319282340) - gjk_umulh32(x, UINT32_C(1342177280));
  for (int i = 0; i < 4; i++) {
    // y < 2^31 before each step: below 2^32
    //@ assert y <= INT32_MAX;
    const uint32_t square = (uint32_t)(gjk_umul32(y, y) >> 30);
    // 2^62 - x square, at most 2^60 in size
    const int64_t rest = gjk_int64((UINT64_C(1) << 62) - gjk_umul32(x, square));
    //@ assert rest >= -(INT64_C(1) << 60) && rest <= INT64_C(1) << 60;
    // y (rest / 2^62) / 2, at most 2^29 in size
    const int64_t step = gjk_sar64(gjk_mul32((int32_t)(y >> 1), (int32_t)gjk_sar64(rest, 31)), 31);
    y = (uint32_t)((int64_t)y + step);
  }
  return y;
}

uint32_t gjk_isqrt64(uint64_t x) {
  if (x == 0) {
    return 0;
  }
  const unsigned zeros = gjk_clz64(x) & ~1u;
  const uint32_t top = (uint32_t)((x << zeros) >> 32);
  // sqrt(x 2^zeros) = 2^16 sqrt(top + fraction), and top / sqrt(top) = top y / 2^46.
  const uint64_t scaled = gjk_umul32(top, gjk_reciprocal_root(top) - 1) >> 30;
  uint32_t root = (uint32_t)(scaled >> (zeros / 2));
  uint64_t rest = x - gjk_umul32(root, root);
  // not reached: 12 is a ceiling on what the error above may need
  for (int i = 0; i < 12 && rest > 2 * (uint64_t)root; i++) {
    rest -= 2 * (uint64_t)root + 1;
    root++;
  }
  return root;
}
