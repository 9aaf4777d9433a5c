// The small exact operations that every query stands on.
//
// gjk_vector.h includes this file for functions in line; in a build for size gjk_vector.c includes it, for one copy.
// GJK_HOT is their storage class.

// a . b, exact. Pre: |a| |b| < 2^62, lengths.
GJK_HOT int64_t gjk_dot(const gjk_vec3 *a, const gjk_vec3 *b) {
  // |each partial sum| <= |a| |b| < 2^62
  return gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z);
}

// *out = a x b, exact. Pre: |a| |b| < 2^62, lengths.
GJK_HOT void gjk_cross(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out) {
  // |each product|, |each component| <= |a| |b| < 2^62
#if GJK_64_BIT
  out->x = gjk_mul32(a->y, b->z) - gjk_mul32(a->z, b->y);
  out->y = gjk_mul32(a->z, b->x) - gjk_mul32(a->x, b->z);
  out->z = gjk_mul32(a->x, b->y) - gjk_mul32(a->y, b->x);
#else
  out->x = gjk_mac32(gjk_mul32(a->y, b->z), -a->z, b->y);
  out->y = gjk_mac32(gjk_mul32(a->z, b->x), -a->x, b->z);
  out->z = gjk_mac32(gjk_mul32(a->x, b->y), -a->y, b->x);
#endif
  //@ assert out->x > -(INT64_C(1) << 62) && out->x < INT64_C(1) << 62;
  //@ assert out->y > -(INT64_C(1) << 62) && out->y < INT64_C(1) << 62;
  //@ assert out->z > -(INT64_C(1) << 62) && out->z < INT64_C(1) << 62;
}

// *out = (b - a) x (c - a), exact: the triangle's normal, on the side from which a, b, c run counterclockwise.
// Pre: both edges are shorter than 2^31; then products of their components are below 2^62. The proof asks at each call.
GJK_HOT void gjk_triangle_normal(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, gjk_long3 *out) {
  const gjk_vec3 ab = gjk_sub(*b, *a), ac = gjk_sub(*c, *a);
  gjk_cross(&ab, &ac, out);
}

// a b / 2^n to the nearest integer, a half up. Pre: as of gjk_scaled.
GJK_ONCE static int32_t gjk_scaled_component(int32_t a, int32_t b, unsigned n) {
  return (int32_t)gjk_sar64(gjk_mac32(gjk_shl64(1, n - 1), a, b), n);
}

// *out = by v / 2^n, each component to the nearest integer, a half up. Pre: 1 <= n <= 62; products are below 2^62 in size, and
// results fit.
GJK_HOT void gjk_scaled(const gjk_vec3 *v, int32_t by, unsigned n, gjk_vec3 *out) {
  out->x = gjk_scaled_component(v->x, by, n);
  out->y = gjk_scaled_component(v->y, by, n);
  out->z = gjk_scaled_component(v->z, by, n);
}

// The sign of n . v. Pre: |n| < 2^62.9, |v| <= 2^31, lengths.
//
// The high words settle most signs. With n = 2^32 high + low, 0 <= low < 2^32 per component:
//   |high . v|             <= 2^61.9 + 2^32                since |high| <= 2^30.9 + 2
//   |low . v / 2^32|       <  |v.x| + |v.y| + |v.z|        <= sqrt(3) 2^31 < 2^32
// So top >= 1 or top < -1 is the sign.
GJK_HOT int gjk_dot_sign(const gjk_long3 *n, const gjk_vec3 *v) {
#if GJK_INT128
  GJK_INT128_TYPE sum = (GJK_INT128_TYPE)n->x * v->x + (GJK_INT128_TYPE)n->y * v->y + (GJK_INT128_TYPE)n->z * v->z;
  return sum > 0 ? 1 : -(sum < 0);
#else
  const gjk_vec3 high = {gjk_high32(n->x), gjk_high32(n->y), gjk_high32(n->z)};
  const int32_t top = gjk_high32(gjk_dot(&high, v));
  if (top >= 1) {
    return 1;
  }
  return top < -1 ? -1 : gjk_dot_sign_exact(n, v);
#endif
}

// The sign of p q + r s. Pre: each is below 2^62 in size.
//
// The high words settle most signs. With p = 2^32 ph + pl, 0 <= pl < 2^32, and so on:
//   |ph qh + rh sh|                            <= 2^61         since |ph|, |qh|, |rh|, |sh| <= 2^30
//   |(p q + r s) / 2^64 - (ph qh + rh sh)|     <  |ph| + |qh| + |rh| + |sh| + 2 <= 2^32 + 2 < 2^33
// So top >= 2 or top < -2 is the sign.
GJK_HOT int gjk_sum_of_products_sign(int64_t p, int64_t q, int64_t r, int64_t s) {
#if GJK_INT128
  GJK_INT128_TYPE sum = (GJK_INT128_TYPE)p * q + (GJK_INT128_TYPE)r * s;
  return (sum > 0) - (sum < 0);
#else
  const int32_t top = gjk_high32(gjk_mac32(gjk_mul32(gjk_high32(p), gjk_high32(q)), gjk_high32(r), gjk_high32(s)));
  if (top >= 2) {
    return 1;
  }
  return top < -2 ? -1 : gjk_sum_of_products_sign_exact(p, q, r, s);
#endif
}
