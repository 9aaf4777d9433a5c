// Rotation matrices of unit quaternions, and what they do to vectors.
#ifndef GJK_SRC_ROTATION_H
#define GJK_SRC_ROTATION_H

#include "gjk/pose.h"
#include "gjk_vector.h"

// *deviation = |q|^2 - 1, exact, Q60, at most 2^44 in size. False beyond GJK_ROTATION_TOLERANCE; then *deviation is not
// set.
bool gjk_quat_deviation(const gjk_quat *q, int64_t *deviation);

// The four numbers x, y, z, w of the product a b, exact, Q60. Pre: |a| |b| < 2^62, lengths.
static inline void gjk_quat_product(const gjk_quat *a, const gjk_quat *b, int64_t product[4]) {
  // |products|, |partial sums| <= |a| |b|
  product[0] = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->w, b->x), a->x, b->w), a->y, b->z), -a->z, b->y);
  product[1] = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->w, b->y), a->y, b->w), a->z, b->x), -a->x, b->z);
  product[2] = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->w, b->z), a->z, b->w), a->x, b->y), -a->y, b->x);
  product[3] = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->w, b->w), -a->x, b->x), -a->y, b->y), -a->z, b->z);
}

// x (1 - excess / 2^46), from Q60 to the nearest Q30: within 0.5 + 2^-14 LSB, and at most 2^30 in size when the
// exact value is. Pre: |x| <= 2^60 (1 + 2^-15), |excess| < 2^31.
gjk_q30 gjk_corrected_q30(int64_t x, int32_t excess);

// The product of a / |a| and b / |b|, each component within 0.501 LSB, for a and b with these deviations.
void gjk_quat_multiply(const gjk_quat *a, int64_t off_a, const gjk_quat *b, int64_t off_b, gjk_quat *out);

// unit = v / |v| for a vector v of `count` components, at most four, each within 0.501 LSB. False: v is zero.
bool gjk_normalize(const int32_t v[4], int count, gjk_q30 unit[4]);

// *out = v / |v|, likewise.
bool gjk_axis_normalize(const gjk_vec3 *v, gjk_unit3 *out);

// The rotation matrix of q / |q|, by rows, Q2.30: entries within 0.5 + 2^-13 LSB and at most 2^30 in size; the
// identity is exact. False if q is not a unit within GJK_ROTATION_TOLERANCE; then rows is not set.
bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]);

// The same for the z components alone: where the local z axis goes. For builds that know segments but no boxes.
bool gjk_rotation_of_z(const gjk_quat *q, gjk_vec3 rows[3]);

// The same, and v rotated without the rounding of the matrix, Q30: within 2^-42 (|v.x| + |v.y| + |v.z|), so within
// 2^-9 LSB for any v, and at most 2^62 in size. The identity is exact.
bool gjk_rotation_with_point(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 rows[3], int64_t rotated[3]);

// The matrix times v, to the nearest LSB, a half up. It is within 0.501 (1 + (|v.x| + |v.y| + |v.z|) / 2^30) LSB of the
// real rotation, so within 1 LSB for |v| up to 2^29. Pre: |v| <= 2^31 - 4, length; then the result fits.
gjk_vec3 gjk_rotate(const gjk_vec3 rows[3], const gjk_vec3 *v);

// The transposed matrix, which is the opposite rotation, times v. Otherwise as gjk_rotate.
gjk_vec3 gjk_rotate_back(const gjk_vec3 rows[3], const gjk_vec3 *v);

// Half an LSB, Q30: added to a product before it is shifted.
#define GJK_ROTATION_HALF (INT32_C(1) << 29)

// Half an LSB and a fraction in Q8, both in Q30.
static inline int32_t gjk_rotation_start(int8_t fraction) {
  return GJK_ROTATION_HALF + fraction * (INT32_C(1) << 22);  // -2^7 <= fraction < 2^7:  0 <= result < 2^30
}

// As gjk_rotate, with a fraction of an LSB, Q8, added to each component before it is rounded.
gjk_vec3 gjk_rotate_onto(const gjk_vec3 rows[3], const gjk_vec3 *v, const int8_t fraction[3]);

// As gjk_rotate, for any v: out is at most 2^32 in size.
void gjk_rotate_wide(const gjk_vec3 rows[3], const gjk_vec3 *v, int64_t out[3]);

#endif
