// Integers of 256 bits, for what is computed once in a shape's life: mass properties.
//
// Numbers are in two's complement, least significant limb first. Sums and products are modulo 2^256, so they are right
// for negative numbers too, where the true result is below 2^255 in size. Each user bounds its numbers.
#ifndef GJK_SRC_BIG_H
#define GJK_SRC_BIG_H

#include "gjk_wide.h"

#define GJK_BIG_LIMBS 8

typedef struct gjk_big {
  uint32_t limb[GJK_BIG_LIMBS];
} gjk_big;

// x = value.
void gjk_big_set(gjk_big *x, int64_t value);
// x = 2^31 high + low.
void gjk_big_set_long(gjk_big *x, int64_t high, uint32_t low);
// *to = *from.
void gjk_big_copy(gjk_big *to, const gjk_big *from);
// x += y. x may be y.
void gjk_big_add(gjk_big *x, const gjk_big *y);
// x -= y.
void gjk_big_subtract(gjk_big *x, const gjk_big *y);
// x *= factor.
void gjk_big_scale(gjk_big *x, uint32_t factor);
// out = x y. out is neither x nor y.
void gjk_big_multiply(gjk_big *out, const gjk_big *x, const gjk_big *y);
// x += y factor.
void gjk_big_add_product(gjk_big *x, const gjk_big *y, int64_t factor);

static inline bool gjk_big_is_negative(const gjk_big *x) {
  return (x->limb[GJK_BIG_LIMBS - 1] >> 31) != 0;
}

bool gjk_big_is_zero(const gjk_big *x);

// x *= 2^bits modulo 2^256. Pre: bits < 256.
void gjk_big_shift_up(gjk_big *x, unsigned bits);
// x = floor(x / 2^bits). Pre: x >= 0, bits < 256.
void gjk_big_shift_down(gjk_big *x, unsigned bits);
// x >= y. Pre: neither is negative.
bool gjk_big_is_at_least(const gjk_big *x, const gjk_big *y);

// x = floor(x / y). Pre: y > 0.
void gjk_big_divide(gjk_big *x, const gjk_big *y);

// The integer nearest to x / y, a half up. x is spent. Pre: y > 0, |2 x + y| < 2^255, |x / y| < 2^62.
int64_t gjk_big_nearest(gjk_big *x, const gjk_big *y);

// x as an int64_t. Pre: |x| < 2^63.
static inline int64_t gjk_big_low(const gjk_big *x) {
  return gjk_int64((uint64_t)x->limb[1] << 32 | x->limb[0]);
}

#endif
