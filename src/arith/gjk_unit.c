// Unit vectors.
#include "gjk_unit.h"

#include "gjk_root.h"

static gjk_q30 one_with_sign(int32_t x) {
  return x > 0 ? GJK_Q30_ONE : x < 0 ? -GJK_Q30_ONE : 0;
}

// 2^n x y / 2^31 to the nearest integer.
GJK_ONE_COPY static gjk_q30 component_of_unit(int32_t x, unsigned n, int32_t y) {
  return (gjk_q30)gjk_sar64(gjk_mul32(gjk_shl32(x, n), y) + (INT64_C(1) << 30), 31);
}

gjk_unit3 gjk_unit(const gjk_vec3 *d) {
  const gjk_vec3 v = *d;
  if ((v.x | v.y) == 0 || (v.y | v.z) == 0 || (v.z | v.x) == 0) {
    const gjk_unit3 axis = {one_with_sign(v.x), one_with_sign(v.y), one_with_sign(v.z)};
    return axis;
  }
  const uint64_t squared = (uint64_t)gjk_dot(&v, &v);
  const unsigned z = gjk_clz64(squared) / 2;  // |v| < 2^31:  squared < 2^62, z >= 1;  |v| < 2^(32 - z)
  // With x, 2^30 <= x < 2^32, for the leading bits of squared = 2^(32 - 2 z) x: y = 2^46 / sqrt(x) = 2^(62 - z) / |v|.
  const int32_t y = (int32_t)gjk_reciprocal_root((uint32_t)((squared << (2 * z)) >> 32));
  // 2^30 v / |v| = v y / 2^(32 - z) = (2^(z - 1) v) y / 2^31
  const gjk_unit3 unit = {component_of_unit(v.x, z - 1, y), component_of_unit(v.y, z - 1, y),
                          component_of_unit(v.z, z - 1, y)};
  //@ assert unit.x >= -GJK_Q30_ONE - 1 && unit.x <= GJK_Q30_ONE + 1;
  //@ assert unit.y >= -GJK_Q30_ONE - 1 && unit.y <= GJK_Q30_ONE + 1;
  //@ assert unit.z >= -GJK_Q30_ONE - 1 && unit.z <= GJK_Q30_ONE + 1;
  return unit;
}
