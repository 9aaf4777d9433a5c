// Exact signs along directions, and the rounding of directions.
#include "gjk_vector.h"

#if GJK_SMALL
#define GJK_HOT
#include "gjk_vector_inline.h"
#endif

// With n = 2^31 nh + nl, 0 <= nl < 2^31 per component, and |n| < 2^62, |v| <= 2^31:
//   |nl . v|                   <= sqrt(3) 2^62
//   |nh . v|                   <= 2^62 + sqrt(3) 2^31
//   |nl . v / 2^31 + nh . v|   <  2^63
int64_t gjk_dot_exact(const gjk_long3 *n, const gjk_vec3 *v, uint32_t *low) {
  const int64_t lowest =
      gjk_mac32(gjk_mac32(gjk_mul32(gjk_low_digit(n->x), v->x), gjk_low_digit(n->y), v->y), gjk_low_digit(n->z), v->z);
  *low = (uint32_t)gjk_low_digit(lowest);
  return gjk_mac32(gjk_mac32(gjk_mac32(gjk_sar64(lowest, 31), gjk_high_digit(n->x), v->x), gjk_high_digit(n->y), v->y),
                   gjk_high_digit(n->z), v->z);
}

// With n = 2^32 nh + nl, -2^31 <= nl < 2^31 per component, and |n| < 2^62.9, |v| <= 2^31:
//   |nl . v|                   <= sqrt(3) 2^62
//   |nh . v + nl . v / 2^32|   <= 2^61.9 + 2^31
int gjk_dot_sign_exact(const gjk_long3 *n, const gjk_vec3 *v) {
  const int64_t lowest = gjk_mac32(gjk_mac32(gjk_mul32(gjk_low_balanced(n->x), v->x), gjk_low_balanced(n->y), v->y),
                                   gjk_low_balanced(n->z), v->z);
  const int64_t high = gjk_mac32(
      gjk_mac32(gjk_mac32(gjk_sar64(lowest, 32), gjk_high_balanced(n->x), v->x), gjk_high_balanced(n->y), v->y),
      gjk_high_balanced(n->z), v->z);
  return high != 0 ? gjk_sign64(high) : gjk_low32(lowest) != 0;
}

int gjk_direction_sign(const gjk_direction *direction, const gjk_vec3 *v) {
  int side;
  if (direction->spanning == 3) {
    side = -gjk_dot_sign(direction->n, v);
  } else {
    side = direction->spanning == 1
               ? gjk_sign64(gjk_dot(direction->a, v))
               : gjk_sum_of_products_sign(direction->tb, gjk_dot(direction->a, v), direction->ta,
                                          gjk_dot(direction->b, v));  // |v| <= 2^30:  |dot products| <= 3 2^59
  }
  return direction->opposite ? side : -side;
}

// x / 2^k to the nearest integer, 1 <= k <= 32. Pre: the result is at most 2^30 in size.
static int32_t round_down(int64_t x, unsigned k) {
#if GJK_64_BIT
  const int64_t rounded = gjk_sar64(x + (INT64_C(1) << (k - 1)), k);  // |x| < 2^62
  //@ assert rounded >= -(INT32_C(1) << 30) && rounded <= INT32_C(1) << 30;
  return (int32_t)rounded;
#else
  const uint32_t twice = gjk_low32(x) >> (k - 1);
  const int32_t rounded = gjk_int32((((uint32_t)gjk_high32(x) << (32 - k)) | twice >> 1) + (twice & 1u));
  //@ assert rounded >= -(INT32_C(1) << 30) && rounded <= INT32_C(1) << 30;
  return rounded;
#endif
}

// The high words of v's components, joined by or, with -1 - x for a negative component x. Its leading bit tells how
// many bits the largest component has, beyond 32.
static uint32_t high_bits(const gjk_long3 *v) {
  const int32_t x = gjk_high32(v->x), y = gjk_high32(v->y), z = gjk_high32(v->z);
  return (uint32_t)((x ^ gjk_sar32(x, 31)) | (y ^ gjk_sar32(y, 31)) | (z ^ gjk_sar32(z, 31)));
}

// The same of the low words, for components whose high words are 0 or -1.
static uint32_t low_bits(const gjk_long3 *v) {
  return gjk_low32((v->x ^ gjk_sar64(v->x, 63)) | (v->y ^ gjk_sar64(v->y, 63)) | (v->z ^ gjk_sar64(v->z, 63)));
}

#if GJK_64_BIT
void gjk_search_direction_of(const gjk_long3 *n, gjk_search_direction *out) {
  // x ^ (x >> 63) is x, or -1 - x for a negative one. Joined by or, they have as many bits as the largest of them.
  const int64_t bits = (n->x ^ gjk_sar64(n->x, 63)) | (n->y ^ gjk_sar64(n->y, 63)) | (n->z ^ gjk_sar64(n->z, 63));
  out->exact = true;
  if (bits >> 30 == 0) {
    out->d.x = (int32_t)n->x;
    out->d.y = (int32_t)n->y;
    out->d.z = (int32_t)n->z;
    return;
  }
  const unsigned k = 34 - gjk_clz64((uint64_t)bits);  // 2^30 <= bits < 2^62:  30 + k bits, 1 <= k <= 32
  out->d.x = round_down(n->x, k);
  out->d.y = round_down(n->y, k);
  out->d.z = round_down(n->z, k);
  out->exact = (uint64_t)(n->x | n->y | n->z) << (64 - k) == 0;
}
#else
void gjk_search_direction_of(const gjk_long3 *n, gjk_search_direction *out) {
  uint32_t bits = high_bits(n);
  unsigned k = 34;
  if (bits == 0) {
    bits = low_bits(n);
    k = 2;
    if (bits >> 30 == 0) {
      //@ assert n->x >= -(INT32_C(1) << 30) && n->x < INT32_C(1) << 30;
      //@ assert n->y >= -(INT32_C(1) << 30) && n->y < INT32_C(1) << 30;
      //@ assert n->z >= -(INT32_C(1) << 30) && n->z < INT32_C(1) << 30;
      out->d.x = (int32_t)n->x;
      out->d.y = (int32_t)n->y;
      out->d.z = (int32_t)n->z;
      out->exact = true;
      return;
    }
  }
  k -= gjk_clz32(bits);
  //@ assert k >= 1 && k <= 32;
  out->d.x = round_down(n->x, k);
  out->d.y = round_down(n->y, k);
  out->d.z = round_down(n->z, k);
  out->exact = (gjk_low32(n->x) | gjk_low32(n->y) | gjk_low32(n->z)) << (32 - k) == 0;
}
#endif

// One component of -(a tb + b ta) = 2^31 *high + low. Returns low, 0 <= low < 2^31.
//
// In line, where the build is for speed: out of line it costs 2 % of a query's instructions on Cortex-M0.
GJK_ONCE static uint32_t combine(int32_t a, int64_t tb, int32_t b, int64_t ta, int64_t *high) {
  // With ta = 2^31 tah + tal, tah <= 2^30, and tb alike; |a|, |b| <= 3 2^29:
  //   |a tbl + b tal| <= 3 2^61
  //   |a tbh + b tah| <= 3 2^60
  const int64_t low = gjk_mac32(gjk_mul32(-a, gjk_low_digit(tb)), -b, gjk_low_digit(ta));
  *high = gjk_mac32(gjk_mac32(gjk_sar64(low, 31), -a, gjk_high_digit(tb)), -b, gjk_high_digit(ta));
  return (uint32_t)gjk_low_digit(low);
}

bool gjk_search_direction_of_edge(const gjk_vec3 *a, int64_t tb, const gjk_vec3 *b, int64_t ta,
                                  gjk_search_direction *out) {
  gjk_long3 n;
  const uint32_t x = combine(a->x, tb, b->x, ta, &n.x);
  const uint32_t y = combine(a->y, tb, b->y, ta, &n.y);
  const uint32_t z = combine(a->z, tb, b->z, ta, &n.z);
  if (high_bits(&n) == 0 && low_bits(&n) >> 31 == 0) {
    // Each component of n is from -2^31 to below 2^31: the whole is at most 2^62 in size.
    n.x = gjk_shl64(n.x, 31) + x;
    n.y = gjk_shl64(n.y, 31) + y;
    n.z = gjk_shl64(n.z, 31) + z;
    gjk_search_direction_of(&n, out);
    return (n.x | n.y | n.z) != 0;
  }
  gjk_search_direction_of(&n, out);
  out->exact = out->exact && (x | y | z) == 0;
  return true;
}
