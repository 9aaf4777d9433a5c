// Vectors for users.
#include "gjk/math.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_vector.h"

gjk_vec3 gjk_vec3_add(const gjk_vec3 *a, const gjk_vec3 *b) {
  const gjk_vec3 sum = {gjk_saturate((int64_t)a->x + b->x), gjk_saturate((int64_t)a->y + b->y),
                        gjk_saturate((int64_t)a->z + b->z)};
  return sum;
}

gjk_vec3 gjk_vec3_subtract(const gjk_vec3 *a, const gjk_vec3 *b) {
  const gjk_vec3 difference = {gjk_saturate((int64_t)a->x - b->x), gjk_saturate((int64_t)a->y - b->y),
                               gjk_saturate((int64_t)a->z - b->z)};
  return difference;
}

gjk_vec3 gjk_vec3_scale(const gjk_vec3 *a, gjk_q16 s) {
  const gjk_vec3 product = {gjk_q16_multiply(a->x, s), gjk_q16_multiply(a->y, s), gjk_q16_multiply(a->z, s)};
  return product;
}

int64_t gjk_vec3_dot(const gjk_vec3 *a, const gjk_vec3 *b) {
  const int64_t x = gjk_mul32(a->x, b->x), y = gjk_mul32(a->y, b->y), z = gjk_mul32(a->z, b->z);
  // Each is from 2^31 - 2^62 to 2^62. Only a sum of equal signs can leave int64, so those of unlike signs go first.
  return (x < 0) == (y < 0) ? gjk_saturated_sum(gjk_saturated_sum(x, z), y) : gjk_saturated_sum(x + y, z);
}

// (a d - b c) / 2^16 to the nearest, halves up.
static gjk_q16 minor_q16(gjk_q16 a, gjk_q16 b, gjk_q16 c, gjk_q16 d) {
  // Both halves of the difference, with the 16 bits below them apart: |p|, |q| <= 2^62
  const int64_t p = gjk_mul32(a, d), q = gjk_mul32(b, c);
  const int64_t low = (int64_t)((uint64_t)p & 65535) - (int64_t)((uint64_t)q & 65535) + 32768;
  return gjk_saturate(gjk_sar64(p, 16) - gjk_sar64(q, 16) + gjk_sar64(low, 16));
}

gjk_vec3 gjk_vec3_cross(const gjk_vec3 *a, const gjk_vec3 *b) {
  const gjk_vec3 cross = {minor_q16(a->y, a->z, b->y, b->z), minor_q16(a->z, a->x, b->z, b->x),
                          minor_q16(a->x, a->y, b->x, b->y)};
  return cross;
}

uint32_t gjk_vec3_length(const gjk_vec3 *a) {
  const uint32_t x = gjk_magnitude32(a->x), y = gjk_magnitude32(a->y), z = gjk_magnitude32(a->z);
  return gjk_nearest_root(gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z));  // at most 3 2^62
}

gjk_status gjk_vec3_normalize(const gjk_vec3 *a, gjk_unit3 *out) {
  if (a == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_quat direction = {a->x, a->y, a->z, 0};
  gjk_quat unit;
  const gjk_status status = gjk_quat_normalize(&direction, &unit);
  if (status == GJK_OK) {
    out->x = unit.x;
    out->y = unit.y;
    out->z = unit.z;
  }
  return status;
}

// Q60 to Q30, down.
static int32_t from_q60(int64_t x) {
  return (int32_t)gjk_sar64(x, 30);
}

// Errors, in 2^-30 of a radian: u and v 0.9 each, the shifts 1.8, the root 0.5: 2^-12 LSB, beside that of gjk_atan2.
gjk_angle gjk_vec3_angle(const gjk_vec3 *a, const gjk_vec3 *b) {
  gjk_unit3 u, v;
  if (gjk_vec3_normalize(a, &u) != GJK_OK || gjk_vec3_normalize(b, &v) != GJK_OK) {
    return 0;
  }
  const gjk_vec3 p = {u.x, u.y, u.z}, q = {v.x, v.y, v.z};
  gjk_long3 cross;
  gjk_cross(&p, &q, &cross);  // at most 2^60 + 2^31 in size, as the dot product is
  const gjk_vec3 sine = {from_q60(cross.x), from_q60(cross.y), from_q60(cross.z)};
  return gjk_atan2((gjk_q16)gjk_vec3_length(&sine), from_q60(gjk_dot(&p, &q)));
}
