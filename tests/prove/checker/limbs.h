// Contracts of numbers of 192 bits, in digits of 32 bits.
#ifndef PROVE_CHECKER_LIMBS_H
#define PROVE_CHECKER_LIMBS_H

#include "wide.h"

#define LIMBS(x) (x)->limb[0], (x)->limb[1], (x)->limb[2], (x)->limb[3], (x)->limb[4], (x)->limb[5]

// As they were when the function began, or as this round of the loop did.
#define LIMBS_AT(x, l) \
  \at((x)->limb[0], l), \at((x)->limb[1], l), \at((x)->limb[2], l), \at((x)->limb[3], l), \at((x)->limb[4], l), \
      \at((x)->limb[5], l)

// x 2^(32 n); and of digits a to f the n-th, all, the lowest n, and those from the n-th on.
/*@ logic integer place(integer x, integer n) = n <= 0 ? x : n == 1 ? 0x100000000 * x : n == 2 ? 0x10000000000000000 * x :
      n == 3 ? 0x1000000000000000000000000 * x : n == 4 ? 0x100000000000000000000000000000000 * x :
      n == 5 ? 0x10000000000000000000000000000000000000000 * x : 0x1000000000000000000000000000000000000000000000000 * x;
    logic integer digit(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      n == 0 ? a : n == 1 ? b : n == 2 ? c : n == 3 ? d : n == 4 ? e : f;
    logic integer six(integer a, integer b, integer c, integer d, integer e, integer f) =
      a + place(b, 1) + place(c, 2) + place(d, 3) + place(e, 4) + place(f, 5);
    logic integer lowest(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      (n > 0 ? a : 0) + (n > 1 ? place(b, 1) : 0) + (n > 2 ? place(c, 2) : 0) + (n > 3 ? place(d, 3) : 0) +
      (n > 4 ? place(e, 4) : 0) + (n > 5 ? place(f, 5) : 0);
    logic integer rest(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      n <= 0 ? six(a, b, c, d, e, f) : n == 1 ? six(b, c, d, e, f, 0) : n == 2 ? six(c, d, e, f, 0, 0) :
      n == 3 ? six(d, e, f, 0, 0, 0) : n == 4 ? six(e, f, 0, 0, 0, 0) : n == 5 ? f : 0; */

/*@ predicate place_none(integer x) = place(x, 0) == x;
    predicate place_sum(integer z, integer x, integer y, integer n) = z == x + y ==> place(z, n) == place(x, n) + place(y, n);
    predicate place_next(integer z, integer x, integer n) = z == 0x100000000 * x ==> place(z, n) == place(x, n + 1);
    predicate place_twice(integer z, integer t, integer y, integer i, integer j) =
      z == t * place(y, j) ==> place(z, i) == place(t * y, i + j);
    predicate place_top(integer x, integer n) = n == 6 ==> place(x, n) == 0x1000000000000000000000000000000000000000000000000 * x;
    predicate times_sum(integer t, integer z, integer x, integer y) = z == x + y ==> t * z == t * x + t * y;
    predicate place_least(integer x, integer n) = (0 <= x ==> 0 <= place(x, n)) && (x == 0 ==> place(x, n) == 0);
    predicate times_same(integer t, integer x, integer u, integer y) = t == u && x == y ==> t * x == u * y;
    predicate times_none(integer t, integer x) = x == 0 ==> t * x == 0;
    predicate times_most(integer t, integer x, integer y) = t * x <= t * y;
    predicate not_negative(integer x, integer y) = 0 <= x * y;
    predicate lowest_next(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      lowest(a, b, c, d, e, f, n + 1) == lowest(a, b, c, d, e, f, n) + place(digit(a, b, c, d, e, f, n), n);
    predicate with_rest(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      six(a, b, c, d, e, f) == lowest(a, b, c, d, e, f, n) + place(rest(a, b, c, d, e, f, n), n);
    predicate rest_least(integer a, integer b, integer c, integer d, integer e, integer f, integer n) =
      0 <= a && 0 <= b && 0 <= c && 0 <= d && 0 <= e && 0 <= f ==> 0 <= rest(a, b, c, d, e, f, n);
    lemma rest_least: \forall integer a, b, c, d, e, f, n; rest_least(a, b, c, d, e, f, n);
    lemma place_none: \forall integer x; place_none(x);
    lemma place_sum: \forall integer z, x, y, n; place_sum(z, x, y, n);
    lemma place_next: \forall integer z, x, n; 0 <= n < 6 ==> place_next(z, x, n);
    lemma place_twice: \forall integer z, t, y, i, j; (i == 0 || i == 1 || i == 2 || i == 3 || i == 4 || i == 5 || i == 6) &&
      0 <= j && i + j <= 6 ==> place_twice(z, t, y, i, j);
    lemma place_top: \forall integer x, n; place_top(x, n);
    lemma times_sum: \forall integer t, z, x, y; times_sum(t, z, x, y);
    lemma place_least: \forall integer x, n; place_least(x, n);
    lemma times_same: \forall integer t, x, u, y; times_same(t, x, u, y);
    lemma times_none: \forall integer t, x; times_none(t, x);
    lemma times_most: \forall integer t, x, y; 0 <= t && x <= y ==> times_most(t, x, y);
    lemma not_negative: \forall integer x, y; 0 <= x && 0 <= y ==> not_negative(x, y);
    lemma lowest_next: \forall integer a, b, c, d, e, f, n; 0 <= n < 6 ==> lowest_next(a, b, c, d, e, f, n);
    lemma with_rest: \forall integer a, b, c, d, e, f, n; 0 <= n <= 6 ==> with_rest(a, b, c, d, e, f, n); */

/*@ requires \valid(x);
    assigns x->limb[0 .. 5];
    ensures six(LIMBS(x)) == value;
    ensures x->limb[2] == 0 && x->limb[3] == 0 && x->limb[4] == 0 && x->limb[5] == 0; */
void gjk_u192_set(gjk_u192 *x, uint64_t value);

// A round of the multiplication writes digit k.
#define WRITTEN(k)                                                                   \
  (i + j != k || six(LIMBS(out)) + place(digit(LIMBS_AT(out, LoopCurrent), k), k) == \
                     six(LIMBS_AT(out, LoopCurrent)) + place(digit(LIMBS(out), k), k))

#define BELOW192(x) ((x) < 0x1000000000000000000000000000000000000000000000000)

/*@ requires \valid(x) && \valid_read(y) && (x == y || \separated(x, y));
    requires BELOW192(six(LIMBS(x)) + six(LIMBS(y)));
    assigns x->limb[0 .. 5];
    ensures six(LIMBS(x)) == \old(six(LIMBS(x))) + \old(six(LIMBS(y))); */
void gjk_u192_add(gjk_u192 *x, const gjk_u192 *y);

/*@ requires \valid(out) && \valid_read(x) && \valid_read(y) && \separated(out, x) && \separated(out, y);
    requires BELOW192(six(LIMBS(x)) * six(LIMBS(y)));
    assigns out->limb[0 .. 5];
    ensures six(LIMBS(out)) == six(LIMBS(x)) * six(LIMBS(y)); */
void gjk_u192_multiply(gjk_u192 *out, const gjk_u192 *x, const gjk_u192 *y);

/*@ requires \valid_read(x) && \valid_read(y);
    assigns \nothing;
    ensures \result == (six(LIMBS(x)) < six(LIMBS(y)) ? -1 : six(LIMBS(x)) == six(LIMBS(y)) ? 0 : 1); */
int gjk_u192_compare(const gjk_u192 *x, const gjk_u192 *y);

/*@ predicate upper31(integer h) = (uint64_t)((uint64_t)h << 31) == 0x80000000 * (h - 0x200000000 * down(h, 33)) &&
      (uint64_t)((uint64_t)h << 31) == 0x80000000 * down((uint64_t)((uint64_t)h << 31), 31);
    lemma upper31: \forall integer h; upper31(h); */

/*@ requires \valid(out) && low < 0x80000000;
    assigns *out;
    ensures out->high <= 0x40000000;
    ensures 0x10000000000000000 * out->high + out->low == (high < 0 ? -(0x80000000 * high + low) : 0x80000000 * high + low); */
void gjk_magnitude95(int64_t high, uint32_t low, gjk_u128 *out);

#endif
