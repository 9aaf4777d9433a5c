// Rotation matrices of unit quaternions, and what they do to vectors.
#include "rotation.h"

bool gjk_quat_deviation(const gjk_quat *q, int64_t *deviation) {
  // The sum is at most 2^64, and 2^64 wraps to 0, which is beyond the tolerance as well.
  const uint64_t squared = (uint64_t)gjk_mul32(q->x, q->x) + (uint64_t)gjk_mul32(q->y, q->y) +
                           (uint64_t)gjk_mul32(q->z, q->z) + (uint64_t)gjk_mul32(q->w, q->w);
  const int64_t off = gjk_int64(squared - (UINT64_C(1) << 60));
  const uint64_t tolerance = (uint64_t)GJK_ROTATION_TOLERANCE << 30;
  if (gjk_magnitude64(off) > tolerance) {
    return false;
  }
  //@ assert off >= -(INT64_C(1) << 44) && off <= INT64_C(1) << 44;
  //@ assert q->x >= -INT32_C(0x40002000) && q->x <= INT32_C(0x40002000);
  //@ assert q->y >= -INT32_C(0x40002000) && q->y <= INT32_C(0x40002000);
  //@ assert q->z >= -INT32_C(0x40002000) && q->z <= INT32_C(0x40002000);
  //@ assert q->w >= -INT32_C(0x40002000) && q->w <= INT32_C(0x40002000);
  *deviation = off;
  return true;
}

gjk_q30 gjk_corrected_q30(int64_t x, int32_t excess) {
  //@ assert x >= -(INT64_C(33) << 55) && x <= INT64_C(33) << 55;
  // Q30 times Q46, back to Q60: below 2^62 and 2^46. Floors lose 1 in Q30 times excess < 2^-15, and 1 in Q60.
  const int64_t correction = gjk_sar64(gjk_mul32((int32_t)gjk_sar64(x, 30), excess), 16);
  return (gjk_q30)gjk_sar64(x - correction + (INT64_C(1) << 29), 30);
}

bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]) {
  int64_t deviation;
  if (!gjk_quat_deviation(q, &deviation)) {
    return false;
  }
  // 1 - 1 / |q|^2 = e - e^2 + ... for e = |q|^2 - 1, in Q46: |e| <= 2^30, e^2 / 2^46 <= 2^14, the rest below 1.
  const int32_t e = (int32_t)gjk_sar64(deviation, 14);
  const int32_t excess = e - (int32_t)gjk_sar64(gjk_mul32(e, e), 46);
  // Products are at most 2^60 (1 + 2^-16) in size, and so is each entry: |q|^2 bounds it.
  const int64_t xx = gjk_mul32(q->x, q->x), yy = gjk_mul32(q->y, q->y), zz = gjk_mul32(q->z, q->z);
  const int64_t ww = gjk_mul32(q->w, q->w);
  const int64_t xy = gjk_mul32(q->x, q->y), xz = gjk_mul32(q->x, q->z), yz = gjk_mul32(q->y, q->z);
  const int64_t wx = gjk_mul32(q->w, q->x), wy = gjk_mul32(q->w, q->y), wz = gjk_mul32(q->w, q->z);
  rows[0].x = gjk_corrected_q30(ww + xx - yy - zz, excess);
  rows[0].y = gjk_corrected_q30(2 * (xy - wz), excess);
  rows[0].z = gjk_corrected_q30(2 * (xz + wy), excess);
  rows[1].x = gjk_corrected_q30(2 * (xy + wz), excess);
  rows[1].y = gjk_corrected_q30(ww - xx + yy - zz, excess);
  rows[1].z = gjk_corrected_q30(2 * (yz - wx), excess);
  rows[2].x = gjk_corrected_q30(2 * (xz - wy), excess);
  rows[2].y = gjk_corrected_q30(2 * (yz + wx), excess);
  rows[2].z = gjk_corrected_q30(ww - xx - yy + zz, excess);
  return true;
}

// row . v from Q30 to LSB, a half up. |row| <= 2^30 + 1 and |v| <= sqrt(3) 2^31: the product is below 2^62.
GJK_ONCE static int64_t component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v) {
  const int64_t sum = gjk_mac32(gjk_mac32(gjk_mul32(x, v->x), y, v->y), z, v->z);
  return gjk_sar64(sum + (INT64_C(1) << 29), 30);
}

// The same where it fits.
GJK_ONCE static int32_t narrow_component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v) {
  const int64_t rotated = component(x, y, z, v);
  //@ assert rotated >= INT32_MIN && rotated <= INT32_MAX;
  return (int32_t)rotated;
}

gjk_vec3 gjk_rotate(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[0].y, rows[0].z, v),
                            narrow_component(rows[1].x, rows[1].y, rows[1].z, v),
                            narrow_component(rows[2].x, rows[2].y, rows[2].z, v)};
  return rotated;
}

gjk_vec3 gjk_rotate_back(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[1].x, rows[2].x, v),
                            narrow_component(rows[0].y, rows[1].y, rows[2].y, v),
                            narrow_component(rows[0].z, rows[1].z, rows[2].z, v)};
  return rotated;
}

void gjk_rotate_wide(const gjk_vec3 rows[3], const gjk_vec3 *v, int64_t out[3]) {
  for (int i = 0; i < 3; i++) {
    out[i] = component(rows[i].x, rows[i].y, rows[i].z, v);
  }
}
