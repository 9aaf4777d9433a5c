// Fixed-point numbers and vectors for users.
#include "gjk/math.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_sine.h"
#include "../arith/gjk_vector.h"

// x as Q16.16 with the sign of negative, or the end of the range.
static gjk_q16 signed_q16(uint64_t x, bool negative) {
  return gjk_saturate(x > UINT32_MAX ? (negative ? INT64_MIN : INT64_MAX) : negative ? -(int64_t)x : (int64_t)x);
}

// The root of x to the nearest. Pre: x < 2^64 - 2^32, so that it fits.
static uint32_t nearest_root(uint64_t x) {
  const uint32_t root = gjk_isqrt64(x);
  return root + (x - gjk_umul32(root, root) > root ? 1u : 0u);  // x > root^2 + root:  x >= (root + 1/2)^2
}

gjk_q16 gjk_q16_multiply(gjk_q16 a, gjk_q16 b) {
  const uint64_t product = gjk_umul32(gjk_magnitude32(a), gjk_magnitude32(b));  // at most 2^62
  return signed_q16((product + 32768) >> 16, (a < 0) != (b < 0));
}

gjk_q16 gjk_q16_divide(gjk_q16 a, gjk_q16 b) {
  const uint64_t divisor = gjk_magnitude32(b);         // at most 2^31
  uint64_t rest = (uint64_t)gjk_magnitude32(a) << 16;  // at most 2^47
  const bool negative = (a < 0) != (b < 0);
  if (rest >= divisor << 31) {  // at most 2^62; so for every a / 0
    return a == 0 ? 0 : negative ? INT32_MIN : INT32_MAX;
  }
  uint32_t quotient = 0;
  for (int bit = 30; bit >= 0; bit--) {
    if (rest >= divisor << bit) {
      rest -= divisor << bit;
      quotient |= UINT32_C(1) << bit;
    }
  }
  return signed_q16(quotient + (2 * rest >= divisor ? UINT64_C(1) : 0), negative);
}

gjk_q16 gjk_q16_sqrt(gjk_q16 x) {
  return x <= 0 ? 0 : (gjk_q16)nearest_root((uint64_t)x << 16);  // below 2^24
}

void gjk_sine_and_cosine(gjk_angle angle, gjk_q30 *sine, gjk_q30 *cosine) {
  gjk_sine_cosine(angle, 2 * gjk_half_turns(gjk_magnitude32(angle)), sine, cosine);
}

// 2^32 atan(2^-i). From i = 11 on that is 2^(32 - i), to less than half of an LSB.
#define ATAN_ENTRIES 11
#define ATAN_STEPS 31

// 2^32 pi.
#define PI_Q32 INT64_C(13493037705)

gjk_angle gjk_atan2(gjk_q16 y, gjk_q16 x) {
  static const uint32_t atan[ATAN_ENTRIES] = {UINT32_C(3373259426), UINT32_C(1991351318), UINT32_C(1052175346),
                                              UINT32_C(534100635),  UINT32_C(268086748),  UINT32_C(134174063),
                                              UINT32_C(67103403),   UINT32_C(33553749),   UINT32_C(16777131),
                                              UINT32_C(8388597),    UINT32_C(4194303)};
  const uint64_t ax = gjk_magnitude32(x), ay = gjk_magnitude32(y);
  if ((ax | ay) == 0) {
    return 0;
  }
  // Turns the vector onto the x axis by angles atan(2^-i), and adds these up, Q32. Both coordinates are below 2^59 first;
  // the turns lengthen the vector by a factor below 1.65. After i steps the rest of the angle is at most atan(2^-i).
  const unsigned up = gjk_clz64(ax | ay) - 5;  // at least 27
  int64_t along = gjk_int64(ax << up), across = gjk_int64(ay << up), angle = 0;
  for (unsigned i = 0; i < ATAN_STEPS; i++) {
    const int64_t along_part = gjk_sar64(along, i), across_part = gjk_sar64(across, i);
    const int64_t step = i < ATAN_ENTRIES ? (int64_t)atan[i] : INT64_C(1) << (32 - i);
    if (across > 0) {
      along += across_part;
      across -= along_part;
      angle += step;
    } else {
      along -= across_part;
      across += along_part;
      angle -= step;
    }
  }
  // Errors: half an LSB of Q32 a step, and the rest, below 2^-30: together less than 20 LSB, 0.001 of the result's.
  if (x < 0) {
    angle = PI_Q32 - angle;
  }
  const gjk_angle rounded = (gjk_angle)gjk_sar64(angle + 32768, 16);
  return y < 0 ? -rounded : rounded;
}

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

// a + b, or the end of the range.
static int64_t saturated_sum(int64_t a, int64_t b) {
  const int64_t sum = gjk_int64((uint64_t)a + (uint64_t)b);
  return (a < 0) == (b < 0) && (sum < 0) != (a < 0) ? (a < 0 ? INT64_MIN : INT64_MAX) : sum;
}

int64_t gjk_vec3_dot(const gjk_vec3 *a, const gjk_vec3 *b) {
  const int64_t x = gjk_mul32(a->x, b->x), y = gjk_mul32(a->y, b->y), z = gjk_mul32(a->z, b->z);
  // Each is from 2^31 - 2^62 to 2^62. Only a sum of equal signs can leave int64, so those of unlike signs go first.
  return (x < 0) == (y < 0) ? saturated_sum(saturated_sum(x, z), y) : saturated_sum(x + y, z);
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
  return nearest_root(gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z));  // at most 3 2^62
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
