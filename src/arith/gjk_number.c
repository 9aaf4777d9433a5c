// Fixed-point numbers for users.
#include "gjk/number.h"

#include "gjk_root.h"
#include "gjk_sine.h"

// x as Q16.16 with the sign of negative, or the end of the range.
static gjk_q16 signed_q16(uint64_t x, bool negative) {
  return gjk_saturate(x > UINT32_MAX ? (negative ? INT64_MIN : INT64_MAX) : negative ? -(int64_t)x : (int64_t)x);
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
  return x <= 0 ? 0 : (gjk_q16)gjk_nearest_root((uint64_t)x << 16);  // below 2^24
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
