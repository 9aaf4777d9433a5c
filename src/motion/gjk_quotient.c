// Exact products of a quotient and whole numbers.
#include "gjk_quotient.h"

static bool below128(const gjk_u128 *a, const gjk_u128 *b) {
  return a->high != b->high ? a->high < b->high : a->low < b->low;
}

// x 2^n. Pre: it fits; n < 128.
static void shift_left(gjk_u128 *x, unsigned n) {
  if (n >= 64) {
    x->high = x->low;
    x->low = 0;
    n -= 64;
  }
  if (n > 0) {
    x->high = x->high << n | x->low >> (64 - n);
    x->low <<= n;
  }
}

// Sets *rest to 2^32 rest - digit d, 0 <= that < d, and returns the digit. inverse: 2^63 / leading 32 bits of d.
// Pre: 2^95 <= d < 2^96, rest < d.
//
// With rest = 2^64 r + ..., d = 2^64 e + ...: the first guess is r inverse / 2^31.
//   the rest of rest        adds less than 2^32 / e <= 2
//   inverse                 is too small by less than 2, which takes less than 4 from the guess; its floor 1
//   the rest of d           makes the digit smaller by less than digit / e <= 2
// So the guess is within 7 of the digit, and 2^32 rest - guess d is within 7 d of 0: below 2^99 in size.
static uint32_t next_digit(gjk_u128 *rest, const gjk_u128 *d, uint32_t inverse) {
  const uint64_t guess = gjk_umul32((uint32_t)(rest->high & UINT32_MAX), inverse) >> 31;
  uint32_t digit = guess > UINT32_MAX ? UINT32_MAX : (uint32_t)guess;
  // digit d = 2^64 top + (2^32 middle + lowest) in its low words
  const uint64_t lowest = gjk_umul32(digit, (uint32_t)(d->low & UINT32_MAX));
  const uint64_t middle = gjk_umul32(digit, (uint32_t)(d->low >> 32)) + (lowest >> 32);
  const uint64_t top = gjk_umul32(digit, (uint32_t)(d->high & UINT32_MAX)) + (middle >> 32);
  const uint64_t taken = middle << 32 | (lowest & UINT32_MAX), from = rest->low << 32;
  gjk_u128 left = {(rest->high << 32 | rest->low >> 32) - top - (from < taken ? 1u : 0u), from - taken};
  while (left.high > INT64_MAX) {  // negative: at most 7 times
    left.low += d->low;
    left.high += d->high + (left.low < d->low ? 1u : 0u);
    digit--;
  }
  while (!below128(&left, d)) {  // at most 7 times
    left.high -= d->high + (left.low < d->low ? 1u : 0u);
    left.low -= d->low;
    digit++;
  }
  rest->high = left.high;
  rest->low = left.low;
  return digit;
}

void gjk_quotient_set(gjk_quotient *q, const gjk_u128 *numerator, const gjk_u128 *denominator) {
  q->numerator = numerator->low;
  q->denominator = denominator->low;
  q->one = !below128(numerator, denominator);
  q->high = 0;
  if (q->one) {
    return;
  }
  gjk_divisor divisor;
  gjk_divisor_set(&divisor, denominator);
  q->rest.high = numerator->high;
  q->rest.low = numerator->low;
  q->scaled.high = denominator->high;
  q->scaled.low = denominator->low;
  q->inverse = divisor.inverse;
  shift_left(&q->rest, 96 - divisor.bits);
  shift_left(&q->scaled, 96 - divisor.bits);
  q->high = next_digit(&q->rest, &q->scaled, q->inverse);
}

// As gjk_quotient_split of size >= 0. With part = floor(2^64 quotient) and size part = 2^64 k + f, 0 <= f < 2^64:
//   size part <= 2^64 size quotient < size part + size,  size < 2^34
// So floor(size quotient) is k, or k + 1 where f >= 2^64 - size. Then, or where f is 0, the product is within 2^-30 of an
// integer c:  |size numerator - c denominator| < 2^-30 2^93 = 2^63
// modulo 2^64 this difference is exact, and tells on which side of c the product lies.
GJK_OUT_OF_LINE static uint64_t split_exactly(const gjk_quotient *q, uint64_t size, bool *whole) {
  gjk_u128 rest = {q->rest.high, q->rest.low};
  const uint32_t x0 = (uint32_t)(size & UINT32_MAX), x1 = (uint32_t)(size >> 32);  // x1 < 4
  const uint32_t p0 = next_digit(&rest, &q->scaled, q->inverse), p1 = q->high;
  const uint64_t lowest = gjk_umul32(x0, p0);
  const uint64_t middle = gjk_umul32(x0, p1) + (lowest >> 32);               // <= (2^32 - 1) 2^32
  const uint64_t middle2 = gjk_umul32(x1, p0) + (middle & UINT32_MAX);       // < 2^35
  const uint64_t k = gjk_umul32(x1, p1) + (middle >> 32) + (middle2 >> 32);  // < 2^35
  const uint64_t f = middle2 << 32 | (lowest & UINT32_MAX);
  *whole = false;
  if (f != 0 && f <= UINT64_MAX - size) {
    return k;
  }
  const uint64_t nearest = f == 0 ? k : k + 1;
  const int64_t difference = gjk_int64(size * q->numerator - nearest * q->denominator);
  *whole = difference == 0;
  return difference < 0 ? nearest - 1 : nearest;
}

// The first digit alone says, of x below 2^32:  x high <= 2^32 x quotient < x high + x
int64_t gjk_quotient_split(const gjk_quotient *q, int64_t x, bool *whole) {
  const uint64_t size = gjk_magnitude64(x);
  const uint64_t product = gjk_umul32((uint32_t)(size & UINT32_MAX), q->high);
  const uint64_t cut = product & UINT32_MAX;
  uint64_t floor = product >> 32;
  *whole = q->one || x == 0;
  if (*whole) {
    return x;
  }
  if (cut == 0 || cut + size > UINT32_MAX) {
    floor = split_exactly(q, size, whole);
  }
  return x >= 0 ? (int64_t)floor : -(int64_t)floor - (*whole ? 0 : 1);
}
