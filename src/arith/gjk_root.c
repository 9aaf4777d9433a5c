// Square roots by Newton's iteration for the reciprocal root.
//
// gjk_reciprocal_root, with u = x / 2^32, 1/4 <= u < 1, and Y = y / 2^30, which approaches 1 / sqrt(u):
//   1. Start from the line Y = 2.16 - 1.25 u. It is within 10 % of 1 / sqrt(u).
//   2. Four times: Y += Y (1 - u Y^2) / 2. A relative error e becomes -3/2 e^2: 1.5 %, 2^-11, 2^-22, 2^-43.
//
// gjk_isqrt64:
//   3. Shift x left by an even number of bits. The upper half, top, is then at least 2^30.
//   4. top times its reciprocal root is sqrt(top), never too large. Undo half of the shift.
//   5. Count the root up until its remainder, x - root^2, is less than 2 root + 1.
#include "gjk_root.h"

uint32_t gjk_reciprocal_root(uint32_t x) {
  uint32_t y = UINT32_C(2319282340) - gjk_umulh32(x, UINT32_C(1342177280));  // Step 1
  for (int i = 0; i < 4; i++) {                                              // Step 2
    y = gjk_root_step(x, y);
  }
  return y;
}

uint32_t gjk_isqrt64(uint64_t x) {
  if (x == 0) {
    return 0;
  }
  const unsigned zeros = gjk_clz64(x) & ~1u;  // Step 3
  const uint32_t top = (uint32_t)((x << zeros) >> 32);
  // Step 4: top (2^46 / sqrt(top)) / 2^30 = 2^16 sqrt(top), and sqrt(x 2^zeros) is 2^16 sqrt(top + its fraction). The
  // reciprocal root less 1 is not too large.
  const uint64_t scaled = gjk_umul32(top, gjk_reciprocal_root(top) - 1) >> 30;
  uint32_t root = (uint32_t)(scaled >> (zeros / 2));
  uint64_t rest = x - gjk_umul32(root, root);  // Step 5
  // not reached: 12 is a ceiling on what the error of step 4 may need
  for (int i = 0; i < 12 && rest > 2 * (uint64_t)root; i++) {
    rest -= 2 * (uint64_t)root + 1;
    root++;
  }
  return root;
}
