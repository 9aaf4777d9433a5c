// An exact fraction of a way: a quotient from 0 to 1, and its products with integers.
#ifndef GJK_SRC_QUOTIENT_H
#define GJK_SRC_QUOTIENT_H

#include "../arith/gjk_wide.h"

typedef struct gjk_quotient {
  gjk_u128 rest, scaled;            // of a quotient below 1: what is left of the numerator after the first digit, over
  uint64_t numerator, denominator;  // the denominator, scaled to 96 bits; both modulo 2^64
  uint32_t high;                    // the first digit, floor(2^32 quotient), or 0 where it is 1
  uint32_t inverse;                 // 2^63 / leading 32 bits of the denominator
  bool one;                         // the quotient is 1
} gjk_quotient;

// Pre: numerator <= denominator, 0 < denominator < 2^93.
void gjk_quotient_set(gjk_quotient *q, const gjk_u128 *numerator, const gjk_u128 *denominator);

// floor(x quotient), exact. *whole: x quotient is an integer. Pre: |x| < 2^34.
int64_t gjk_quotient_split(const gjk_quotient *q, int64_t x, bool *whole);

// floor(x quotient), exact. Pre: |x| < 2^34.
static inline int64_t gjk_quotient_floor(const gjk_quotient *q, int64_t x) {
  bool whole;
  return gjk_quotient_split(q, x, &whole);
}

// x quotient to the nearest integer, a tie up. Pre: |x| < 2^33.
static inline int64_t gjk_quotient_nearest(const gjk_quotient *q, int64_t x) {
  return gjk_sar64(gjk_quotient_floor(q, 2 * x) + 1, 1);
}

#endif
