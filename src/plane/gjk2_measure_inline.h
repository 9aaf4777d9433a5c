// Lengths, unit vectors and distances in line: what gjk2_measure.c makes functions of.
#ifndef GJK2_SRC_MEASURE_INLINE_H
#define GJK2_SRC_MEASURE_INLINE_H

#include "../arith/gjk_root.h"
#include "gjk2_measure.h"

// 2^46 / sqrt(x), within 2^-29 of itself and below 2^31, by Newton's iteration: with u = x / 2^32, 1/4 <= u < 1,
//   1. Start from the line Y = 2.16 - 1.25 u, within 10 % of 1 / sqrt(u).
//   2. Twice in 16 bits: Y += Y (1 - u Y^2) / 2. A relative error e becomes -3/2 e^2: 1.5 %, 2^-11; rounding, 2^-12.
//   3. Twice in 32 bits: 2^-22, 2^-43; rounding leaves 1.5 in 2^30.
// Pre: x >= 2^30.
static inline uint32_t gjk2_inverse_root(uint32_t x) {
  const uint32_t u = x >> 16;         // Q16, from 2^14
  uint32_t y = 35389 - (u * 5 >> 4);  // Q14, from 2^13 to 2^15
  for (int i = 0; i < 2; i++) {
    const uint32_t square = y * y >> 14;                                   // below 2^16
    const int32_t rest = (int32_t)(UINT32_C(65536) - (u * square >> 14));  // Q16, |rest| < 2^15
    y = (uint32_t)((int32_t)y + gjk_sar32((int32_t)y * rest, 17));
  }
#if GJK_NARROW_MULTIPLY
  // gjk_root_step(x, y << 16), of which 16 bits are 0.
  const int64_t rest = gjk_int64((UINT64_C(1) << 62) - gjk_umul32(x, y * y << 2));  // |rest| < 2^52
  const int32_t r = (int32_t)gjk_sar64(rest, 31);
  y = (y << 16) + (uint32_t)((int32_t)y * gjk_sar32(r, 16) + (int32_t)(y * ((uint32_t)r & 0xFFFFu) >> 16));
#else
  y = gjk_root_step(x, y << 16);
#endif
  return gjk_root_step(x, y);
}

static inline void gjk2_inline_length(gjk2_length *length, gjk2_vec n) {
  const uint64_t squared = (uint64_t)gjk2_dot(n, n);
  //@ assert squared > 0 && squared < UINT64_C(1) << 62;
  const unsigned z = gjk_clz64(squared) / 2;  // squared < 2^62:  z >= 1
  //@ assert z >= 1 && z <= 31;
  length->squared = squared;
  length->zeros = z;
  // With x, 2^30 <= x < 2^32, for the leading bits of squared = 2^(32 - 2 z) x: 2^46 / sqrt(x) = 2^(62 - z) / |n|.
  length->inverse = gjk2_inverse_root(gjk_upper32(squared, 2 * z));
}

static inline void gjk2_inline_unit(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
  // 2^30 n / |n| = n y / 2^(32 - z) = (2^(z - 1) n) y / 2^31
  const unsigned up = length->zeros - 1;
  const int32_t y = (int32_t)length->inverse;  // < 2^31
  const int64_t half = INT64_C(1) << 30;
  unit->x = (gjk_q30)gjk_sar64(gjk_mac32(half, gjk_shl32(n.x, up), y), 31);
  unit->y = (gjk_q30)gjk_sar64(gjk_mac32(half, gjk_shl32(n.y, up), y), 31);
  //@ assert unit->x >= -GJK_Q30_ONE - 2 && unit->x <= GJK_Q30_ONE + 2;
  //@ assert unit->y >= -GJK_Q30_ONE - 2 && unit->y <= GJK_Q30_ONE + 2;
}

// h = 2^(32 - hz) top, before truncation; 1 / |n| = y 2^(z - 62):  h / |n| = top y / 2^(30 + hz - z)
static inline uint64_t gjk2_inline_quotient(const gjk2_length *length, unsigned *shift, uint64_t h) {
  *shift = 0;
  if (h == 0) {
    return 0;
  }
  const unsigned hz = gjk_clz64(h);
  *shift = 30 + hz - length->zeros;  // |n| < 2^31, so z <= 31 and this is from 0 to 92
  return gjk_umul32(gjk_upper32(h, hz), length->inverse);
}

// What gjk2_round_distance does where the leading bits of the quotient do not tell: they tell it within 10.
int64_t gjk2_settle_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h, uint32_t leading, unsigned shift);

// Mostly the leading 31 bits of the quotient tell: those below the last LSB are far enough from a change. Near a change, at
// c or c - 1/2, the sign of 4 h^2 - u^2 |n|^2 tells, for u = 2 c or 2 c - 1; rounding up, u = 2 (c - 1). With x = h / |n|
// within 20 of u / 2 in units of 2^-n:
//   |4 h^2 - u^2 |n|^2| = |n|^2 |2 x - u| (2 x + u) < 2^(64 - 2 zeros) 2^(5.4 - n) 2^(34 - n) < 2^63 for n + zeros >= 21
// So the difference of the squares modulo 2^64 has that sign.
// leading: of the quotient, below 2^31, and off by less than 2^3 + 1.
static inline int64_t gjk2_inline_rounded(const gjk2_length *length, gjk2_round_to to, uint64_t h, uint32_t leading,
                                          unsigned shift) {
  if (shift >= 38 && shift <= 62) {
    const unsigned n = shift - 32;
    const uint32_t mask = (UINT32_C(1) << n) - 1;
    const uint32_t biased = leading + (to == GJK2_ROUND_UP ? mask : to == GJK2_ROUND_NEAREST ? (mask >> 1) + 1 : 0);
    const uint32_t fraction = biased & mask;
    if (fraction > 10 && fraction < mask - 10) {
      return biased >> n;
    }
    if (!GJK_SMALL && n + length->zeros >= 21) {
      const uint32_t c = (biased + 16) >> n;  // biased < 2^31 + 2^30
      const uint64_t u = 2 * (uint64_t)c - (to == GJK2_ROUND_UP ? 2 : to == GJK2_ROUND_NEAREST ? 1 : 0);
      const int64_t beyond = gjk_int64(4 * h * h - u * u * length->squared);
      return beyond > 0 || (beyond == 0 && to != GJK2_ROUND_UP) ? c : c - INT64_C(1);
    }
  }
  return gjk2_settle_distance(length, to, h, leading, shift);
}

static inline int64_t gjk2_inline_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h) {
  unsigned shift;
  const uint64_t quotient = GJK_SMALL ? gjk2_quotient(length, &shift, h) : gjk2_inline_quotient(length, &shift, h);
  return gjk2_inline_rounded(length, to, h, (uint32_t)(quotient >> 32), shift);
}

// With k = floor(h / |n|) and depth = m - k for an integer m: does h / |n| surely exceed k by more than depth / 2^28?
// Then depth exceeds m - h / |n| by as much. False: it is not known. leading: the leading bits of h / |n|.
static inline bool gjk2_inline_exceeds(uint32_t leading, unsigned shift, int32_t depth) {
  const unsigned n = shift - 32;
  if (n > 28) {
    return false;
  }
  const uint32_t mask = (UINT32_C(1) << n) - 1;
  // In units of 2^-n: leading is off by less than 9, and depth / 2^28 rounded up is 1 more than this.
  return (leading & mask) > ((uint32_t)depth >> (28 - n)) + 10 && (leading & mask) < mask - 10;
}

// The same, in line where registers hold 64 bits and the code is not chosen for size.
#if GJK_64_BIT && !GJK_SMALL
#define GJK2_IN_LINE 1
#else
#define GJK2_IN_LINE 0
#endif

static inline void gjk2_quick_length(gjk2_length *length, gjk2_vec n) {
#if !GJK2_IN_LINE
  gjk2_length_set(length, n);
#else
  gjk2_inline_length(length, n);
#endif
}

static inline void gjk2_quick_unit(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
#if !GJK2_IN_LINE
  gjk2_unit_set(unit, length, n);
#else
  gjk2_inline_unit(unit, length, n);
#endif
}

static inline void gjk2_quick_normal(gjk2_unit *unit, gjk2_length *length, const gjk2_vec *n) {
#if !GJK2_IN_LINE
  gjk2_normal_set(unit, length, n);
#else
  gjk2_inline_length(length, *n);
  gjk2_inline_unit(unit, length, *n);
#endif
}

static inline int64_t gjk2_quick_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h) {
#if !GJK2_IN_LINE
  return gjk2_round_distance(length, to, h);
#else
  return gjk2_inline_distance(length, to, h);
#endif
}

#endif
