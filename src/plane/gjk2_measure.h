// Lengths, unit vectors and distances: rounded for what a query reports, exact for what it decides.
//
// A line is given by a vector n across it and a product h = n . w with a point w of it. Its distance from the origin is
// |h| / |n|. Everything here is stated for
//   |n| <= 3 2^29,  h <= 9 2^58,  the distance at most 3 2^29
#ifndef GJK2_SRC_MEASURE_H
#define GJK2_SRC_MEASURE_H

#include "gjk2_vector.h"

// 1 / |n|, rounded, for several uses.
typedef struct gjk2_length {
  uint64_t squared;  // |n|^2
  uint32_t inverse;  // 2^(62 - zeros) / |n|, within 2^-29 of itself
  unsigned zeros;    // half the leading zeros of squared, rounded down
} gjk2_length;

static inline void gjk2_copy_length(gjk2_length *to, const gjk2_length *from) {
  to->squared = from->squared;
  to->inverse = from->inverse;
  to->zeros = from->zeros;
}

// Pre: n != 0, |n| < 2^31.
void gjk2_length_set(gjk2_length *length, gjk2_vec n);

// *unit = n / |n|, Q2.30, each component within 2 LSB.
void gjk2_unit_set(gjk2_unit *unit, const gjk2_length *length, gjk2_vec n);

// Both: the length and the unit vector of n.
void gjk2_normal_set(gjk2_unit *unit, gjk2_length *length, const gjk2_vec *n);

// The leading 63 bits of h / |n|: (returned) / 2^*shift. Its error is below 2^-28 of it, and 1.
uint64_t gjk2_quotient(const gjk2_length *length, unsigned *shift, uint64_t h);

typedef enum gjk2_round_to { GJK2_ROUND_DOWN, GJK2_ROUND_NEAREST, GJK2_ROUND_UP } gjk2_round_to;

// h / |n| as an integer, exactly rounded; to the nearest: a tie up.
int64_t gjk2_round_distance(const gjk2_length *length, gjk2_round_to to, uint64_t h);

// Is h^2 >= x squared + rest? Exact. Pre: h, x and squared are below 2^62, rest is below 2^63.
bool gjk2_reaches(uint64_t h, uint64_t squared, uint64_t x, uint64_t rest);

// floor(sqrt(x)). near: what it is likely close to, or 0. Pre: x < 2^62, near < 2^31.
uint32_t gjk2_root(uint64_t x, uint32_t near);

// Is h / |n| at most radius? Exact. Pre: 0 <= h, 0 <= radius < 2^31.
bool gjk2_is_within(int64_t h, gjk2_vec n, int32_t radius);

// |n|, rounded up: not less than it, and at most 1/8 more. Pre: components below 2^31 in size.
static inline uint32_t gjk2_length_bound(gjk2_vec n) {
  const uint32_t x = gjk_magnitude32(n.x), y = gjk_magnitude32(n.y);
  return x > y ? x + (y >> 1) + 1 : y + (x >> 1) + 1;  // sqrt(1 + t^2) <= 1 + t / 2 for 0 <= t <= 1
}

// part / whole in Q31, at most 2^31 - 1; within 2^-27 of itself. fine: within 1. Pre: 0 <= part <= whole < 2^62,
// 0 < whole; length is that of a vector with squared = whole.
int32_t gjk2_weight(const gjk2_length *length, bool fine, int64_t part);

#endif
