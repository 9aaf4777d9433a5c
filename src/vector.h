// Vectors of integers: exact sums, dot and cross products, and signs along directions.
#ifndef GJK_SRC_VECTOR_H
#define GJK_SRC_VECTOR_H

#include "gjk/format.h"
#include "wide.h"

// A normal or other vector of 64-bit components.
typedef struct gjk_long3 {
  int64_t x, y, z;
} gjk_long3;

static inline gjk_vec3 gjk_add(gjk_vec3 a, gjk_vec3 b) {
  gjk_vec3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
  return sum;
}

static inline gjk_vec3 gjk_sub(gjk_vec3 a, gjk_vec3 b) {
  gjk_vec3 difference = {a.x - b.x, a.y - b.y, a.z - b.z};
  return difference;
}

static inline gjk_vec3 gjk_negate(gjk_vec3 a) {
  gjk_vec3 opposite = {-a.x, -a.y, -a.z};
  return opposite;
}

// a . b, exact. Pre: |a| |b| < 2^62, lengths; then each product and each partial sum is below 3 2^61.
GJK_HOT_INLINE int64_t gjk_dot(gjk_vec3 a, gjk_vec3 b) {
  return gjk_mac32(gjk_mac32(gjk_mul32(a.x, b.x), a.y, b.y), a.z, b.z);
}

// a x b, exact. Pre: |a| |b| <= 2^62; then products and components are at most 2^62 in size.
GJK_HOT_INLINE gjk_long3 gjk_cross(gjk_vec3 a, gjk_vec3 b) {
  gjk_long3 c = {gjk_mac32(gjk_mul32(a.y, b.z), -a.z, b.y), gjk_mac32(gjk_mul32(a.z, b.x), -a.x, b.z),
                 gjk_mac32(gjk_mul32(a.x, b.y), -a.y, b.x)};
  return c;
}

// |x| + |y| + |z|. Pre: at most 2^32 - 1.
static inline uint32_t gjk_norm1(gjk_vec3 v) {
  return gjk_magnitude32(v.x) + gjk_magnitude32(v.y) + gjk_magnitude32(v.z);
}

// n . v = 2^32 (returned) + *low, exact. Pre: |n| <= 2^62, |v| <= 2^31, lengths.
int64_t gjk_dot_exact(const gjk_long3 *n, gjk_vec3 v, uint32_t *low);

// The sign of n . v. Pre: as above.
int gjk_dot_sign_exact(const gjk_long3 *n, gjk_vec3 v);

// The same, settled from the high words of n wherever they suffice: n . v / 2^32 differs from h by less than
// |v.x| + |v.y| + |v.z| <= sqrt(3) 2^31 < 2^32. Each |high word| is at most 2^30, so |h| <= 3 2^61.
GJK_HOT_INLINE int gjk_dot_sign(const gjk_long3 *n, gjk_vec3 v) {
#if GJK_INT128
  GJK_INT128_TYPE sum = (GJK_INT128_TYPE)n->x * v.x + (GJK_INT128_TYPE)n->y * v.y + (GJK_INT128_TYPE)n->z * v.z;
  return (sum > 0) - (sum < 0);
#else
  const gjk_vec3 high = {gjk_high32(n->x), gjk_high32(n->y), gjk_high32(n->z)};
  int64_t h = gjk_mac32(gjk_mac32(gjk_mul32(high.x, v.x), high.y, v.y), high.z, v.z);
  int32_t top = gjk_high32(h);
  if (top >= 1) {
    return 1;
  }
  return top < -1 ? -1 : gjk_dot_sign_exact(n, v);
#endif
}

// The exact direction from a feature to the origin, by what spans the feature:
//   1 vertex   -a
//   2 vertices -(a tb + b ta), where ta = a . (a - b) and tb = b . (b - a), at most 2^61 and positive
//   3 vertices n
typedef struct gjk_direction {
  const gjk_vec3 *a, *b;
  const gjk_long3 *n;
  int64_t ta, tb;
  uint8_t rank;  // 1, 2 or 3
} gjk_direction;

// The sign of the exact direction along v. Pre: |v| <= 2^30.
int gjk_direction_sign(const gjk_direction *direction, const gjk_vec3 *v);

// A direction as the support scans take it: the exact one / 2^k for some k, off by less than 1 in each component.
typedef struct gjk_rounded {
  gjk_vec3 d;  // components at most 2^30 in size, 3 2^29 for a vertex
  bool exact;  // d is a positive multiple of the exact direction
} gjk_rounded;

// Rounds -(a tb + b ta). False when it is zero. Pre: |a|, |b| <= 3 2^29; 0 < ta, tb <= 2^61.
bool gjk_round_edge_direction(const gjk_vec3 *a, int64_t tb, const gjk_vec3 *b, int64_t ta, gjk_rounded *out);

// Rounds n to the nearest integers, with the least k >= 0 that leaves every component at most 2^30 in size.
// Pre: |n| < 2^63 - 2^33 per component.
void gjk_round_direction(const gjk_long3 *n, gjk_rounded *out);

// d 2^k with the largest k >= 0 that leaves every component below 2^30 in size, or d when none does. Pre: d != 0.
static inline gjk_vec3 gjk_scale_direction(const gjk_vec3 *d) {
  const uint32_t bits = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);
  const unsigned zeros = gjk_clz32(bits), k = zeros > 2 ? zeros - 2 : 0;
  gjk_vec3 scaled = {gjk_shl32(d->x, k), gjk_shl32(d->y, k), gjk_shl32(d->z, k)};
  return scaled;
}

#endif
