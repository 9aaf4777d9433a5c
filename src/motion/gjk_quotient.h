// A fraction of a way, exactly: a quotient from 0 to 1, and what it makes of whole numbers.
#ifndef GJK_SRC_QUOTIENT_H
#define GJK_SRC_QUOTIENT_H

#include "../arith/gjk_wide.h"

typedef struct gjk_quotient {
  uint64_t part;                    // floor(2^64 quotient), or 0 where it is 1
  uint64_t numerator, denominator;  // modulo 2^64
  bool one;                         // the quotient is 1
} gjk_quotient;

// Pre: numerator <= denominator, 0 < denominator < 2^93.
void gjk_quotient_set(gjk_quotient *q, const gjk_u128 *numerator, const gjk_u128 *denominator);

// floor(x quotient), exact. Pre: |x| < 2^34.
int64_t gjk_quotient_floor(const gjk_quotient *q, int64_t x);

// x quotient to the nearest integer, a tie up. Pre: |x| < 2^33.
static inline int64_t gjk_quotient_nearest(const gjk_quotient *q, int64_t x) {
  return gjk_sar64(gjk_quotient_floor(q, 2 * x) + 1, 1);
}

#endif
