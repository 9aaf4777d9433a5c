// Rotation matrices of unit quaternions, and what they do to vectors.
#include "gjk_rotation.h"

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

// x (1 - excess / 2^46), Q60, as gjk_corrected_q30 has it.
static int64_t corrected(int64_t x, int32_t excess) {
  //@ assert x >= -(INT64_C(33) << 55) && x <= INT64_C(33) << 55;
  // Q30 times Q46, back to Q60: below 2^62 and 2^46. Floors lose 1 in Q30 times excess < 2^-15, and 1 in Q60.
  return x - gjk_sar64(gjk_mul32((int32_t)gjk_sar64(x, 30), excess), 16);
}

// Q60 to the nearest Q30.
static gjk_q30 to_q30(int64_t x) {
  return (gjk_q30)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

gjk_q30 gjk_corrected_q30(int64_t x, int32_t excess) {
  return to_q30(corrected(x, excess));
}

// The rotation matrix of q / |q| by rows, Q60: entries within 2^-43. False, and m not set, as gjk_rotation_from_quat.
static bool fine_matrix(const gjk_quat *q, int64_t m[9]) {
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
  m[0] = corrected(ww + xx - yy - zz, excess);
  m[1] = corrected(2 * (xy - wz), excess);
  m[2] = corrected(2 * (xz + wy), excess);
  m[3] = corrected(2 * (xy + wz), excess);
  m[4] = corrected(ww - xx + yy - zz, excess);
  m[5] = corrected(2 * (yz - wx), excess);
  m[6] = corrected(2 * (xz - wy), excess);
  m[7] = corrected(2 * (yz + wx), excess);
  m[8] = corrected(ww - xx - yy + zz, excess);
  return true;
}

bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]) {
  int64_t m[9];
  if (!fine_matrix(q, m)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    rows[i].x = to_q30(m[3 * i]);
    rows[i].y = to_q30(m[3 * i + 1]);
    rows[i].z = to_q30(m[3 * i + 2]);
  }
  return true;
}

void gjk_rotate_fine(const gjk_quat *q, const gjk_vec3 *v, int64_t out[3]) {
  const int32_t along[3] = {v->x, v->y, v->z};
  int64_t m[9];
  out[0] = out[1] = out[2] = 0;
  if ((v->x | v->y | v->z) == 0 || !fine_matrix(q, m)) {  // not reached: q is a unit
    return;
  }
  for (int i = 0; i < 3; i++) {
    int64_t coarse = 0, fine = 0;
    for (int j = 0; j < 3; j++) {
      // The entry's rest, below half of 2^-30, from Q60 to Q45, where it is at most 2^14: the sum is below 2^47.
      const int64_t entry = m[3 * i + j];
      const gjk_q30 high = to_q30(entry);
      coarse = gjk_mac32(coarse, high, along[j]);
      fine = gjk_mac32(fine, (int32_t)gjk_sar64(entry - gjk_shl64(high, 30), 15), along[j]);
    }
    out[i] = coarse + gjk_sar64(fine, 15);
  }
}

#define HALF (INT32_C(1) << 29)

// row . v + start from Q30 to LSB, cut off. |row| <= 2^30 + 1 and |v| <= sqrt(3) 2^31: the product is below 2^62.
GJK_ONCE static int64_t component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v, int32_t start) {
  const int64_t sum = gjk_mac32(gjk_mac32(gjk_mul32(x, v->x), y, v->y), z, v->z);
  return gjk_sar64(sum + start, 30);
}

// The same where it fits.
GJK_ONCE static int32_t narrow_component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v, int32_t start) {
  const int64_t rotated = component(x, y, z, v, start);
  //@ assert rotated >= INT32_MIN && rotated <= INT32_MAX;
  return (int32_t)rotated;
}

// Half an LSB and a fraction in Q8: from 0 to below 2^30.
static inline int32_t start_at(int8_t fraction) {
  return HALF + fraction * (INT32_C(1) << 22);
}

gjk_vec3 gjk_rotate_onto(const gjk_vec3 rows[3], const gjk_vec3 *v, const int8_t fraction[3]) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[0].y, rows[0].z, v, start_at(fraction[0])),
                            narrow_component(rows[1].x, rows[1].y, rows[1].z, v, start_at(fraction[1])),
                            narrow_component(rows[2].x, rows[2].y, rows[2].z, v, start_at(fraction[2]))};
  return rotated;
}

gjk_vec3 gjk_rotate(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  static const int8_t none[3] = {0, 0, 0};
  return gjk_rotate_onto(rows, v, none);
}

gjk_vec3 gjk_rotate_back(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[1].x, rows[2].x, v, HALF),
                            narrow_component(rows[0].y, rows[1].y, rows[2].y, v, HALF),
                            narrow_component(rows[0].z, rows[1].z, rows[2].z, v, HALF)};
  return rotated;
}

void gjk_rotate_wide(const gjk_vec3 rows[3], const gjk_vec3 *v, int64_t out[3]) {
  for (int i = 0; i < 3; i++) {
    out[i] = component(rows[i].x, rows[i].y, rows[i].z, v, HALF);
  }
}
