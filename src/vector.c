// Exact signs along directions, and their rounding.
#include "vector.h"

// With n = 2^32 high + 2^16 middle + low per component, middle and low unsigned 16-bit:
// |sum of high v| <= 2^32 here (else the caller's filter had settled it), |sums of middle v, low v| < 2^48.
int gjk_dot_sign_exact(const gjk_long3 *n, gjk_vec3 v) {
  const int64_t component[3] = {n->x, n->y, n->z};
  const int32_t along[3] = {v.x, v.y, v.z};
  int64_t high = 0, middle = 0, low = 0;
  for (int i = 0; i < 3; i++) {
    uint32_t bits = gjk_low32(component[i]);
    high += gjk_mul32(gjk_high32(component[i]), along[i]);
    middle += gjk_mul32((int32_t)(bits >> 16), along[i]);
    low += gjk_mul32((int32_t)(bits & 0xFFFFu), along[i]);
  }
  // n . v = 2^16 (2^16 high + middle + floor(low / 2^16)) + (low mod 2^16)
  if (high > INT64_C(0x1FFFFFFFF) || high < -INT64_C(0x1FFFFFFFF)) {
    return gjk_sign64(high);
  }
  int64_t upper = high * 65536 + middle + gjk_sar64(low, 16);
  if (upper != 0) {
    return gjk_sign64(upper);
  }
  return ((uint64_t)low & 0xFFFFu) != 0;
}

int gjk_direction_sign(const gjk_direction *direction, gjk_vec3 v) {
  if (direction->rank == 3) {
    return gjk_dot_sign(direction->n, v);
  }
  if (direction->rank == 2) {
    // ta, tb <= 2^61; |a . v|, |b . v| <= 3 2^59
    return -gjk_sum_sign(direction->tb, gjk_dot(*direction->a, v), direction->ta, gjk_dot(*direction->b, v));
  }
  return gjk_sign64(gjk_dot(direction->rounded, v));
}

// x / 2^k to the nearest integer, 1 <= k <= 33. Pre: the result is at most 2^30 in size.
GJK_HOT_INLINE int32_t round_down(int64_t x, unsigned k) {
  const uint64_t bits = (uint64_t)x + ((uint64_t)1 << (k - 1));
  if (k > 32) {
    return gjk_sar32(gjk_int32((uint32_t)(bits >> 32)), k - 32);
  }
  return gjk_int32((uint32_t)((bits >> k) & UINT32_MAX));
}

bool gjk_round_direction(const gjk_long3 *n, gjk_vec3 *rounded) {
  // The bits of n, of -1 - n for negative components: |n| <= 2^30 when they end below bit 30.
  const int64_t bits = (n->x ^ gjk_sar64(n->x, 63)) | (n->y ^ gjk_sar64(n->y, 63)) | (n->z ^ gjk_sar64(n->z, 63));
  if (bits >> 30 == 0) {
    rounded->x = (int32_t)n->x;
    rounded->y = (int32_t)n->y;
    rounded->z = (int32_t)n->z;
    return true;
  }
  const unsigned k = 34 - gjk_clz64((uint64_t)bits);
  rounded->x = round_down(n->x, k);
  rounded->y = round_down(n->y, k);
  rounded->z = round_down(n->z, k);
  return (((uint64_t)n->x | (uint64_t)n->y | (uint64_t)n->z) & (((uint64_t)1 << k) - 1)) == 0;
}

// -(a tb + b ta) = 2^31 high + low with 0 <= low < 2^31. With t = 2^31 th + tl: th <= 2^30, so
// |a tbh + b tah| <= 3 2^60 and |a tbl + b tal| <= 3 2^61.
GJK_HOT_INLINE uint32_t combine(int32_t a, int64_t tb, int32_t b, int64_t ta, int64_t *high) {
  const uint32_t mask = INT32_MAX;
  int64_t low = -gjk_mul32(a, (int32_t)(gjk_low32(tb) & mask)) - gjk_mul32(b, (int32_t)(gjk_low32(ta) & mask));
  *high = gjk_sar64(low, 31) - gjk_mul32(a, (int32_t)gjk_sar64(tb, 31)) - gjk_mul32(b, (int32_t)gjk_sar64(ta, 31));
  return gjk_low32(low) & mask;
}

bool gjk_edge_direction(gjk_direction *direction) {
  const gjk_vec3 *a = direction->a, *b = direction->b;
  gjk_long3 n;
  uint32_t x = combine(a->x, direction->tb, b->x, direction->ta, &n.x);
  uint32_t y = combine(a->y, direction->tb, b->y, direction->ta, &n.y);
  uint32_t z = combine(a->z, direction->tb, b->z, direction->ta, &n.z);
  const int64_t limit = INT64_C(1) << 31;
  if (n.x < limit && n.x >= -limit && n.y < limit && n.y >= -limit && n.z < limit && n.z >= -limit) {
    // The whole is at most 2^62.
    n.x = gjk_shl64(n.x, 31) + x;
    n.y = gjk_shl64(n.y, 31) + y;
    n.z = gjk_shl64(n.z, 31) + z;
    direction->exact = gjk_round_direction(&n, &direction->rounded);
    return (n.x | n.y | n.z) != 0;
  }
  direction->exact = gjk_round_direction(&n, &direction->rounded) && (x | y | z) == 0;
  return true;
}
