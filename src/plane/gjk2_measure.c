// Lengths, unit vectors, distances and weights.
#include "gjk2_measure.h"

#include "gjk2_measure_inline.h"

GJK_ONCE static void measure_length(gjk2_length *length, gjk2_vec n) {
  gjk2_inline_length(length, n);
}

GJK_ONCE static void measure_unit(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
  gjk2_inline_unit(unit, length, n);
}

void gjk2_length_set(gjk2_length *length, gjk2_vec n) {
  measure_length(length, n);
}

void gjk2_unit_set(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n) {
  measure_unit(unit, length, n);
}

void gjk2_normal_set(gjk2_unit *unit, gjk2_length *length, const gjk2_vec *n) {
  measure_length(length, *n);
  measure_unit(unit, length, *n);
}

uint64_t gjk2_quotient(const gjk2_length *length, unsigned *shift, uint64_t h) {
  return gjk2_inline_quotient(length, shift, h);
}

// With top for the leading 32 bits of x 2^zeros, top 2^46 / sqrt(top) is 2^16 sqrt(top) in units of 2^-30. It is off by
// less than 2^32 2^-29 + 2, and by half of that once it is shifted: zeros is 2 or more.
uint32_t gjk2_root(uint64_t x, uint32_t near) {
  if (GJK_SMALL || x == 0) {
    return gjk_isqrt64(x);
  }
  uint32_t root = near;
  int64_t rest = gjk_int64(x - gjk_umul32(root, root));
  if (gjk_magnitude64(rest) >= 8 * (uint64_t)root) {
    const unsigned zeros = gjk_clz64(x) & ~1u;
    const uint32_t top = gjk_upper32(x, zeros);
    root = (uint32_t)(gjk_umul32(top, gjk2_inverse_root(top)) >> (30 + zeros / 2));  // below 2^31 + 5
    rest = gjk_int64(x - gjk_umul32(root, root));
  }
  for (int i = 0; i < 8 && rest < 0; i++) {  // not reached: 8, as for the next loop
    root--;
    rest += 2 * (int64_t)root + 1;
  }
  for (int i = 0; i < 8 && rest > 2 * (int64_t)root; i++) {
    rest -= 2 * (int64_t)root + 1;
    root++;
  }
  return root;
}

bool gjk2_reaches(uint64_t h, uint64_t squared, uint64_t x, uint64_t rest) {
  //@ assert h < UINT64_C(1) << 62 && x < UINT64_C(1) << 62 && squared < UINT64_C(1) << 62;
#if GJK_INT128
  return (GJK_INT128_TYPE)h * h - (GJK_INT128_TYPE)x * squared >= (GJK_INT128_TYPE)rest;  // below 2^124
#else
  gjk_u128 sum;
  gjk_sum_of_products((int64_t)h, (int64_t)h, -(int64_t)x, (int64_t)squared, &sum);
  // sum - rest, in two's complement: it is below 2^126 in size
  return (sum.high - (sum.low < rest)) <= INT64_MAX;
#endif
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

GJK_OUT_OF_LINE int64_t gjk2_settle_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h, uint32_t leading,
                                             unsigned shift) {
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

int64_t gjk2_round_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h) {
  return gjk2_inline_distance(length, to, h);
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
