// The small exact operations at the bottom of every query. vector.h includes this in line, vector.c once for all when the
// build is for size: GJK_HOT is the storage class.

// a . b, exact. Pre: |a| |b| < 2^62, lengths; then each product and each partial sum is below 3 2^61.
GJK_HOT int64_t gjk_dot(const gjk_vec3 *a, const gjk_vec3 *b) {
  return gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z);
}

// *out = a x b, exact. Pre: |a| |b| < 2^62; then products and components are below 2^62 in size.
GJK_HOT void gjk_cross(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out) {
  out->x = gjk_mac32(gjk_mul32(a->y, b->z), -a->z, b->y);
  out->y = gjk_mac32(gjk_mul32(a->z, b->x), -a->x, b->z);
  out->z = gjk_mac32(gjk_mul32(a->x, b->y), -a->y, b->x);
  //@ assert out->x > -(INT64_C(1) << 62) && out->x < INT64_C(1) << 62;
  //@ assert out->y > -(INT64_C(1) << 62) && out->y < INT64_C(1) << 62;
  //@ assert out->z > -(INT64_C(1) << 62) && out->z < INT64_C(1) << 62;
}

// The sign of n . v, settled from the high words of n wherever they suffice: n . v / 2^32 differs from h by less than
// |v.x| + |v.y| + |v.z| <= sqrt(3) 2^31 < 2^32. Each |high word| is at most 2^30, so |h| <= 3 2^61.
// Pre: |n| < 2^62, |v| <= 2^31, lengths.
GJK_HOT int gjk_dot_sign(const gjk_long3 *n, const gjk_vec3 *v) {
#if GJK_INT128
  GJK_INT128_TYPE sum = (GJK_INT128_TYPE)n->x * v->x + (GJK_INT128_TYPE)n->y * v->y + (GJK_INT128_TYPE)n->z * v->z;
  return (sum > 0) - (sum < 0);
#else
  const gjk_vec3 high = {gjk_high32(n->x), gjk_high32(n->y), gjk_high32(n->z)};
  const int32_t top = gjk_high32(gjk_dot(&high, v));
  if (top >= 1) {
    return 1;
  }
  return top < -1 ? -1 : gjk_dot_sign_exact(n, v);
#endif
}

// The sign of p q + r s, settled from the high words wherever they suffice. With p = 2^32 ph + pl and so on, and
// |ph| <= 2^30: (p q + r s) / 2^64 differs from h = ph qh + rh sh by less than |ph| + |qh| + |rh| + |sh| + 2, which is
// at most 2^32 + 2 and so below 2^33. Pre: each below 2^62 in size.
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
