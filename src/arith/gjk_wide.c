// Exact sums of products, comparisons and quotients beyond 64 bits: what runs when the high words do not settle a sign.
#include "gjk_wide.h"

#if GJK_SMALL && !GJK_64_BIT
int64_t gjk_sar64_by(int64_t x, unsigned n) {
  return x >> n;  // the compilers that optimise for size shift arithmetically
}

int64_t gjk_shl64_by(int64_t x, unsigned n) {
  return gjk_int64((uint64_t)x << n);
}
#endif

// Long multiplication in digits of 31 bits: p = 2^31 ph + pl, 0 <= pl < 2^31, |ph| <= 2^31 since |p| < 2^62. q, r and s
// alike.
//
//   lowest      pl ql, rl sl     <  2^62                            lowest   <  2^63
//   middle      |ph ql|, |pl qh| <= 2^62 - 2^31, a carry < 2^32    |middle|  <  2^63
//   middle2     |rh sl|, |rl sh| <= 2^62 - 2^31                    |middle2| <  2^63
//   the whole   |p q|, |r s|     <  2^124                          |sum|     <  2^125
void gjk_sum_of_products(int64_t p, int64_t q, int64_t r, int64_t s, gjk_u128 *out) {
  const int32_t ph = gjk_high_digit(p), pl = gjk_low_digit(p), qh = gjk_high_digit(q), ql = gjk_low_digit(q);
  const int32_t rh = gjk_high_digit(r), rl = gjk_low_digit(r), sh = gjk_high_digit(s), sl = gjk_low_digit(s);
  const int64_t lowest = gjk_mac32(gjk_mul32(pl, ql), rl, sl);
  const int64_t middle = gjk_mac32(gjk_mac32(gjk_sar64(lowest, 31), ph, ql), pl, qh);
  const int64_t middle2 = gjk_mac32(gjk_mul32(rh, sl), rl, sh);
  const uint32_t digit = (uint32_t)gjk_low_digit(middle) + (uint32_t)gjk_low_digit(middle2);  // < 2^32
  const int64_t carry = gjk_sar64(middle, 31) + gjk_sar64(middle2, 31) + (digit >> 31);
  const int64_t high = gjk_mac32(gjk_mac32(carry, ph, qh), rh, sh);
  out->high = (uint64_t)gjk_sar64(high, 2);
  out->low = (uint64_t)high << 62 | (uint64_t)(digit & INT32_MAX) << 31 | (uint32_t)gjk_low_digit(lowest);
}

int gjk_sum_of_products_sign_exact(int64_t p, int64_t q, int64_t r, int64_t s) {
  gjk_u128 sum;
  gjk_sum_of_products(p, q, r, s, &sum);
  return sum.high > INT64_MAX ? -1 : (sum.high | sum.low) != 0;
}

// *sum = a + b
GJK_ONCE static void add128(const gjk_u128 *a, const gjk_u128 *b, gjk_u128 *sum) {
  const uint64_t low = a->low + b->low;
  sum->high = a->high + b->high + (low < b->low);
  sum->low = low;
}

// The number of bits of x; 1 where x is 0.
static unsigned bit_length(const gjk_u128 *x) {
  return x->high != 0 ? 128 - gjk_clz64(x->high) : 64 - gjk_clz64(x->low | 1);
}

// floor(x / 2^(bits - 32)): the leading 32 bits of a number of that many bits. Pre: x < 2^bits, 1 <= bits <= 127.
static uint32_t leading(const gjk_u128 *x, unsigned bits) {
  uint64_t top;
  if (bits > 64) {
    const unsigned n = 128 - bits;
    top = (x->high << n) | (x->low >> (64 - n));
  } else {
    top = x->low << (64 - bits);
  }
  return (uint32_t)(top >> 32);
}

// 2^63 / x for 2^31 <= x < 2^32, not too large and too small by less than 2, by Newton's iteration. With u = x / 2^32,
// 1/2 <= u < 1, and Y = y / 2^31, which approaches 1 / u:
//   1. Start from the line Y = 48/17 - 32/17 u, within 1/17 of 1 / u.
//   2. Three times: Y += Y (1 - u Y). A relative error e becomes -e^2: 2^-4, 2^-8, 2^-16, 2^-32.
// y fits: it starts at 32/17 2^31 or less, and later is at most 2^63 / x; for x = 2^31 it ends at 2^32 - 1.
uint32_t gjk_reciprocal(uint32_t x) {
  uint32_t y = (uint32_t)(UINT64_C(6063483241) - gjk_umulh32(x, UINT32_C(4042322161)));  // Step 1
  for (int i = 0; i < 3; i++) {                                                          // Step 2
    int64_t rest = gjk_int64((UINT64_C(1) << 63) - gjk_umul32(x, y));                    // |rest| <= 2^60
    //@ assert rest >= -(INT64_C(1) << 60) && rest <= INT64_C(1) << 60;
    int32_t e = (int32_t)gjk_sar64(rest, 31);
    // (y / 2) (rest / 2^62)
    y = (uint32_t)((int64_t)y + gjk_sar64(gjk_mul32((int32_t)(y >> 1), e), 31));
  }
  return y;
}

static bool less128(const gjk_u128 *a, const gjk_u128 *b) {
  return a->high != b->high ? a->high < b->high : a->low < b->low;
}

// *weight = floor(2^47 part / sum), bit by bit. Pre: part <= sum < 2^127, so twice a rest below sum fits.
static void fine_barycentric(const gjk_u128 *part, const gjk_u128 *sum, gjk_barycentric *weight) {
  uint64_t high = part->high, low = part->low, quotient = 0;
  for (int i = 0; i <= 47; i++) {
    const gjk_u128 rest = {high, low};
    const bool bit = !less128(&rest, sum);
    if (bit) {
      high = high - sum->high - (low < sum->low);
      low -= sum->low;
    }
    quotient = (quotient << 1) | bit;
    high = (high << 1) | (low >> 63);
    low <<= 1;
  }
  quotient -= quotient >> 47;  // part == sum gives 2^47, which high cannot hold: 2^47 - 1 instead
  weight->high = (int32_t)(quotient >> 16);
  weight->low = (int32_t)(quotient & 0xFFFFu);
}

void gjk_barycentrics(const gjk_u128 *rest, const gjk_u128 *part, const gjk_u128 *part2, bool fine,
                      gjk_barycentric weight[2]) {
  gjk_u128 sum;
  add128(rest, part, &sum);
  add128(&sum, part2, &sum);
  if (fine) {
    fine_barycentric(part, &sum, &weight[0]);
    fine_barycentric(part2, &sum, &weight[1]);
    return;
  }
  const unsigned bits = bit_length(&sum);
  const uint32_t inverse = gjk_reciprocal(leading(&sum, bits));
  const uint32_t one = INT32_MAX;
  const uint32_t first = gjk_umulh32(leading(part, bits), inverse);
  const uint32_t second = gjk_umulh32(leading(part2, bits), inverse);
  weight[0].high = (int32_t)(first < one ? first : one);
  weight[1].high = (int32_t)(second < one - first ? second : one - first);
  weight[0].low = 0;
  weight[1].low = 0;
}

// *weight = part / sum, or 1 less it, not 0 and not 1: to 47 bits.
GJK_OUT_OF_LINE static void fine_portion(const gjk_u128 *part, const gjk_u128 *sum, bool from_rest,
                                         gjk_barycentric *weight) {
  fine_barycentric(part, sum, weight);
  int64_t portion = gjk_shl64(weight->high, 16) + weight->low;
  portion = portion > 0 ? portion : 1;
  portion = from_rest ? (INT64_C(1) << 47) - portion : portion;
  weight->high = (int32_t)gjk_sar64(portion, 16);
  weight->low = (int32_t)(portion & 0xFFFF);
}

// The same to 31 bits, of the leading bits of the part.
static int32_t coarse_portion(uint32_t part, uint32_t inverse, bool from_rest) {
  const uint32_t portion = gjk_umulh32(part, inverse), most = INT32_MAX;
  const uint32_t inside = portion == 0 ? 1 : portion < most ? portion : most;
  return (int32_t)(from_rest ? most + 1 - inside : inside);
}

#if !GJK_SMALL

void gjk_portion(uint64_t rest, uint64_t part, bool from_rest, bool fine, gjk_barycentric *weight) {
  const uint64_t sum = rest + part, first = from_rest ? rest : part;
  if (fine) {
    const gjk_u128 portion = {0, first}, whole = {0, sum};
    fine_portion(&portion, &whole, from_rest, weight);
    return;
  }
  const unsigned zeros = gjk_clz64(sum);
  const uint32_t inverse = gjk_reciprocal((uint32_t)(sum << zeros >> 32));
  weight->high = coarse_portion((uint32_t)(first << zeros >> 32), inverse, from_rest);
  weight->low = 0;
}

#endif

void gjk_portions(const gjk_u128 *rest, const gjk_u128 *part, const gjk_u128 *part2, unsigned from_rest, bool fine,
                  gjk_barycentric weight[2]) {
  gjk_u128 others, others2, sum;
  add128(rest, part2, &others);
  add128(rest, part, &others2);
  add128(&others, part, &sum);
  const bool flip = (from_rest & 1u) != 0, flip2 = (from_rest & 2u) != 0;
  const gjk_u128 *first = flip ? &others : part, *second = flip2 ? &others2 : part2;
  if (fine) {
    fine_portion(first, &sum, flip, &weight[0]);
    fine_portion(second, &sum, flip2, &weight[1]);
    return;
  }
  const unsigned bits = bit_length(&sum);
  const uint32_t inverse = gjk_reciprocal(leading(&sum, bits));
  weight[0].high = coarse_portion(leading(first, bits), inverse, flip);
  weight[1].high = coarse_portion(leading(second, bits), inverse, flip2);
  weight[0].low = 0;
  weight[1].low = 0;
}

void gjk_magnitude95(int64_t high, uint32_t low, gjk_u128 *out) {
  out->high = (uint64_t)gjk_sar64(high, 33);
  out->low = (uint64_t)high << 31 | low;
  if (high < 0) {
    out->low = ~out->low + 1;
    out->high = ~out->high + (out->low == 0);
  }
}

void gjk_divisor_set(gjk_divisor *divisor, const gjk_u128 *x) {
  divisor->bits = bit_length(x);
  divisor->inverse = gjk_reciprocal(leading(x, divisor->bits));
}

// gjk_divide of an x = 2^(bits - 32) top, before truncation. With the divisor = 2^(divisor->bits - 32) bottom, quotient is
// 2^30 top / bottom, from 2^29 to 2^31. Truncating top, inverse and product lowers quotient by less than 1 + 2 + 2.
// Truncating bottom raises it.
GJK_ONCE static int32_t divide_leading(uint32_t top, unsigned bits, const gjk_divisor *divisor, unsigned scale,
                                       unsigned *k) {
  const uint32_t quotient = gjk_umulh32(top, divisor->inverse) >> 1;
  const int exponent = (int)divisor->bits + 30 - (int)bits - (int)scale;  // the result is quotient / 2^exponent
  *k = 0;
  if (exponent >= 0) {
    const unsigned cut = exponent > 32 ? (unsigned)exponent - 32 : 0;
    *k = (unsigned)exponent - cut;
    //@ assert *k <= 32;
    return cut < 32 ? (int32_t)(quotient >> cut) : 0;
  }
  return exponent == -1 && quotient >> 30 == 0 ? (int32_t)(quotient << 1) : INT32_MAX;
}

int32_t gjk_divide(const gjk_u128 *x, const gjk_divisor *divisor, unsigned scale, unsigned *k) {
  const unsigned bits = bit_length(x);
  if ((x->high | x->low) == 0) {
    *k = 0;
    return 0;
  }
  return divide_leading(leading(x, bits), bits, divisor, scale, k);
}

int32_t gjk_divide64(uint64_t x, uint64_t y, unsigned scale, unsigned *k) {
#if GJK_SMALL
  const gjk_u128 dividend = {0, x}, whole = {0, y};
  gjk_divisor divisor;
  gjk_divisor_set(&divisor, &whole);
  return gjk_divide(&dividend, &divisor, scale, k);
#else
  if (x == 0) {
    *k = 0;
    return 0;
  }
  const unsigned zeros = gjk_clz64(x), zeros2 = gjk_clz64(y);
  const gjk_divisor divisor = {gjk_reciprocal((uint32_t)(y << zeros2 >> 32)), 64 - zeros2};
  return divide_leading((uint32_t)(x << zeros >> 32), 64 - zeros, &divisor, scale, k);
#endif
}

void gjk_u192_set(gjk_u192 *x, uint64_t value) {
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    x->limb[i] = (uint32_t)(value & UINT32_MAX);
    value >>= 32;
  }
}

void gjk_u192_add(gjk_u192 *x, const gjk_u192 *y) {
  uint64_t carry = 0;
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    carry += (uint64_t)x->limb[i] + y->limb[i];
    x->limb[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

void gjk_u192_multiply(gjk_u192 *out, const gjk_u192 *x, const gjk_u192 *y) {
  gjk_u192_set(out, 0);
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    uint64_t carry = 0;
    for (int j = 0; i + j < GJK_U192_LIMBS && x->limb[i] != 0; j++) {
      // product <= (2^32 - 1)^2, limb <= 2^32 - 1, carry <= 2^32 - 1:  sum <= 2^64 - 1
      carry += gjk_umul32(x->limb[i], y->limb[j]) + out->limb[i + j];
      out->limb[i + j] = (uint32_t)(carry & UINT32_MAX);
      carry >>= 32;
    }
  }
}

int gjk_u192_compare(const gjk_u192 *x, const gjk_u192 *y) {
  for (int i = GJK_U192_LIMBS - 1; i >= 0; i--) {
    if (x->limb[i] != y->limb[i]) {
      return x->limb[i] > y->limb[i] ? 1 : -1;
    }
  }
  return 0;
}

// out = x y, all of it.
static void multiply_all(uint32_t out[2 * GJK_U192_LIMBS], const gjk_u192 *x, const gjk_u192 *y) {
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    out[i] = 0;
  }
  for (int i = 0; i < GJK_U192_LIMBS; i++) {
    uint64_t carry = 0;
    for (int j = 0; j < GJK_U192_LIMBS; j++) {
      // as in gjk_u192_multiply:  sum <= 2^64 - 1
      carry += gjk_umul32(x->limb[i], y->limb[j]) + out[i + j];
      out[i + j] = (uint32_t)(carry & UINT32_MAX);
      carry >>= 32;
    }
    out[i + GJK_U192_LIMBS] = (uint32_t)carry;
  }
}

int gjk_u192_compare_quotients(const gjk_u192 *a, const gjk_u192 *b, const gjk_u192 *c, const gjk_u192 *d) {
  uint32_t left[2 * GJK_U192_LIMBS], right[2 * GJK_U192_LIMBS];
  multiply_all(left, a, d);
  multiply_all(right, c, b);
  for (int i = 2 * GJK_U192_LIMBS - 1; i >= 0; i--) {
    if (left[i] != right[i]) {
      return left[i] > right[i] ? 1 : -1;
    }
  }
  return 0;
}
