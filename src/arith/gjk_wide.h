// Integers wider than the machine's: shifts that the standard defines, long products, exact signs.
//
// Beside gjk_port_defaults.h the one file of the core that looks at the compiler. Every path gives the same integers.
#ifndef GJK_SRC_WIDE_H
#define GJK_SRC_WIDE_H

#include "gjk_port_defaults.h"

// GJK_OUT_OF_LINE marks a function that must not be inlined, mostly because it rarely runs.
// GJK_SMALL is 1 where the compiler optimises for size; the code is then chosen for size as well.
// GJK_ONCE marks a function that stays one copy where GJK_SMALL is 1, and goes in line elsewhere.
// GJK_ONE_COPY marks one that stays one copy there, and is up to the compiler elsewhere.
#if defined(__GNUC__)
#define GJK_OUT_OF_LINE __attribute__((noinline))
#else
#define GJK_OUT_OF_LINE
#endif
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define GJK_SMALL 1
#define GJK_ONCE GJK_OUT_OF_LINE
#define GJK_ONE_COPY GJK_OUT_OF_LINE
#elif defined(__GNUC__)
#define GJK_SMALL 0
#define GJK_ONCE __attribute__((always_inline)) inline
#define GJK_ONE_COPY
#else
#define GJK_SMALL 0
#define GJK_ONCE inline
#define GJK_ONE_COPY
#endif

// GJK_CONDITIONAL_MOVES is 1 on processors that guess branches far ahead: there a wrong guess costs more than a product.
#if defined(__GNUC__) && defined(__LP64__) && (defined(__x86_64__) || defined(__aarch64__))
#define GJK_CONDITIONAL_MOVES 1
#else
#define GJK_CONDITIONAL_MOVES 0
#endif

// GJK_64_BIT is 1 where a register holds 64 bits. There shifts by any number of bits are cheap, and memory is plentiful.
#if SIZE_MAX > UINT32_MAX
#define GJK_64_BIT 1
#else
#define GJK_64_BIT 0
#endif

// Sets the int64_t most to x and the pointer best to place where x > most, without a branch; GCC makes one of C code.
#if GJK_CONDITIONAL_MOVES && defined(__x86_64__)
#define GJK_KEEP_LARGER(most, best, x, place) \
  __asm__("cmpq %2, %0\n\tcmovlq %2, %0\n\tcmovlq %3, %1" : "+&r"(most), "+&r"(best) : "r"(x), "r"(place) : "cc")
#elif GJK_CONDITIONAL_MOVES
#define GJK_KEEP_LARGER(most, best, x, place)                        \
  __asm__("cmp %0, %2\n\tcsel %0, %2, %0, lt\n\tcsel %1, %3, %1, lt" \
          : "+&r"(most), "+&r"(best)                                 \
          : "r"(x), "r"(place)                                       \
          : "cc")
#endif

// The int32_t with the bits of u.
static inline int32_t gjk_int32(uint32_t u) {
  return u <= INT32_MAX ? (int32_t)u : -(int32_t)(UINT32_MAX - u) - 1;
}

// The int64_t with the bits of u.
static inline int64_t gjk_int64(uint64_t u) {
  return u <= INT64_MAX ? (int64_t)u : -(int64_t)(UINT64_MAX - u) - 1;
}

// floor(x / 2^n), 0 <= n <= 31. A plain shift where the compiler's right shift is arithmetic.
static inline int32_t gjk_sar32(int32_t x, unsigned n) {
  if ((-1 >> 1) == -1) {  // not reached: a constant has one outcome
    return x >> n;
  }
  // not reached: the compilers at hand shift arithmetically
  return x < 0 ? ~(~x >> n) : x >> n;
}

// A shift of 64 bits by a number that varies is a dozen instructions on a core of 32 bits: in a build for size a call.
#if GJK_SMALL && !GJK_64_BIT
#define GJK_IS_CALL(n) (!__builtin_constant_p(n))
#define GJK_SHIFT __attribute__((always_inline)) static inline
int64_t gjk_sar64_by(int64_t x, unsigned n);
int64_t gjk_shl64_by(int64_t x, unsigned n);
#else
#define GJK_IS_CALL(n) false
#define GJK_SHIFT static inline
#define gjk_sar64_by(x, n) (x)
#define gjk_shl64_by(x, n) (x)
#endif

// floor(x / 2^n), 0 <= n <= 63.
GJK_SHIFT int64_t gjk_sar64(int64_t x, unsigned n) {
  if (GJK_IS_CALL(n)) {
    return gjk_sar64_by(x, n);
  }
  if ((-1 >> 1) == -1) {  // not reached: a constant has one outcome
    return x >> n;
  }
  // not reached: the compilers at hand shift arithmetically
  return x < 0 ? ~(~x >> n) : x >> n;
}

// x 2^n. Pre: the result fits.
static inline int32_t gjk_shl32(int32_t x, unsigned n) {
  return gjk_int32((uint32_t)x << n);
}

// x 2^n. Pre: the result fits.
GJK_SHIFT int64_t gjk_shl64(int64_t x, unsigned n) {
  if (GJK_IS_CALL(n)) {
    return gjk_shl64_by(x, n);
  }
  return gjk_int64((uint64_t)x << n);
}

// The halves of x = 2^32 high + low, low unsigned.
static inline int32_t gjk_high32(int64_t x) {
  return (int32_t)gjk_sar64(x, 32);
}

static inline uint32_t gjk_low32(int64_t x) {
  return (uint32_t)((uint64_t)x & UINT32_MAX);
}

// The int32_t nearest to x.
static inline int32_t gjk_saturate(int64_t x) {
  const int32_t low = gjk_int32(gjk_low32(x));
  return low == x ? low : x < 0 ? INT32_MIN : INT32_MAX;
}

// gjk_saturate(x). Sets *saturated when the result is not x, and never clears it.
static inline int32_t gjk_saturate_noting(int64_t x, bool *saturated) {
  const int32_t low = gjk_int32(gjk_low32(x));
  if (low != x) {
    *saturated = true;
    return x < 0 ? INT32_MIN : INT32_MAX;
  }
  return low;
}

// a + b, or the end of the range.
static inline int64_t gjk_saturated_sum(int64_t a, int64_t b) {
  const int64_t sum = gjk_int64((uint64_t)a + (uint64_t)b);
  return (a < 0) == (b < 0) && (sum < 0) != (a < 0) ? (a < 0 ? INT64_MIN : INT64_MAX) : sum;
}

// |x| as an unsigned number; exact for INT32_MIN too.
static inline uint32_t gjk_magnitude32(int32_t x) {
  return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

// |x| as an unsigned number; exact for INT64_MIN too.
static inline uint64_t gjk_magnitude64(int64_t x) {
  return x < 0 ? 0u - (uint64_t)x : (uint64_t)x;
}

// Leading zeros of x. Pre: x != 0.
static inline unsigned gjk_clz32(uint32_t x) {
#if defined(GJK_CLZ32)
  return (unsigned)GJK_CLZ32(x);
#elif defined(__GNUC__) && UINT_MAX == UINT32_MAX && !(defined(__ARM_ARCH) && __ARM_ARCH < 7) && \
    !defined(__ARM_ARCH_8M_BASE__) && !defined(__riscv)
  return (unsigned)__builtin_clz(x);
#else
  unsigned n = 0;
  if (x >> 16 == 0) {
    n = 16;
    x <<= 16;
  }
  if (x >> 24 == 0) {
    n += 8;
    x <<= 8;
  }
  if (x >> 28 == 0) {
    n += 4;
    x <<= 4;
  }
  if (x >> 30 == 0) {
    n += 2;
    x <<= 2;
  }
  return n + (x >> 31 == 0);
#endif
}

// Leading zeros of x. Pre: x != 0.
static inline unsigned gjk_clz64(uint64_t x) {
#if defined(__GNUC__) && GJK_64_BIT && !defined(__riscv)
  return (unsigned)__builtin_clzll(x);
#else
  uint32_t high = (uint32_t)(x >> 32);
  return high != 0 ? gjk_clz32(high) : 32 + gjk_clz32((uint32_t)(x & UINT32_MAX));
#endif
}

// The upper half of x 2^n. Pre: x 2^n < 2^64, n <= 63.
static inline uint32_t gjk_upper32(uint64_t x, unsigned n) {
#if GJK_64_BIT
  return (uint32_t)((x << n) >> 32);
#else
  const uint32_t high = (uint32_t)(x >> 32), low = (uint32_t)(x & UINT32_MAX);
  return n >= 32 ? low << (n - 32) : high << n | (low >> 1) >> (31 - n);
#endif
}

// ARMv7-M and up get their long multiplications by name. gcc widens an operand that is used twice ahead of time; then
// it overlooks the one instruction that multiplies, and spends eight.
#if defined(__GNUC__) && defined(__ARM_ARCH) && __ARM_ARCH >= 7 && defined(__thumb2__) && !GJK_NARROW_MULTIPLY
#define GJK_ARM_LONG_MULTIPLY
#endif

// a b, exact.
static inline int64_t gjk_mul32(int32_t a, int32_t b) {
#if GJK_NARROW_MULTIPLY
  // a = 2^16 ah + al, b = 2^16 bh + bl, with 0 <= al, bl < 2^16 and -2^15 <= ah, bh < 2^15
  uint32_t al = (uint32_t)a & 0xFFFFu, bl = (uint32_t)b & 0xFFFFu;
  int32_t ah = gjk_sar32(a, 16), bh = gjk_sar32(b, 16);
  uint32_t low = al * bl;  // <= (2^16 - 1)^2 < 2^32
  // The middle terms:  <= (2^15 - 1) (2^16 - 1) + (2^16 - 1) < 2^31,  >= -2^15 (2^16 - 1) > -2^31
  int32_t middle = ah * (int32_t)bl + (int32_t)(low >> 16);
  int32_t middle2 = (int32_t)al * bh + (int32_t)((uint32_t)middle & 0xFFFFu);
  int32_t high = ah * bh + gjk_sar32(middle, 16) + gjk_sar32(middle2, 16);  // floor(a b / 2^32):  |high| <= 2^30
  uint32_t bits = ((uint32_t)middle2 << 16) | (low & 0xFFFFu);
  return gjk_int64(((uint64_t)(uint32_t)high << 32) | bits);
#elif defined(GJK_ARM_LONG_MULTIPLY)
  int64_t product;
  __asm__("smull %Q0, %R0, %1, %2" : "=r"(product) : "r"(a), "r"(b));
  return product;
#else
  return (int64_t)a * b;
#endif
}

// sum + a b. Pre: the result fits.
static inline int64_t gjk_mac32(int64_t sum, int32_t a, int32_t b) {
#if defined(GJK_ARM_LONG_MULTIPLY)
  __asm__("smlal %Q0, %R0, %1, %2" : "+r"(sum) : "r"(a), "r"(b));
  return sum;
#else
  return sum + gjk_mul32(a, b);
#endif
}

// sum - a b. Pre: the result fits, a is not INT32_MIN.
static inline int64_t gjk_msub32(int64_t sum, int32_t a, int32_t b) {
#if defined(GJK_ARM_LONG_MULTIPLY)
  return gjk_mac32(sum, -a, b);
#else
  return sum - gjk_mul32(a, b);
#endif
}

// a b, exact, unsigned.
static inline uint64_t gjk_umul32(uint32_t a, uint32_t b) {
#if GJK_NARROW_MULTIPLY
  uint32_t al = a & 0xFFFFu, bl = b & 0xFFFFu, ah = a >> 16, bh = b >> 16;
  uint32_t low = al * bl;                                      // <= (2^16 - 1)^2
  uint32_t middle = ah * bl + (low >> 16);                     // <= (2^16 - 1)^2 + (2^16 - 1) < 2^32
  uint32_t middle2 = al * bh + (middle & 0xFFFFu);             // <= (2^16 - 1)^2 + (2^16 - 1) < 2^32
  uint32_t high = ah * bh + (middle >> 16) + (middle2 >> 16);  // floor(a b / 2^32)
  return ((uint64_t)high << 32) | (middle2 << 16) | (low & 0xFFFFu);
#else
  return (uint64_t)a * b;
#endif
}

// floor(a b / 2^32), unsigned.
static inline uint32_t gjk_umulh32(uint32_t a, uint32_t b) {
  return (uint32_t)(gjk_umul32(a, b) >> 32);
}

#if GJK_VECTORS

// Vectors of the compiler: a shift, sum or comparison is one of each component.
typedef int32_t gjk_4x32 __attribute__((vector_size(16)));
typedef int16_t gjk_8x16 __attribute__((vector_size(16)));
typedef uint32_t gjk_4xu32 __attribute__((vector_size(16)));
typedef uint64_t gjk_2xu64 __attribute__((vector_size(16)));

// The four numbers from p on.
static inline gjk_4x32 gjk_load_4x32(const int32_t *p) {
  typedef int32_t unaligned __attribute__((vector_size(16), aligned(4), may_alias));
  return *(const unaligned *)p;
}

// The four numbers from p on become those of x.
static inline void gjk_store_4x32(gjk_4x32 x, int32_t *p) {
  typedef int32_t unaligned __attribute__((vector_size(16), aligned(4), may_alias));
  *(unaligned *)p = x;
}

// x as each component.
static inline gjk_8x16 gjk_all_8x16(int16_t x) {
  const gjk_8x16 zero = {0};
  return zero + x;
}

// Components of a and b by number, a's first. GCC knows Clang's builtin from version 12 on.
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define GJK_PICK(type, a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif
#endif
#if !defined(GJK_PICK)
#define GJK_PICK(type, a, b, ...) __builtin_shuffle(a, b, (type){__VA_ARGS__})
#endif

// a0 + a1, a2 + a3, b0 + b1, b2 + b3
static inline gjk_4x32 gjk_add_neighbours(gjk_4x32 a, gjk_4x32 b) {
  return GJK_PICK(gjk_4x32, a, b, 0, 2, 4, 6) + GJK_PICK(gjk_4x32, a, b, 1, 3, 5, 7);
}

#if defined(__SSE2__)

typedef char gjk_16x8 __attribute__((vector_size(16)));

// Components of a, then those of b. Pre: each fits.
static inline gjk_8x16 gjk_narrow(gjk_4x32 a, gjk_4x32 b) {
  return (gjk_8x16)__builtin_ia32_packssdw128(a, b);
}

// a0 p0 + a1 p1, a2 p2 + a3 p3, b0 q0 + b1 q1, b2 q2 + b3 q3. Pre: each component fits int16_t.
static inline gjk_4x32 gjk_add_products(gjk_4x32 a, gjk_4x32 b, gjk_4x32 p, gjk_4x32 q) {
  return (gjk_4x32)__builtin_ia32_pmaddwd128(gjk_narrow(a, b), gjk_narrow(p, q));
}

// The products of components 0 and 2 of a and b, unsigned.
#define GJK_VECTORS_MULTIPLY
static inline gjk_2xu64 gjk_mul_even(gjk_4xu32 a, gjk_4xu32 b) {
#if defined(__clang__)
  const gjk_2xu64 low = {UINT32_MAX, UINT32_MAX};
  return ((gjk_2xu64)a & low) * ((gjk_2xu64)b & low);
#else
  return (gjk_2xu64)__builtin_ia32_pmuludq128((gjk_4x32)a, (gjk_4x32)b);
#endif
}

// Bit i is set where component i of the comparison c holds.
static inline unsigned gjk_bits_of(gjk_8x16 c) {
  const gjk_16x8 bytes = (gjk_16x8)__builtin_ia32_packsswb128(c, c);
  return (unsigned)__builtin_ia32_pmovmskb128(bytes) & 0xFFu;
}

#else

static inline gjk_8x16 gjk_narrow(gjk_4x32 a, gjk_4x32 b) {
  return GJK_PICK(gjk_8x16, (gjk_8x16)a, (gjk_8x16)b, 0, 2, 4, 6, 8, 10, 12, 14);
}

static inline gjk_4x32 gjk_add_products(gjk_4x32 a, gjk_4x32 b, gjk_4x32 p, gjk_4x32 q) {
  return gjk_add_neighbours(a * p, b * q);
}

static inline unsigned gjk_bits_of(gjk_8x16 c) {
  const gjk_8x16 bit = {1, 2, 4, 8, 16, 32, 64, 128}, bits = c & bit;
  const gjk_4x32 sums = (gjk_4x32)(bits | (gjk_8x16)((gjk_4x32)bits >> 16));
  return (unsigned)((sums[0] | sums[1] | sums[2] | sums[3]) & 0xFF);
}

#endif

// The larger of each component.
static inline gjk_8x16 gjk_larger(gjk_8x16 a, gjk_8x16 b) {
#if defined(__SSE2__) && !defined(__clang__)
  return (gjk_8x16)__builtin_ia32_pmaxsw128(a, b);
#else
  const gjk_8x16 is = a > b;
  return (a & is) | (b & ~is);
#endif
}

// The largest component, as each component.
static inline gjk_8x16 gjk_largest(gjk_8x16 a) {
  a = gjk_larger(a, GJK_PICK(gjk_8x16, a, a, 4, 5, 6, 7, 0, 1, 2, 3));
  a = gjk_larger(a, GJK_PICK(gjk_8x16, a, a, 2, 3, 0, 1, 6, 7, 4, 5));
  return gjk_larger(a, GJK_PICK(gjk_8x16, a, a, 1, 0, 3, 2, 5, 4, 7, 6));
}

// The number of the lowest bit that is set. Pre: x != 0.
static inline unsigned gjk_lowest_bit(uint64_t x) {
  return (unsigned)__builtin_ctzll(x);
}

#endif

// The sign of x: -1, 0 or 1.
static inline int gjk_sign64(int64_t x) {
  return (x > 0) - (x < 0);
}

// The digits of x = 2^31 high + low, 0 <= low < 2^31, both as int32_t so that gjk_mul32 takes them. Pre: |x| < 2^62.
static inline int32_t gjk_high_digit(int64_t x) {
  //@ assert x > -(INT64_C(1) << 62) && x < INT64_C(1) << 62;
  return (int32_t)gjk_sar64(x, 31);
}

static inline int32_t gjk_low_digit(int64_t x) {
  return (int32_t)(gjk_low32(x) & INT32_MAX);
}

// The digits of x = 2^32 high + low, -2^31 <= low < 2^31. Pre: |x| < 2^63 - 2^31.
static inline int32_t gjk_low_balanced(int64_t x) {
  return gjk_int32(gjk_low32(x));
}

static inline int32_t gjk_high_balanced(int64_t x) {
  return gjk_high32(x) + (gjk_low_balanced(x) < 0 ? 1 : 0);
}

// The sign of p q + r s. Pre: each is below 2^62 in size.
int gjk_sum_of_products_sign_exact(int64_t p, int64_t q, int64_t r, int64_t s);

// Unsigned 128 bits.
typedef struct gjk_u128 {
  uint64_t high, low;
} gjk_u128;

// *out = p q + r s in two's complement; the sum is below 2^125 in size. Pre: each is below 2^62 in size.
void gjk_sum_of_products(int64_t p, int64_t q, int64_t r, int64_t s, gjk_u128 *out);

// A barycentric coordinate: the weight, from 0 to 1, of one vertex in a point of an edge or triangle. The point is the
// sum of its weighted vertices, and the weights sum to 1. Q47: (2^16 high + low) / 2^47.
typedef struct gjk_barycentric {
  int32_t high, low;  // 0 <= high, 0 <= low < 2^16
} gjk_barycentric;

// The barycentric coordinates in proportion to part and part2, of rest + part + part2 as the whole: weight[0] and
// weight[1], together at most 1. What they leave of 1 is the coordinate in proportion to rest.
// fine: each is exact but for a floor to Q47. Otherwise low is 0 and high within 3, sixty times as fast.
// Pre: the sum is positive and below 2^127.
void gjk_barycentrics(const gjk_u128 *rest, const gjk_u128 *part, const gjk_u128 *part2, bool fine,
                      gjk_barycentric weight[2]);

// The same, but each weight for itself, from 2^-31 to 1 - 2^-31, fine from 2^-47.
// from_rest: bit i is set where weight[i] is 1 less the weight of all else. So a caller that always divides the part of
// the same end of an edge gets the same point of the edge, from whichever end it begins.
// Pre: as of gjk_barycentrics; part and part2 are above 0 and below the sum.
void gjk_portions(const gjk_u128 *rest, const gjk_u128 *part, const gjk_u128 *part2, unsigned from_rest, bool fine,
                  gjk_barycentric weight[2]);

// The weight of one part of an edge: as of gjk_portions with a third part of 0, which a build for size asks instead.
// Pre: rest and part are above 0, their sum is below 2^63.
void gjk_portion(uint64_t rest, uint64_t part, bool from_rest, bool fine, gjk_barycentric *weight);

// *out = |x| for x = 2^31 high + low, low < 2^31.
void gjk_magnitude95(int64_t high, uint32_t low, gjk_u128 *out);

// 2^63 / x, at most 1 too large and 2 too small. Pre: x >= 2^31.
uint32_t gjk_reciprocal(uint32_t x);

// A divisor, prepared for several divisions.
typedef struct gjk_divisor {
  uint32_t inverse;  // 2^63 / the divisor's leading 32 bits
  unsigned bits;     // of the divisor
} gjk_divisor;

// Prepares x as a divisor. Pre: 0 < x < 2^127.
void gjk_divisor_set(gjk_divisor *divisor, const gjk_u128 *x);

// q = 2^scale x / divisor as (returned number) / 2^k, 0 <= k <= 32. The error is at most 2^-28 q + 2^-32. Where q is
// 2^31 or more, returns INT32_MAX with k = 0. Pre: scale <= 64, x < 2^127.
int32_t gjk_divide(const gjk_u128 *x, const gjk_divisor *divisor, unsigned scale, unsigned *k);

// The same by a divisor y for this once. Pre: y > 0.
int32_t gjk_divide64(uint64_t x, uint64_t y, unsigned scale, unsigned *k);

// Unsigned integers of 192 bits, least significant limb first, for comparisons of squares, which are rare.
#define GJK_U192_LIMBS 6

typedef struct gjk_u192 {
  uint32_t limb[GJK_U192_LIMBS];
} gjk_u192;

// x = value.
void gjk_u192_set(gjk_u192 *x, uint64_t value);
// x += y modulo 2^192.
void gjk_u192_add(gjk_u192 *x, const gjk_u192 *y);
// out = x y modulo 2^192; out is neither x nor y.
void gjk_u192_multiply(gjk_u192 *out, const gjk_u192 *x, const gjk_u192 *y);
// The sign of x - y.
int gjk_u192_compare(const gjk_u192 *x, const gjk_u192 *y);
// The sign of a / b - c / d, exact. Pre: b and d are not 0.
int gjk_u192_compare_quotients(const gjk_u192 *a, const gjk_u192 *b, const gjk_u192 *c, const gjk_u192 *d);

#endif
