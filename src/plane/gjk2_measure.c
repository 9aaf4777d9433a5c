// Lengths, unit vectors, distances and weights.
#include "gjk2_measure.h"

#include "../arith/gjk_root.h"

// 2^46 / sqrt(x), within 2^-29 of itself and below 2^31, by Newton's iteration: with u = x / 2^32, 1/4 <= u < 1,
//   1. Start from the line Y = 2.16 - 1.25 u, within 10 % of 1 / sqrt(u).
//   2. Twice in 16 bits: Y += Y (1 - u Y^2) / 2. A relative error e becomes -3/2 e^2: 1.5 %, 2^-11; rounding, 2^-12.
//   3. Twice in 32 bits: 2^-22, 2^-43; rounding leaves 1.5 in 2^30.
// Pre: x >= 2^30.
static inline uint32_t inverse_root(uint32_t x) {
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

GJK_ONCE static void measure_length(gjk2_length *length, gjk2_vec n) {
  const uint64_t squared = (uint64_t)gjk2_dot(n, n);
  //@ assert squared > 0 && squared < UINT64_C(1) << 62;
  const unsigned z = gjk_clz64(squared) / 2;  // squared < 2^62:  z >= 1
  //@ assert z >= 1 && z <= 31;
  length->squared = squared;
  length->zeros = z;
  // With x, 2^30 <= x < 2^32, for the leading bits of squared = 2^(32 - 2 z) x: 2^46 / sqrt(x) = 2^(62 - z) / |n|.
  length->inverse = inverse_root(gjk_upper32(squared, 2 * z));
}

void gjk2_length_set(gjk2_length *length, gjk2_vec n) {
  measure_length(length, n);
}

GJK_ONCE static void measure_unit(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
  // 2^30 n / |n| = n y / 2^(32 - z) = (2^(z - 1) n) y / 2^31
  const unsigned up = length->zeros - 1;
  const int32_t y = (int32_t)length->inverse;  // < 2^31
  const int64_t half = INT64_C(1) << 30;
  unit->x = (gjk_q30)gjk_sar64(gjk_mac32(half, gjk_shl32(n.x, up), y), 31);
  unit->y = (gjk_q30)gjk_sar64(gjk_mac32(half, gjk_shl32(n.y, up), y), 31);
  //@ assert unit->x >= -GJK_Q30_ONE - 2 && unit->x <= GJK_Q30_ONE + 2;
  //@ assert unit->y >= -GJK_Q30_ONE - 2 && unit->y <= GJK_Q30_ONE + 2;
}

void gjk2_unit_set(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
  measure_unit(unit, length, n);
}

void gjk2_normal_set(gjk2_unit *unit, gjk2_length *length, const gjk2_vec *n) {
  measure_length(length, *n);
  measure_unit(unit, length, *n);
}

// h = 2^(32 - hz) top, before truncation; 1 / |n| = y 2^(z - 62):  h / |n| = top y / 2^(30 + hz - z)
uint64_t gjk2_quotient(const gjk2_length *length, unsigned *shift, uint64_t h) {
  *shift = 0;
  if (h == 0) {
    return 0;
  }
  const unsigned hz = gjk_clz64(h);
  *shift = 30 + hz - length->zeros;  // |n| < 2^31, so z <= 31 and this is from 0 to 92
  return gjk_umul32(gjk_upper32(h, hz), length->inverse);
}

bool gjk2_reaches(uint64_t h, uint64_t squared, uint64_t x, uint64_t rest) {
  gjk_u128 sum;
  //@ assert h < UINT64_C(1) << 62 && x < UINT64_C(1) << 62 && squared < UINT64_C(1) << 62;
  gjk_sum_of_products((int64_t)h, (int64_t)h, -(int64_t)x, (int64_t)squared, &sum);
  // sum - rest, in two's complement: it is below 2^126 in size
  return (sum.high - (sum.low < rest)) <= INT64_MAX;
}

// Is h / |n| at least d + 1/2 (nearest), above d (up), or at least d + 1 (down)?
//   (d + 1/2)^2 = d (d + 1) + 1/4
static bool plane_is_beyond(const gjk2_length *length, uint64_t h, uint64_t d, gjk2_round_to to) {
  const uint64_t squared = length->squared;
  switch (to) {
    case GJK2_ROUND_NEAREST: return gjk2_reaches(h, squared, d * (d + 1), (squared + 3) >> 2);
    case GJK2_ROUND_UP: return gjk2_reaches(h, squared, d * d, 1);
    case GJK2_ROUND_DOWN: break;
  }
  return gjk2_reaches(h, squared, (d + 1) * (d + 1), 0);
}

// The least integer that the distance is not beyond, from the leading bits of the quotient, which tell it within 10.
GJK_OUT_OF_LINE static int64_t plane_settle_distance(const gjk2_length *length, uint64_t h, uint32_t leading,
                                                     unsigned shift, gjk2_round_to to) {
  uint64_t d = shift < 32 ? (uint64_t)leading << (32 - shift) : shift < 64 ? leading >> (shift - 32) : 0;
  while (d > 0 && !plane_is_beyond(length, h, d - 1, to)) {  // at most 10 steps
    d--;
  }
  while (plane_is_beyond(length, h, d, to)) {  // at most 10 steps
    d++;
  }
  //@ assert d <= UINT32_MAX;
  return (int64_t)d;
}

// Mostly the leading 31 bits of the quotient tell: those below the last LSB are far enough from a change. Near a change, at
// c or c - 1/2, the sign of 4 h^2 - u^2 |n|^2 tells, for u = 2 c or 2 c - 1; rounding up, u = 2 (c - 1). With x = h / |n|
// within 20 of u / 2 in units of 2^-n:
//   |4 h^2 - u^2 |n|^2| = |n|^2 |2 x - u| (2 x + u) < 2^(64 - 2 zeros) 2^(5.4 - n) 2^(34 - n) < 2^63 for n + zeros >= 21
// So the difference of the squares modulo 2^64 has that sign.
int64_t gjk2_round_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h) {
  unsigned shift;
  const uint64_t quotient = gjk2_quotient(length, &shift, h);
  const uint32_t leading = (uint32_t)(quotient >> 32);  // below 2^31, and off by less than 2^3 + 1
  if (shift >= 38 && shift <= 62) {
    const unsigned n = shift - 32;
    const uint32_t mask = (UINT32_C(1) << n) - 1;
    const uint32_t biased = leading + (to == GJK2_ROUND_UP ? mask : to == GJK2_ROUND_NEAREST ? (mask >> 1) + 1 : 0);
    const uint32_t fraction = biased & mask;
    if (fraction > 10 && fraction < mask - 10) {
      return biased >> n;
    }
    if (n + length->zeros >= 21) {
      const uint32_t c = (biased + 16) >> n;  // biased < 2^32 - 2^27, since leading < 2^31 and n <= 30
      const uint64_t u = 2 * (uint64_t)c - (to == GJK2_ROUND_UP ? 2 : to == GJK2_ROUND_NEAREST ? 1 : 0);
      const int64_t beyond = gjk_int64(4 * h * h - u * u * length->squared);
      return beyond > 0 || (beyond == 0 && to != GJK2_ROUND_UP) ? c : c - INT64_C(1);
    }
  }
  return plane_settle_distance(length, h, leading, shift, to);
}

bool gjk2_is_within(int64_t h, gjk2_vec n, int32_t radius) {
  const uint32_t x = gjk_magnitude32(n.x), y = gjk_magnitude32(n.y), r = (uint32_t)radius;
  const uint64_t size = (uint64_t)h;
  if (size > gjk_umul32(gjk2_length_bound(n), r)) {
    return false;
  }
  if (size <= gjk_umul32(x > y ? x : y, r)) {
    return true;
  }
  return !gjk2_reaches(size, (uint64_t)gjk2_dot(n, n), gjk_umul32(r, r), 1);
}

int32_t gjk2_weight(const gjk2_length *length, bool fine, int64_t part) {
  if (part <= 0) {
    return 0;
  }
  // 1 / whole = y^2 2^(2 z - 124), and y^2 2^-30 = square < 2^32:  1 / whole = square 2^(2 z - 94).
  const uint32_t square = (uint32_t)(gjk_umul32(length->inverse, length->inverse) >> 30);
  const unsigned pz = gjk_clz64((uint64_t)part);
  const uint64_t product = gjk_umul32(gjk_upper32((uint64_t)part, pz), square);
  const unsigned shift = 31 + pz - 2 * length->zeros;  // part <= whole, so pz >= 2 z
  uint32_t weight = shift < 64 ? (uint32_t)(product >> shift) : 0;
  weight = weight < INT32_MAX ? weight : INT32_MAX;
  if (fine) {
    // With both below 2^50, the remainder part 2^31 - weight whole is below 2^50 2^4: it survives modulo 2^64.
    const unsigned cut = length->zeros < 7 ? 14 - 2 * length->zeros : 0;
    const int64_t whole = (int64_t)(length->squared >> cut);
    int64_t rest = gjk_int64(((uint64_t)(part >> cut) << 31) - (uint64_t)weight * (uint64_t)whole);
    for (int i = 0; i < 24 && rest >= whole && weight < INT32_MAX; i++) {  // the error is below 2^31 2^-27 = 16
      rest -= whole;
      weight++;
    }
    for (int i = 0; i < 24 && rest < 0 && weight > 0; i++) {
      rest += whole;
      weight--;
    }
  }
  return (int32_t)weight;
}
