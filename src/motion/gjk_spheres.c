// Bounding spheres on a way, by coarse products with proven slack.
//
//   Step 1   Boxes: the way, grown by the reach, does not hold the difference of centres along an axis.
//   Step 2   The line: it passes the difference of centres by more than the reach.
#include "gjk_spheres.h"

// Step 1: is o beyond both 0 and t by more than reach?
static bool is_past(int64_t o, int64_t t, int64_t reach) {
  return t < 0 ? o > reach || o < t - reach : o < -reach || o > t + reach;
}

// v 2^-k, rounded down, with the k for which the largest component has 29 bits. Pre: v is not zero, components below 2^34.
static gjk_vec3 leading_bits_of(const gjk_long3 *v, int *k) {
  const uint64_t size = gjk_magnitude64(v->x) | gjk_magnitude64(v->y) | gjk_magnitude64(v->z);
  const int n = 35 - (int)gjk_clz64(size);
  gjk_vec3 out;
  *k = n;
  if (n >= 0) {
    out.x = (int32_t)gjk_sar64(v->x, (unsigned)n);
    out.y = (int32_t)gjk_sar64(v->y, (unsigned)n);
    out.z = (int32_t)gjk_sar64(v->z, (unsigned)n);
  } else {
    out.x = gjk_shl32((int32_t)v->x, (unsigned)-n);
    out.y = gjk_shl32((int32_t)v->y, (unsigned)-n);
    out.z = gjk_shl32((int32_t)v->z, (unsigned)-n);
  }
  return out;
}

// Step 2: |t x o| > reach |t|?
//   o' = 2^-k o, t' = 2^-j t, rounded down if k, j > 0:   components at most 2^29 in size, one at least 2^28 - 1
//   distance of o' from the line along t'                 off by at most sqrt(3) for o', |o'| sqrt(3) / |t'| < 7 for t'
//   c = 2^-30 t' x o', rounded down                       |c| at most sqrt(3) too large
// The line passes o by more than reach if |c| - 2 > 2^-30 reach' |t'| with reach' = 2^-k reach + 12.
static bool passes(const gjk_long3 *o, const gjk_long3 *t, int64_t reach) {
  int j, k;
  gjk_long3 product;
  const gjk_vec3 o1 = leading_bits_of(o, &k), t1 = leading_bits_of(t, &j);
  if (k < 0 && reach >= INT32_C(1) << (30 + k)) {
    return false;
  }
  const int64_t reach1 = k < 0 ? (int64_t)gjk_shl32((int32_t)reach, (unsigned)-k) : gjk_sar64(reach, (unsigned)k);
  if (reach1 >= (INT64_C(1) << 30) - 12) {
    return false;
  }
  const int32_t scaled = (int32_t)reach1 + 12;
  gjk_cross(&t1, &o1, &product);  // |o'|, |t'| <= 2^29.8:  below 2^59.6
  const gjk_vec3 c = {(int32_t)gjk_sar64(product.x, 30), (int32_t)gjk_sar64(product.y, 30),
                      (int32_t)gjk_sar64(product.z, 30)};
  // (|c| - 2)^2 >= |c|^2 - 4 |c|_1.
  const int64_t square = gjk_dot(&c, &c) - 4 * (int64_t)gjk_norm1(c);
  // (reach' |t'| / 2^30)^2, rounded up: reach' shifted to 30 bits for that.
  const unsigned z = gjk_clz32((uint32_t)scaled) - 2;
  const int32_t r = (int32_t)((uint32_t)scaled << z);
  const uint32_t rr = (uint32_t)(gjk_mul32(r, r) >> 30) + 1,
                 tt = (uint32_t)(gjk_dot(&t1, &t1) >> 30) + 1;  // <= 2^30 + 1
  const int64_t limit = gjk_sar64((int64_t)gjk_umul32(rr, tt), 2 * z) + 1;
  return square > limit;
}

bool gjk_spheres_part(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius) {
  const int64_t reach = radius + a->core_radius + b->core_radius;  // below 2^32 + 2^29
  const gjk_long3 o = {(int64_t)a->centre.x - b->centre.x, (int64_t)a->centre.y - b->centre.y,
                       (int64_t)a->centre.z - b->centre.z};
  const gjk_long3 *t = &way->t;
  if (is_past(o.x, t->x, reach) || is_past(o.y, t->y, reach) || is_past(o.z, t->z, reach)) {
    return true;
  }
  return (o.x | o.y | o.z) != 0 && (t->x | t->y | t->z) != 0 && passes(&o, t, reach);
}
