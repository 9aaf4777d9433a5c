// Contracts of the exact primitives, over the integers.
#ifndef PROVE_CHECKER_WIDE_H
#define PROVE_CHECKER_WIDE_H

#include "operators.h"
#include "src/arith/gjk_wide.h"

/*@ assigns \nothing;
    ensures \result == (u <= 0x7fffffff ? u : u - 0x100000000); */
static inline int32_t gjk_int32(uint32_t u);

/*@ assigns \nothing;
    ensures \result == (u <= 0x7fffffffffffffff ? u : u - 0x10000000000000000); */
static inline int64_t gjk_int64(uint64_t u);

/*@ requires n <= 31;
    assigns \nothing;
    ensures \result == down(x, n); */
static inline int32_t gjk_sar32(int32_t x, unsigned n);

/*@ requires n <= 63;
    assigns \nothing;
    ensures \result == down(x, n); */
static inline int64_t gjk_sar64(int64_t x, unsigned n);

/*@ assigns \nothing;
    ensures \result == down(x, 32);
    ensures 0x100000000 * \result <= x < 0x100000000 * \result + 0x100000000; */
static inline int32_t gjk_high32(int64_t x);

/*@ assigns \nothing;
    ensures x == 0x100000000 * down(x, 32) + \result; */
static inline uint32_t gjk_low32(int64_t x);

/*@ assigns \nothing;
    ensures 0 <= \result <= 0x80000000 && (\result == x || \result == -x); */
static inline uint32_t gjk_magnitude32(int32_t x);

/*@ assigns \nothing;
    ensures \result == (x < 0 ? -x : x); */
static inline uint64_t gjk_magnitude64(int64_t x);

/*@ assigns \nothing;
    ensures \result == a * b; */
static inline int64_t gjk_mul32(int32_t a, int32_t b);

/*@ requires fits: -0x8000000000000000 <= sum + a * b <= 0x7fffffffffffffff;
    assigns \nothing;
    ensures \result == sum + a * b; */
static inline int64_t gjk_mac32(int64_t sum, int32_t a, int32_t b);

/*@ assigns \nothing;
    ensures \result == a * b; */
static inline uint64_t gjk_umul32(uint32_t a, uint32_t b);

/*@ assigns \nothing;
    ensures \result == (x < 0 ? -1 : x == 0 ? 0 : 1); */
static inline int gjk_sign64(int64_t x);

/*@ requires -0x4000000000000000 < x < 0x4000000000000000;
    assigns \nothing;
    ensures \result == down(x, 31); */
static inline int32_t gjk_high_digit(int64_t x);

/*@ assigns \nothing;
    ensures \result == x - 0x80000000 * down(x, 31); */
static inline int32_t gjk_low_digit(int64_t x);

/*@ predicate bounded(integer x, integer y, integer a, integer b) = -(a * b) <= x * y <= a * b;
    predicate bounded_below(integer x, integer y, integer a, integer b) = 0 <= x * y <= a * b;
    lemma product: \forall integer x, y, a, b; -a <= x <= a && -b <= y <= b ==> bounded(x, y, a, b);
    lemma product_below: \forall integer x, y, a, b; 0 <= x <= a && 0 <= y <= b ==> bounded_below(x, y, a, b); */

// The number in two's complement whose halves are high and low.
/*@ logic integer value(integer high, integer low) =
      (high <= 0x7fffffffffffffff ? high : high - 0x10000000000000000) * 0x10000000000000000 + low;
    predicate upper(integer h) = 0 <= h - 4 * down(h, 2) < 4 &&
      (uint64_t)((uint64_t)h << 62) == 0x4000000000000000 * (h - 4 * down(h, 2)) &&
      (uint64_t)((uint64_t)h << 62) == 0x4000000000000000 * down((uint64_t)((uint64_t)h << 62), 62);
    predicate centre(integer d) =
      (uint64_t)(d << 31) == 0x80000000 * d && (uint64_t)(d << 31) == 0x80000000 * down((uint64_t)(d << 31), 31);
    predicate signed_high(integer h) = value((uint64_t)down(h, 2), 0) == 0x10000000000000000 * down(h, 2);
    lemma upper: \forall integer h; upper(h);
    lemma centre: \forall integer d; 0 <= d < 0x80000000 ==> centre(d);
    lemma signed_high: \forall integer h; -0x8000000000000000 <= h <= 0x7fffffffffffffff ==> signed_high(h);
    lemma low_added: \forall integer h, l; value(h, l) == value(h, 0) + l; */

// p q is as near to 2^64 times the product of their high words as those and their low words, below 2^32, allow.
/*@ predicate near_product(integer p, integer q, integer ph, integer qh) =
      -0x8000000000000000 * 0x100000000 <= p * q - 0x10000000000000000 * (ph * qh) <= 0x8000000000000000 * 0x100000000 + 0x10000000000000000;
    predicate split(integer p, integer q, integer ph, integer qh, integer pl, integer ql) =
      p * q - 0x10000000000000000 * (ph * qh) == 0x100000000 * (ph * ql) + 0x100000000 * (qh * pl) + pl * ql;
    lemma split: \forall integer p, q, ph, qh, pl, ql; p == 0x100000000 * ph + pl && q == 0x100000000 * qh + ql ==>
      split(p, q, ph, qh, pl, ql);
    lemma near_split: \forall integer p, q, ph, qh, pl, ql; split(p, q, ph, qh, pl, ql) &&
      bounded(ph, ql, 0x40000000, 0x100000000) && bounded(qh, pl, 0x40000000, 0x100000000) &&
      bounded_below(pl, ql, 0x100000000, 0x100000000) ==> near_product(p, q, ph, qh);
    lemma split_self: \forall integer p, q, ph, qh; split(p, q, ph, qh, p - 0x100000000 * ph, q - 0x100000000 * qh);
    predicate parts(integer ph, integer qh, integer pl, integer ql) = bounded(ph, ql, 0x40000000, 0x100000000) &&
      bounded(qh, pl, 0x40000000, 0x100000000) && bounded_below(pl, ql, 0x100000000, 0x100000000);
    lemma parts: \forall integer ph, qh, pl, ql; -0x40000000 <= ph < 0x40000000 && -0x40000000 <= qh < 0x40000000 &&
      0 <= pl < 0x100000000 && 0 <= ql < 0x100000000 ==> parts(ph, qh, pl, ql);
    lemma near_parts: \forall integer p, q, ph, qh;
      parts(ph, qh, p - 0x100000000 * ph, q - 0x100000000 * qh) ==> near_product(p, q, ph, qh);
    lemma near_product: \forall integer p, q, ph, qh; -0x40000000 <= ph < 0x40000000 && -0x40000000 <= qh < 0x40000000 &&
      0 <= p - 0x100000000 * ph < 0x100000000 && 0 <= q - 0x100000000 * qh < 0x100000000 ==> near_product(p, q, ph, qh); */

#define SMALL62(x) (-0x4000000000000000 < (x) < 0x4000000000000000)

/*@ requires SMALL62(p) && SMALL62(q) && SMALL62(r) && SMALL62(s);
    requires \valid(out);
    assigns *out;
    ensures value(out->high, out->low) == p * q + r * s; */
void gjk_sum_of_products(int64_t p, int64_t q, int64_t r, int64_t s, gjk_u128 *out);

/*@ requires SMALL62(p) && SMALL62(q) && SMALL62(r) && SMALL62(s);
    assigns \nothing;
    ensures \result == (p * q + r * s < 0 ? -1 : p * q + r * s == 0 ? 0 : 1); */
int gjk_sum_of_products_sign_exact(int64_t p, int64_t q, int64_t r, int64_t s);

#endif
