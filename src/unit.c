// Unit vectors by Newton's iteration for the reciprocal square root.
#include "unit.h"

// 2^46 / sqrt(x) for 2^30 <= x < 2^32, within 1 LSB of 2^-31 of its size: from 2^30 to 2^31. A line is within 10 %;
// each step e -> 3/2 e^2 gives 1.4 %, 2^-12, 2^-23, then rounding. All estimates but the first stay below the root.
static uint32_t reciprocal_root(uint32_t x) {
  uint32_t y = UINT32_C(2319282340) - gjk_umulh32(x, UINT32_C(1342177280));
  for (int i = 0; i < 4; i++) {
    uint32_t square = (uint32_t)(gjk_umul32(y, y) >> 30);
    // 2^62 - x square, at most 2^60 in size
    int64_t rest = gjk_int64((UINT64_C(1) << 62) - gjk_umul32(x, square));
    int64_t step = gjk_mul32((int32_t)(y >> 1), (int32_t)gjk_sar64(rest, 31));
    y = (uint32_t)((int64_t)y + gjk_sar64(step, 31));
  }
  return y;
}

gjk_unit3 gjk_unit(const gjk_vec3 *d) {
  const gjk_vec3 v = *d;
  const uint64_t squared = (uint64_t)gjk_dot(v, v);
  // squared = 2^(32 - 2 z) x with 2^30 <= x < 2^32; |v| < 2^31, so z >= 1, and |v| < 2^(32 - z).
  const unsigned z = gjk_clz64(squared) / 2;
  const uint32_t root = reciprocal_root((uint32_t)((squared << (2 * z)) >> 32));
  const int32_t y = root > INT32_MAX ? INT32_MAX : (int32_t)root;
  // 2^30 v / |v| = v y / 2^(32 - z)
  const int64_t half = INT64_C(1) << 30;
  gjk_unit3 unit = {(gjk_q30)gjk_sar64(gjk_mul32(gjk_shl32(v.x, z - 1), y) + half, 31),
                    (gjk_q30)gjk_sar64(gjk_mul32(gjk_shl32(v.y, z - 1), y) + half, 31),
                    (gjk_q30)gjk_sar64(gjk_mul32(gjk_shl32(v.z, z - 1), y) + half, 31)};
  return unit;
}
