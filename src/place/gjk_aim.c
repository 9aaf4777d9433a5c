// Rotations that aim: from one direction to another, and along a segment.
#include "gjk/math.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_vector.h"

// x / 2^down to the nearest. Pre: the sum fits.
static int32_t nearest_shift(int64_t x, unsigned down) {
  return down == 0 ? (int32_t)x : (int32_t)gjk_sar64(x + (INT64_C(1) << (down - 1)), down);
}

// The unit quaternion along four numbers, shifted so that the largest is at most 2^30. Pre: one is not 0, each |x| < 2^62.
static void normalize_wide(const int64_t q[4], gjk_quat *out) {
  const uint64_t bits = gjk_magnitude64(q[0]) | gjk_magnitude64(q[1]) | gjk_magnitude64(q[2]) | gjk_magnitude64(q[3]);
  const unsigned zeros = gjk_clz64(bits), down = zeros < 34 ? 34 - zeros : 0;
  const gjk_quat narrow = {nearest_shift(q[0], down), nearest_shift(q[1], down), nearest_shift(q[2], down),
                           nearest_shift(q[3], down)};
  (void)gjk_quat_normalize(&narrow, out);  // it is not zero: its largest keeps 30 bits, or all
}

// Half a turn about an axis across u, near the coordinate axis of u's least component.
static void half_turn_across(const gjk_unit3 *u, gjk_quat *out) {
  const uint32_t x = gjk_magnitude32(u->x), y = gjk_magnitude32(u->y), z = gjk_magnitude32(u->z);
  // e - (e . u) u for the least component e, Q60: each is at most 2^60 in size
  const int64_t one = INT64_C(1) << 60;
  const gjk_q30 least = x <= y && x <= z ? u->x : y <= z ? u->y : u->z;
  int64_t axis[4] = {-gjk_mul32(least, u->x), -gjk_mul32(least, u->y), -gjk_mul32(least, u->z), 0};
  axis[x <= y && x <= z ? 0 : y <= z ? 1 : 2] += one;
  normalize_wide(axis, out);
}

// Errors, in LSB of Q30: rounding u and v 0.9 each; rounding c 0.9 (half of 2^-29 along three axes), 1 - dot 0.5, and the
// four numbers 1; the unit quaternion 1. So the quaternion is within 5 of its direction, what it turns within 2 (3.4) + 1.8.
gjk_status gjk_quat_between(const gjk_vec3 *from, const gjk_vec3 *to, gjk_quat *out) {
  if (from == NULL || to == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_unit3 u, v;
  if (gjk_vec3_normalize(from, &u) != GJK_OK || gjk_vec3_normalize(to, &v) != GJK_OK) {
    return GJK_ERROR_ROTATION;
  }
  // The sine's axis u x v and the cosine u . v, Q60: each below 2^60 + 2^31
  const gjk_vec3 a = {u.x, u.y, u.z}, b = {v.x, v.y, v.z};
  gjk_long3 cross;
  gjk_cross(&a, &b, &cross);
  const int64_t dot = gjk_dot(&a, &b), one = INT64_C(1) << 60;
  if (dot >= 0) {
    const int64_t q[4] = {cross.x, cross.y, cross.z, one + dot};
    normalize_wide(q, out);
    return GJK_OK;
  }
  // 1 + dot is too small a difference here. |cross|^2 = (1 + dot) (1 - dot), so the quaternion is along
  // (cross (1 - dot), |cross|^2). cross = c 2^(34 - zeros), with c at most 2^30 in size.
  const uint64_t bits = gjk_magnitude64(cross.x) | gjk_magnitude64(cross.y) | gjk_magnitude64(cross.z);
  if (bits == 0) {
    half_turn_across(&u, out);
    return GJK_OK;
  }
  const unsigned zeros = gjk_clz64(bits);                   // 3 to 63: bits < 2^61
  const int32_t difference = nearest_shift(one - dot, 31);  // 2^29 to 2^30: half of 1 - dot, Q30
  int32_t c[3];
  const int64_t from_cross[3] = {cross.x, cross.y, cross.z};
  for (int i = 0; i < 3; i++) {
    c[i] = zeros < 34 ? nearest_shift(from_cross[i], 34 - zeros) : (int32_t)gjk_shl64(from_cross[i], zeros - 34);
  }
  // cross = c 2^(34 - zeros); the whole quaternion is divided by 2^(31 + 34 - zeros):
  // cross (1 - dot) = c difference 2^(31 + 34 - zeros), and |cross|^2 = |c|^2 2^(68 - 2 zeros) takes 2^(3 - zeros)
  const int64_t square = gjk_mac32(gjk_mac32(gjk_mul32(c[0], c[0]), c[1], c[1]), c[2], c[2]);  // at most 3 2^60
  const int64_t q[4] = {gjk_mul32(c[0], difference), gjk_mul32(c[1], difference), gjk_mul32(c[2], difference),
                        gjk_sar64(square, zeros - 3)};
  normalize_wide(q, out);
  return GJK_OK;
}

gjk_status gjk_pose_between(const gjk_vec3 *p, const gjk_vec3 *q, gjk_pose *out, gjk_q16 *half_length) {
  if (p == NULL || q == NULL || out == NULL || half_length == NULL) {
    return GJK_ERROR_NULL;
  }
  const int64_t x = (int64_t)q->x - p->x, y = (int64_t)q->y - p->y, z = (int64_t)q->z - p->z;
  // Where the way is longer than int32 its half is taken: 1 of 2^31.
  const unsigned down = x != gjk_saturate(x) || y != gjk_saturate(y) || z != gjk_saturate(z) ? 1 : 0;
  const gjk_vec3 way = {(int32_t)gjk_sar64(x, down), (int32_t)gjk_sar64(y, down), (int32_t)gjk_sar64(z, down)};
  const uint32_t wx = gjk_magnitude32(way.x), wy = gjk_magnitude32(way.y), wz = gjk_magnitude32(way.z);
  const uint64_t squared = gjk_umul32(wx, wx) + gjk_umul32(wy, wy) + gjk_umul32(wz, wz);  // at most 3 2^62
  // Half of a root from 2 k to 2 k + 1 is nearest to k, of one from 2 k + 1 to 2 k + 2 to k + 1.
  const uint32_t half = down != 0 ? gjk_nearest_root(squared) : (gjk_isqrt64(squared) + 1) / 2;
  if (half > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  const gjk_vec3 up = {0, 0, GJK_Q16_ONE};
  const gjk_quat still = {0, 0, 0, GJK_Q30_ONE};
  out->rotation = still;
  if (squared != 0) {  // then way is not zero
    (void)gjk_quat_between(&up, &way, &out->rotation);
  }
  out->position.x = (gjk_q16)gjk_sar64((int64_t)p->x + q->x, 1);
  out->position.y = (gjk_q16)gjk_sar64((int64_t)p->y + q->y, 1);
  out->position.z = (gjk_q16)gjk_sar64((int64_t)p->z + q->z, 1);
  *half_length = (gjk_q16)half;
  return GJK_OK;
}
