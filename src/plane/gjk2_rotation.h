// Rotations of the plane applied to vectors.
#ifndef GJK2_SRC_ROTATION_H
#define GJK2_SRC_ROTATION_H

#include "gjk2/pose.h"
#include "gjk2_vector.h"

// *deviation = c^2 + s^2 - 1, exact, Q60, at most 2^44 in size. False, and *deviation not set, beyond
// GJK2_ROTATION_TOLERANCE.
bool gjk2_rotation_deviation(const gjk2_rotation *r, int64_t *deviation);

// gjk2_rotation_compose of rotations with these deviations. out may be a or b.
void gjk2_rotation_product(const gjk2_rotation *a, int64_t off_a, const gjk2_rotation *b, int64_t off_b,
                           gjk2_rotation *out);

// 1 - 1 / |r|, Q46, within 1, for |r|^2 - 1 = deviation / 2^60. Pre: |deviation| <= 2^45.
int32_t gjk2_excess(int64_t deviation);

// x (1 - excess / 2^46), within 1. Pre: |x| <= 2^62, |excess| < 2^31.
static inline int64_t gjk2_corrected(int64_t x, int32_t excess) {
  // |x / 2^31| <= 2^31 - 1 but for x = 2^62, which is not reached: products of Q30 and coordinates are below it.
  //@ assert x > -(INT64_C(1) << 62) && x < INT64_C(1) << 62;
  return x - gjk_sar64(gjk_mul32((int32_t)gjk_sar64(x, 31), excess), 15);
}

// Q60 to the nearest Q30.
static inline gjk_q30 gjk2_to_q30(int64_t x) {
  return (gjk_q30)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

// The rotation r / |r| as {c, s}, Q2.30: within 0.501 LSB and at most 2^30 in size; the identity is exact. And v
// rotated without the rounding of c and s, Q30: within 2^-9 LSB for any v. False, and outputs not set, when r is not a
// unit within GJK2_ROTATION_TOLERANCE.
bool gjk2_rotation_with_point(const gjk2_rotation *r, const gjk2_vec *v, gjk2_vec *unit, int64_t rotated[2]);

// v rotated by a unit, to the nearest LSB, a half up, with a fraction of an LSB, Q8, added to each component before it
// is rounded. Within 0.501 (1 + (|v.x| + |v.y|) / 2^30) LSB. Pre: |v| < 2^30.
static inline gjk2_vec gjk2_rotate_onto(const gjk2_vec *unit, gjk2_vec v, const int8_t fraction[2]) {
  const int32_t half = INT32_C(1) << 29, step = INT32_C(1) << 22;
  // |unit| <= 2^30 + 1, |v| < 2^30:  sums below 2^61
  const int64_t x = gjk_mac32(gjk_mac32(half + fraction[0] * step, unit->x, v.x), -unit->y, v.y);
  const int64_t y = gjk_mac32(gjk_mac32(half + fraction[1] * step, unit->y, v.x), unit->x, v.y);
  gjk2_vec rotated = {(int32_t)gjk_sar64(x, 30), (int32_t)gjk_sar64(y, 30)};
  return rotated;
}

// v rotated by the opposite of a unit, to the nearest LSB. Pre: |v| <= 2^31 - 4.
static inline gjk2_vec gjk2_rotate_back(const gjk2_vec *unit, gjk2_vec v) {
  const int32_t half = INT32_C(1) << 29;
  gjk2_vec rotated = {(int32_t)gjk_sar64(gjk_mac32(gjk_mac32(half, unit->x, v.x), unit->y, v.y), 30),
                      (int32_t)gjk_sar64(gjk_mac32(gjk_mac32(half, unit->x, v.y), -unit->y, v.x), 30)};
  return rotated;
}

#endif
