// Contracts of the distance of a feature, as a quotient of numbers of 192 bits, and of the checker of distances in space.
#ifndef PROVE_CHECKER_MEASURE_H
#define PROVE_CHECKER_MEASURE_H

#include "limbs.h"
#include "space.h"

#define BELOW190(x) ((x) < 0x400000000000000000000000000000000000000000000000)
#define BIG94 0x400000000000000000000000

/*@ predicate tight(integer a, integer b, integer c) = a + b + c <= 0xB0000000;
    predicate tight3(integer x, integer y, integer z) = tight(size(x), size(y), size(z));
    predicate dot_split31(integer a, integer b, integer c, integer p, integer q, integer r, integer x, integer y, integer z) =
      dot3(a, b, c, x, y, z) == 0x80000000 * dot3(p, q, r, x, y, z) +
      dot3(a - 0x80000000 * p, b - 0x80000000 * q, c - 0x80000000 * r, x, y, z);
    predicate ball_square(integer x, integer y, integer z) = norm3(x, y, z) <= 0x2400000000000000;
    predicate square_short31(integer t) = t * t <= 0x7900000000000000;
    predicate not_negative_square(integer x) = 0 <= x * x;
    predicate gram_least(integer x, integer y, integer z, integer u, integer v, integer w) =
      0 <= norm3(x, y, z) * norm3(u, v, w) - square(dot3(x, y, z, u, v, w));
    predicate gram_most(integer x, integer y, integer z, integer u, integer v, integer w) =
      norm3(x, y, z) * norm3(u, v, w) - square(dot3(x, y, z, u, v, w)) <= 0x2400000000000000 * 0x2400000000000000;
    predicate top_positive(integer count, integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t,
        integer q) = 0 <= top_of(count, x, y, z, u, v, w, s, t, q);
    lemma top_positive: \forall integer count, x, y, z, u, v, w, s, t, q;
      count == 2 && gram_least(x, y, z, u, v, w) ==> top_positive(count, x, y, z, u, v, w, s, t, q);
    predicate square_either(integer t, integer u) = t == u || t == -u ==> t * t == square(u);
    lemma square_either: \forall integer t, u; square_either(t, u);
    lemma not_negative_square: \forall integer x; not_negative_square(x);
    lemma gram_least: \forall integer x, y, z, u, v, w; gram_least(x, y, z, u, v, w);
    lemma gram_most: \forall integer x, y, z, u, v, w;
      bounded_below(norm3(x, y, z), norm3(u, v, w), 0x2400000000000000, 0x2400000000000000) ==> gram_most(x, y, z, u, v, w);
    predicate face_height(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      dot3(area3(y, z, v, w, t, q), area3(z, x, w, u, q, s), area3(x, y, u, v, s, t), x, y, z) ==
      volume3(x, y, z, u, v, w, s, t, q);
    predicate face_turned(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      dot3(area3(v, w, y, z, t, q), area3(w, u, z, x, q, s), area3(u, v, x, y, s, t), u, v, w) ==
      -volume3(x, y, z, u, v, w, s, t, q);
    predicate norm_opposite(integer a, integer b, integer c, integer x, integer y, integer z) =
      a == -x && b == -y && c == -z ==> norm3(a, b, c) == norm3(x, y, z);
    lemma face_height: \forall integer x, y, z, u, v, w, s, t, q; face_height(x, y, z, u, v, w, s, t, q);
    lemma face_turned: \forall integer x, y, z, u, v, w, s, t, q; face_turned(x, y, z, u, v, w, s, t, q);
    lemma norm_opposite: \forall integer a, b, c, x, y, z; norm_opposite(a, b, c, x, y, z);
    lemma wide_below: \forall integer a, b, c, x, y, z; sized3(a, b, c, x, y, z, 0x4000000000000000) && short3(x, y, z) ==>
      dot_below(a, b, c, x, y, z, 0x400000000000000000000000);
    lemma tight_square: \forall integer a, b, c; in_ball(a, b, c, 0x60000000) ==> square_short31(a + b + c);
    lemma tight_sum: \forall integer t; square_short31(t) ==> t <= 0xB0000000;
    lemma tight: \forall integer a, b, c; in_ball(a, b, c, 0x60000000) ==> tight(a, b, c);
    lemma tight3: \forall integer x, y, z; in_ball(x, y, z, 0x60000000) ==> tight3(x, y, z);
    lemma tight_below: \forall integer a, b, c, x, y, z; sized3(a, b, c, x, y, z, 0x80000000) && tight3(x, y, z) ==>
      dot_below(a, b, c, x, y, z, 0x5800000000000001);
    lemma dot_split31: \forall integer a, b, c, p, q, r, x, y, z; dot_split31(a, b, c, p, q, r, x, y, z);
    lemma ball_square: \forall integer x, y, z; in_ball(x, y, z, 0x60000000) ==> ball_square(x, y, z); */

/*@ requires \valid_read(n) && \valid_read(v) && \valid(low) && \separated(low, n) && \separated(low, v);
    requires SMALL_LONG(n) && in_ball(XYZ(*v), 0x60000000);
    assigns *low;
    ensures 0 <= *low < 0x80000000;
    ensures 0x80000000 * \result + *low == dot3(XYZ(*n), XYZ(*v)); */
int64_t gjk_dot_exact(const gjk_long3 *n, const gjk_vec3 *v, uint32_t *low);

/*@ requires \valid(out) && \valid_read(x) && \separated(out, x);
    assigns out->limb[0 .. 5];
    ensures six(LIMBS(out)) == 0x10000000000000000 * x->high + x->low; */
static void set_limbs(gjk_u192 *out, const gjk_u128 *x);

/*@ requires SMALL62(p) && SMALL62(q) && SMALL62(r) && SMALL62(s) && 0 <= p * q + r * s;
    requires \valid(out);
    assigns out->limb[0 .. 5];
    ensures six(LIMBS(out)) == p * q + r * s; */
static void set_sum_of_products(int64_t p, int64_t q, int64_t r, int64_t s, gjk_u192 *out);

#define TOP(s) (s)->slot[(s)->order[0]].w.x, (s)->slot[(s)->order[0]].w.y, (s)->slot[(s)->order[0]].w.z

/*@ requires \valid_read(s) && \valid(out) && \separated(out, s) && SMALL_LONG(&s->normal) && s->order[0] <= 2;
    requires in_ball(TOP(s), 0x60000000);
    assigns out->limb[0 .. 5];
    ensures six(LIMBS(out)) == square(dot3(XYZ(s->normal), TOP(s)));
    ensures BELOW190(six(LIMBS(out))); */
static void squared_height(const gjk_simplex *s, gjk_u192 *out);

// Numerator and denominator of a vertex, an edge and a triangle.
/*@ requires \valid_read(s) && FORMED(s) && \valid(numerator) && \valid(denominator);
    requires \separated(numerator, s) && \separated(denominator, s) && \separated(numerator, denominator);
    assigns numerator->limb[0 .. 5], denominator->limb[0 .. 5];
    ensures s->count == 1 ==> six(LIMBS(numerator)) == norm3(SLOT(s, 0)) && six(LIMBS(denominator)) == 1;
    ensures s->count == 2 ==> six(LIMBS(numerator)) == norm3(SLOT(s, 0)) * norm3(SLOT(s, 1)) -
      square(dot3(SLOT(s, 0), SLOT(s, 1)));
    ensures s->count == 2 ==> six(LIMBS(denominator)) == toward3(SLOT(s, 0), SLOT(s, 1)) + toward3(SLOT(s, 1), SLOT(s, 0));
    ensures s->count == 3 ==> six(LIMBS(numerator)) == square(dot3(XYZ(s->normal), TOP(s)));
    ensures s->count == 3 ==> six(LIMBS(denominator)) == norm3(XYZ(s->normal));
    ensures BELOW190(six(LIMBS(numerator))) && six(LIMBS(denominator)) <= 0x30000000000000000000000000000000; */
void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_u192 *numerator, gjk_u192 *denominator);

/*@ requires \valid_read(numerator) && \valid_read(denominator);
    requires BELOW192(4 * six(LIMBS(numerator))) && BELOW192(twice * twice * six(LIMBS(denominator)));
    assigns \nothing;
    ensures \result == SIGN(4 * six(LIMBS(numerator)) - twice * twice * six(LIMBS(denominator))); */
int gjk_compare_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t twice);

// The checker of distances.
/*@ predicate point_measures(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer n,
        integer m) = \exists integer i, j, tx, ty, tz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) && point_far(tx, ty, tz, n, m);
    predicate edge_measures(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer n, integer m) =
      \exists integer i, j, k, l, tx, ty, tz, ux, uy, uz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) &&
        named3(a, b, x, y, z, f, k, l, ux, uy, uz) && edge_far(tx, ty, tz, ux, uy, uz, n, m);
    predicate face_measures(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer n, integer m) =
      \exists integer i, j, k, l, o, p, tx, ty, tz, ux, uy, uz, vx, vy, vz;
        named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
        named3(a, b, x, y, z, f, o, p, vx, vy, vz) && face_far(tx, ty, tz, ux, uy, uz, vx, vy, vz, n, m);
    predicate feature_measures(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer n,
        integer m) = point_measures(a, b, x, y, z, f, n, m) || edge_measures(a, b, x, y, z, f, n, m) ||
      face_measures(a, b, x, y, z, f, n, m);
    // The distance of A and B, with r for both radii, is that of a feature, rounded.
    predicate measured3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer r, integer distance) =
      \exists integer f, n, m, dx, dy, dz, wx, wy, wz; 1 <= f && feature_measures(a, b, f * x, f * y, f * z, f, n, m) &&
        support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) && beyond_scaled(dx, dy, dz, wx, wy, wz, f, r) &&
        across3(dx, dy, dz, wx, wy, wz, n, m) && rounded3(n, m, f, distance + r); */

/*@ lemma point_measures: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, tx, ty, tz, n, m;
      named3(a, b, x, y, z, f, i, j, tx, ty, tz) && point_far(tx, ty, tz, n, m) ==> feature_measures(a, b, x, y, z, f, n, m);
    lemma edge_measures: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, k, l, tx, ty, tz, ux, uy, uz, n, m;
      named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
      edge_far(tx, ty, tz, ux, uy, uz, n, m) ==> feature_measures(a, b, x, y, z, f, n, m);
    lemma face_measures: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, k, l, o, p, tx, ty, tz, ux, uy, uz, vx, vy, vz,
        n, m; named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
      named3(a, b, x, y, z, f, o, p, vx, vy, vz) && face_far(tx, ty, tz, ux, uy, uz, vx, vy, vz, n, m) ==>
      feature_measures(a, b, x, y, z, f, n, m);
    lemma measured3: \forall gjk_collider *a, *b, integer x, y, z, kx, ky, kz, f, n, m, dx, dy, dz, wx, wy, wz, r, distance, k;
      1 <= f && kx == f * x && ky == f * y && kz == f * z && k == distance + r && feature_measures(a, b, kx, ky, kz, f, n, m) &&
      support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) && beyond_scaled(dx, dy, dz, wx, wy, wz, f, r) &&
      across3(dx, dy, dz, wx, wy, wz, n, m) && rounded3(n, m, f, k) ==> measured3(a, b, x, y, z, r, distance);
    lemma below_half: \forall integer n, m, f, k, t; t == (2 * k + 1) * f && 4 * n < t * t * m ==> below_half(n, m, f, k);
    lemma above_half: \forall integer n, m, f, k, t; t == (2 * k - 1) * f && t * t * m <= 4 * n ==> above_half(n, m, f, k); */

/*@ predicate product_least(integer a, integer b) = 1 <= a && 1 <= b ==> a <= a * b && b <= a * b;
    lemma product_least: \forall integer a, b; product_least(a, b); */

#include "scales.h"

// What is compared with twice the distance.
#define UP (uint64_t)((uint64_t)(twice + 1) << it->shift)
#define DOWN (uint64_t)((uint64_t)(twice - 1) << it->shift)

/*@ requires \valid_read(it) && READY(&it->simplex) && 0 <= it->shift <= 29 && 0 <= distance && 0 <= radius <= 0x20000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures rounded: \result == 1 ==>
      rounded3(TOP_OF(&it->simplex), BOTTOM_OF(&it->simplex), scale(it->shift), distance + radius); */
static bool is_rounded(const gjk_iteration *it, gjk_q16 distance, int64_t radius);

/*@ requires \valid_read(s) && \valid(out) && \separated(s, out);
    assigns *out; */
void gjk_claim_direction(const gjk_simplex *s, gjk_long3 *out);

/*@ assigns \nothing; */
bool gjk_claim_normal(const gjk_long3 *direction, const gjk_unit3 *normal);

/*@ assigns \nothing; */
static bool are_nearest(const gjk_iteration *it, const gjk_distance_result *result, int64_t radius);

// What a checked distance means for the vertices; solid.v goes on from there.
/*@ requires solid(a) && solid(b) && \valid_read(result);
    assigns \nothing;
    ensures meet: \result == GJK_OK && result->intersecting != 0 ==> result->distance == 0 &&
      together3(a, b, APART(a, b), RADII(a, b));
    ensures apart: \result == GJK_OK && result->intersecting == 0 ==>
      measured3(a, b, APART(a, b), RADII(a, b), result->distance);
    ensures \result == GJK_OK ==> 0 <= result->distance; */
gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result);

#endif
