// Contracts of the plane's check of a normal, in numbers of 192 bits.
#ifndef PROVE_CHECKER_CLAIM_H
#define PROVE_CHECKER_CLAIM_H

#include "plane_depth.h"

#include "limbs.h"

/*@ predicate square_below(integer x, integer m) = 0 <= x * x <= m * m;
    lemma square_below: \forall integer x, m; -m <= x <= m ==> square_below(x, m); */

/*@ requires \valid(sum) && BELOW192(six(LIMBS(sum)) + x * x) && -0x4000000000000000 < x < 0x4000000000000000;
    assigns sum->limb[0 .. 5];
    ensures six(LIMBS(sum)) == \old(six(LIMBS(sum))) + x * x; */
static void plane_add_square(gjk_u192 *sum, int64_t x);

/*@ requires \valid(sum) && BELOW192(six(LIMBS(sum)) + x * x * y) && -0x4000000000000000 < x < 0x4000000000000000;
    requires BELOW192(x * x * y);
    assigns sum->limb[0 .. 5];
    ensures six(LIMBS(sum)) == \old(six(LIMBS(sum))) + x * x * y; */
static void add_square_times(gjk_u192 *sum, int64_t x, uint64_t y);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> same_sign(direction, u); */
static bool plane_same_sign(int32_t direction, gjk_q30 u);

/*@ requires 0 <= convex_radius <= 0x10000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> END(coordinate); */
static bool plane_at_end(gjk_q16 coordinate, gjk_q16 centre, gjk_q16 offset, gjk_q16 convex_radius);

#define POINT_REACH 0x30000000

/*@ requires \valid(out);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> *out == centre + offset - point && -POINT_REACH <= *out <= POINT_REACH; */
static bool plane_from_point(gjk_q16 centre, gjk_q16 offset, gjk_q16 point, int32_t *out);

// Vertex k of those named, from the point.
#define FROM(k)                                                                                         \
  (named[k] < c->count && from[k].x == c->centre.x - point->x + vx(c, named[k]) &&                      \
   from[k].y == c->centre.y - point->y + vy(c, named[k]) && -POINT_REACH <= from[k].x <= POINT_REACH && \
   -POINT_REACH <= from[k].y <= POINT_REACH)
#define UNSET(k) (from[k].x == 0 && from[k].y == 0)

/*@ lemma eighths_least: \forall integer h, square, n; 0 < n && rounded(h, square, n) ==> eighths(h, square, 8 * n - 4);
    lemma eighths_most: \forall integer h, square, n; rounded(h, square, n) ==> !eighths(h, square, 8 * n + 4);
    lemma eighths_none: \forall integer h, square; eighths(h, square, 0);
    lemma eighths_next: \forall integer h, square, e, f; 0 <= e <= f && 0 <= square && !eighths(h, square, e) ==>
      !eighths(h, square, f); */

/*@ requires (n == 1 && -0x80000000 <= x <= 0x7fffffff) || (n == 29 && x == 3) || (n == 30 && -0x80000000 <= x <= 0x80000000);
    assigns \nothing;
    ensures n == 1 ==> \result == 2 * x;
    ensures n == 29 ==> \result == 0x60000000;
    ensures n == 30 ==> \result == 0x40000000 * x; */
static inline int64_t gjk_shl64(int64_t x, unsigned n);

/*@ requires 0 <= height < 0x4000000000000000 && squared < 0x4000000000000000 && 0 <= eighths < 0x1000000000;
    assigns \nothing;
    ensures \result >= 0 <==> eighths(height, squared, eighths); */
static int compare_eighths(uint64_t squared, int64_t height, int64_t eighths);

#endif
