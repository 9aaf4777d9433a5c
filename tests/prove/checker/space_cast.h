// Contracts of the checker of casts in space, for ways and centres of less than 2^30 LSB along each axis.
#ifndef PROVE_CHECKER_SPACE_CAST_H
#define PROVE_CHECKER_SPACE_CAST_H

#include "scales.h"

// B moves by (tx, ty, tz) against A, whose centre less B's is (x, y, z). Spheres of radii that add up to r never meet.
/*@ predicate leads(integer v, integer p, integer q, integer w) = p * w <= q * v < p * (w + 1);
    predicate led3(integer x, integer y, integer z, integer p, integer q, integer a, integer b, integer c) =
      1 <= p && 1 <= q && leads(x, p, q, a) && leads(y, p, q, b) && leads(z, p, q, c);
    predicate within29(integer a, integer b, integer c) = -0x20000000 <= a <= 0x20000000 &&
      -0x20000000 <= b <= 0x20000000 && -0x20000000 <= c <= 0x20000000;
    logic integer across_norm(integer u, integer v, integer w, integer a, integer b, integer c) =
      norm3(cross(v, w, b, c), cross(w, u, c, a), cross(u, v, a, b));
    predicate full29(integer u, integer v, integer w) = 0xfffffff * 0xfffffff <= norm3(u, v, w);
    predicate passes_by(integer a, integer b, integer c, integer u, integer v, integer w, integer s) =
      (s + 12) * (s + 12) * norm3(u, v, w) < across_norm(u, v, w, a, b, c);
    predicate off_line(integer x, integer y, integer z, integer tx, integer ty, integer tz, integer r) =
      \exists integer p, q, g, h, a, b, c, u, v, w, s; led3(x, y, z, p, q, a, b, c) && within29(a, b, c) &&
        led3(tx, ty, tz, g, h, u, v, w) && full29(u, v, w) && leads(r, p, q, s) && 0 <= s && passes_by(a, b, c, u, v, w, s);
    predicate spheres_pass3(integer x, integer y, integer z, integer tx, integer ty, integer tz, integer r) =
      stays_off(x, tx, r) || stays_off(y, ty, r) || stays_off(z, tz, r) || off_line(x, y, z, tx, ty, tz, r); */

/*@ lemma off_line: \forall integer x, y, z, tx, ty, tz, r, p, q, g, h, a, b, c, u, v, w, s; led3(x, y, z, p, q, a, b, c) &&
      within29(a, b, c) && led3(tx, ty, tz, g, h, u, v, w) && full29(u, v, w) && leads(r, p, q, s) && 0 <= s &&
      passes_by(a, b, c, u, v, w, s) ==> off_line(x, y, z, tx, ty, tz, r); */

#define SHORT(x) (-0x40000000 < (x) < 0x40000000)
#define SHORT3(v) (SHORT((v).x) && SHORT((v).y) && SHORT((v).z))
#define ZERO3(v) ((v).x == 0 && (v).y == 0 && (v).z == 0)
#define CENTRES(a, b) (SHORT(APART_X(a, b)) && SHORT(APART_Y(a, b)) && SHORT(APART_Z(a, b)))

/*@ lemma scale_28: scale(28) == 0x10000000;
    lemma scale_35: scale(35) == 0x800000000;
    predicate filled64(integer x, integer n) = 0x8000000000000000 <= x * scale(n) <= 0xffffffffffffffff;
    predicate times_ordered(integer x, integer y, integer a) = x <= y ==> x * a <= y * a;
    lemma times_ordered: \forall integer x, y, a; 0 <= a ==> times_ordered(x, y, a); */

#include "src/motion/gjk_spheres.h"

/*@ requires 0 < x;
    assigns \nothing;
    ensures \result <= 63 && filled64(x, \result); */
static inline unsigned gjk_clz64(uint64_t x);

// The leading bits of the largest component, v 2^-n: from 2^28 to below 2^29.
/*@ axiomatic joined_bits {
      axiom or_below: \forall integer x, y, n; 0 <= n && 0 <= x < scale(n) && 0 <= y < scale(n) ==> (x | y) < scale(n);
    }
    lemma scale_63: scale(63) == 0x8000000000000000;
    predicate joined3(integer x, integer y, integer z, integer m) = x <= m && y <= m && z <= m;
    lemma joined3: \forall integer x, y, z; 0 <= x && 0 <= y && 0 <= z ==> joined3(x, y, z, x | y | z);
    predicate largest(integer x, integer y, integer z, integer n) = scale(n) <= x || scale(n) <= y || scale(n) <= z;
    lemma largest: \forall integer x, y, z, n; 0 <= n && 0 <= x && 0 <= y && 0 <= z && scale(n) <= (x | y | z) ==>
      largest(x, y, z, n);
    predicate from_28(integer m, integer n) = scale(28 + n) <= m;
    lemma from_28: \forall integer m, n; filled64(m, 35 - n) && scales_joined(28 + n, 35 - n) &&
      times_ordered(m + 1, scale(28 + n), scale(35 - n)) && 1 <= scale(35 - n) ==> from_28(m, n);
    // The size m is below 2^29 p / q.
    predicate below_29(integer m, integer p, integer q) = q * m < 0x20000000 * p;
    lemma below_29: \forall integer m, n; 0 <= n && filled64(m, 35 - n) && scales_joined(35 - n, n) &&
      times_ordered(0x20000000 * scale(n), m, scale(35 - n)) ==> below_29(m, scale(n), 1);
    lemma below_29_up: \forall integer m, n; 0 <= n && filled64(m, 35 + n) && scales_joined(35, n) ==> below_29(m, 1, scale(n));
    lemma leads_down: \forall integer v, n; 0 <= n ==> leads(v, scale(n), 1, down(v, n));
    lemma leads_up: \forall integer v, n; leads(v, 1, scale(n), v * scale(n));
    predicate led_29(integer v, integer w, integer n) = -0x20000000 <= w <= 0x20000000 &&
      (scale(28 + n) <= size(v) ==> w >= 0x10000000 || w <= -0x10000000);
    lemma led_down: \forall integer v, w, n; 0 <= n && below_29(size(v), scale(n), 1) && leads(v, scale(n), 1, w) &&
      1 <= scale(n) && scales_joined(28, n) && times_ordered(0x20000001, w, scale(n)) && times_ordered(w, -0x20000001, scale(n)) &&
      times_ordered(w + 1, 0x10000000, scale(n)) && times_ordered(1 - 0x10000000, w, scale(n)) ==> led_29(v, w, n);
    lemma led_up: \forall integer v, w, n; n <= 0 && below_29(size(v), 1, scale(-n)) && leads(v, 1, scale(-n), w) &&
      1 <= scale(-n) && scales_joined(28 + n, -n) && times_ordered(scale(28 + n), size(v), scale(-n)) ==> led_29(v, w, n);
    predicate big_square(integer t) = 0xfffffff * 0xfffffff <= square(t);
    lemma big_up: \forall integer t; t >= 0x10000000 && times_ordered(0x10000000, t, t) ==> big_square(t);
    lemma big_down: \forall integer t; -t >= 0x10000000 && times_ordered(0x10000000, -t, -t) ==> big_square(t);
    lemma big_square: \forall integer t; t >= 0x10000000 || t <= -0x10000000 ==> big_square(t);
    lemma full_one: \forall integer u, v, w; (big_square(u) || big_square(v) || big_square(w)) && 0 <= square(u) &&
      0 <= square(v) && 0 <= square(w) ==> full29(u, v, w); */

// What is left of a number below 2^(30 + k) where its bits are moved up by -k.
/*@ predicate moved_30(integer x, integer k) = x * scale(-k) < 0x40000000;
    lemma scale_30: scale(30) == 0x40000000;
    lemma moved_30: \forall integer x, k; scales_joined(30 + k, -k) && 1 <= scale(-k) &&
      times_ordered(x + 1, scale(30 + k), scale(-k)) && x < scale(30 + k) ==> moved_30(x, k);
    // Where a number below 2^30 is moved up to its 32nd bit, two of the bits are to spare; and what is moved down is no larger.
    predicate spare_two(integer x, integer n) = 2 <= n && x * scale(n) == 4 * (x * scale(n - 2));
    predicate twice_moved(integer x, integer n) = x * scale(n + 1) == 2 * (x * scale(n));
    predicate twice_product(integer x, integer a, integer b) = b == 2 * a ==> x * b == 2 * (x * a);
    lemma twice_product: \forall integer x, a, b; twice_product(x, a, b);
    lemma twice_moved: \forall integer x, n; 0 <= n && twice_product(x, scale(n), scale(n + 1)) ==> twice_moved(x, n);
    predicate from_two(integer x, integer n) = 0 <= n && 0x80000000 <= x * scale(n) ==> 2 <= n;
    lemma from_two: \forall integer x, n; x < 0x40000000 && twice_moved(x, 0) ==> from_two(x, n);
    lemma spare_two: \forall integer x, n; 2 <= n && twice_moved(x, n - 1) && twice_moved(x, n - 2) ==> spare_two(x, n);
    predicate down_below(integer x, integer n) = 0 <= down(x, n) <= x && scale(n) * down(x, n) <= x < scale(n) * (down(x, n) + 1);
    lemma down_below: \forall integer x, n; 0 <= x && 0 <= n && times_ordered(1, scale(n), down(x, n)) &&
      times_ordered(down(x, n) + 1, 0, scale(n)) ==> down_below(x, n);
    predicate one_moved(integer n) = (1 << n) == scale(n);
    lemma one_moved: \forall integer n; 0 <= n ==> one_moved(n); */

// A line passes by: what its rounded products tell.
/*@ lemma ball_29: \forall integer a, b, c; within29(a, b, c) ==> in_ball(a, b, c, 0x60000000);
    predicate below_59(integer t) = -0x800000000000000 <= t <= 0x800000000000000;
    predicate short_cross(integer u, integer v, integer w, integer a, integer b, integer c) =
      below_59(cross(v, w, b, c)) && below_59(cross(w, u, c, a)) && below_59(cross(u, v, a, b));
    predicate bounded_29(integer a, integer b) = bounded(a, b, 0x20000000, 0x20000000);
    lemma below_59: \forall integer x, y, u, v; bounded_29(x, v) && bounded_29(y, u) ==> below_59(cross(x, y, u, v));
    lemma short_cross: \forall integer u, v, w, a, b, c; within29(u, v, w) && within29(a, b, c) ==> short_cross(u, v, w, a, b, c);
    predicate dot_29(integer a, integer b, integer c) = FITS(a * a + b * b) && FITS(a * a + b * b + c * c) &&
      dot3(a, b, c, a, b, c) == norm3(a, b, c) && 0 <= norm3(a, b, c) <= 0xc00000000000000;
    lemma dot_29: \forall integer a, b, c; bounded_29(a, a) && bounded_29(b, b) && bounded_29(c, c) && 0 <= square(a) &&
      0 <= square(b) && 0 <= square(c) ==> dot_29(a, b, c);
    predicate floor_30(integer p, integer c) = 0x40000000 * c <= p < 0x40000000 * (c + 1);
    predicate floor_square(integer p, integer c) = 0x1000000000000000 * (c * c - 4 * size(c)) <= p * p;
    predicate square_ordered(integer a, integer b) = a * a <= b * b;
    lemma square_ordered: \forall integer a, b; 0 <= a <= b && times_ordered(a, b, a) && times_ordered(a, b, b) ==>
      square_ordered(a, b);
    lemma floor_up: \forall integer p, c; 0 <= c && square_ordered(0x40000000 * c, p) ==> floor_square(p, c);
    lemma floor_down: \forall integer p, c; c < 0 && square_ordered(0x40000000 * (-c - 1), -p) ==> floor_square(p, c);
    lemma floor_square: \forall integer p, c; floor_30(p, c) ==> floor_square(p, c);
    predicate floor_norm(integer x, integer y, integer z, integer a, integer b, integer c) =
      0x1000000000000000 * (norm3(a, b, c) - 4 * size3(a, b, c)) <= norm3(x, y, z);
    lemma floor_norm: \forall integer x, y, z, a, b, c; floor_square(x, a) && floor_square(y, b) && floor_square(z, c) ==>
      floor_norm(x, y, z, a, b, c);
    predicate product_less(integer a, integer b, integer m, integer n) = a * b < 0x1000000000000000 * (m * n);
    lemma product_less: \forall integer a, b, m, n; 0 <= a < 0x40000000 * m && 0 <= b < 0x40000000 * n &&
      times_ordered(a, 0x40000000 * m - 1, b) && times_ordered(b, 0x40000000 * n - 1, 0x40000000 * m) ==> product_less(a, b, m, n);
    predicate turned_out(integer s, integer e, integer t) = s * e * (s * e) * t == s * s * t * (e * e);
    lemma turned_out: \forall integer s, e, t; turned_out(s, e, t);
    predicate under_limit(integer s, integer t, integer most) = s * s * t < 0x1000000000000000 * most;
    lemma under_limit: \forall integer s, e, t, m, n, most; turned_out(s, e, t) && product_less(s * e * (s * e), t, m, n) &&
      m * n < e * e * most && 1 <= e * e && times_ordered(0x1000000000000000 * most, s * s * t, e * e) ==> under_limit(s, t, most);
    lemma passes_by: \forall integer a, b, c, u, v, w, s, most, x, y, z; under_limit(s + 12, norm3(u, v, w), most) &&
      most < norm3(x, y, z) - 4 * size3(x, y, z) &&
      floor_norm(cross(v, w, b, c), cross(w, u, c, a), cross(u, v, a, b), x, y, z) ==> passes_by(a, b, c, u, v, w, s); */

/*@ requires SHORT(o) && SHORT(t) && 0 <= reach < 0x200000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> stays_off(o, t, reach); */
static bool is_past(int64_t o, int64_t t, int64_t reach);

#define SCALE_UP(k) ((k) < 0 ? scale(-(k)) : 1)
#define SCALE_DOWN(k) ((k) >= 0 ? scale(k) : 1)

/*@ requires \valid_read(v) && \valid(k) && \separated(v, k) && SHORT3(*v) && !ZERO3(*v);
    assigns *k;
    ensures -28 <= *k <= 35;
    ensures led3(XYZ(*v), SCALE_DOWN(*k), SCALE_UP(*k), XYZ(\result));
    ensures within29(XYZ(\result)) && full29(XYZ(\result)); */
static gjk_vec3 leading_bits_of(const gjk_long3 *v, int *k);

/*@ requires \valid_read(o) && \valid_read(t) && SHORT3(*o) && SHORT3(*t) && !ZERO3(*o) && !ZERO3(*t);
    requires 0 <= reach < 0x200000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> off_line(XYZ(*o), XYZ(*t), reach); */
static bool passes(const gjk_long3 *o, const gjk_long3 *t, int64_t reach);

/*@ requires \valid_read(a) && \valid_read(b) && \valid_read(way) && SHORT3(way->t);
    requires CENTRES(a, b) && 0 <= radius < 0x100000000;
    requires 0 <= a->core_radius <= 0x10000000 && 0 <= b->core_radius <= 0x10000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> spheres_pass3(APART(a, b), XYZ(way->t), radius + CORES(a, b)); */
bool gjk_spheres_part(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius);

// The way.
#define MOVES(c, to, k) ((to) == \null ? 0 : (to)->k - (c)->position.k)
#define MOVE(a, b, p, k) (MOVES(b, (p)->to_b, k) - MOVES(a, (p)->to_a, k))
#define MOVE3(a, b, p) MOVE(a, b, p, x), MOVE(a, b, p, y), MOVE(a, b, p, z)
#define PATH(p) \
  (\valid_read(p) && ((p)->to_a == \null || \valid_read((p)->to_a)) && ((p)->to_b == \null || \valid_read((p)->to_b)))

/*@ requires \valid_read(from) && \valid(to) && \separated(from, to);
    assigns *to;
    ensures to->x == from->x && to->y == from->y && to->z == from->z; */
static inline void gjk_set(const gjk_vec3 *from, gjk_vec3 *to);

/*@ requires \valid(saturated);
    assigns *saturated;
    ensures \result == (x < -0x80000000 ? -0x80000000 : x > 0x7fffffff ? 0x7fffffff : x); */
static inline int32_t gjk_saturate_noting(int64_t x, bool *saturated);

/*@ requires \valid(end) && \valid(outside) && \separated(end, outside);
    assigns *end, *outside;
    ensures \result == to - position; */
static int64_t way_along(gjk_q16 position, gjk_q16 to, gjk_q16 centre, gjk_q16 *end, bool *outside);

/*@ requires \valid_read(c) && (to == \null || \valid_read(to)) && \valid(end) && \valid(outside);
    requires \separated(end, outside) && \separated(end, c) && \separated(end, to) && \separated(outside, c);
    requires \separated(outside, to);
    assigns *end, *outside;
    ensures \result.x == MOVES(c, to, x) && \result.y == MOVES(c, to, y) && \result.z == MOVES(c, to, z); */
static gjk_long3 way_of(const gjk_collider *c, const gjk_vec3 *to, gjk_vec3 *end, bool *outside);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool is_short_way(int64_t x);

/*@ requires \valid(way) && \valid_read(a) && \valid_read(b) && (path == \null || PATH(path));
    requires \separated(way, a) && \separated(way, b) && \separated(way, path);
    requires \separated(way, path->to_a) && \separated(way, path->to_b);
    assigns *way;
    ensures \result == GJK_OK ==> path != \null && path->margin >= 0;
    ensures \result == GJK_OK ==> way->t.x == MOVE(a, b, path, x) && way->t.y == MOVE(a, b, path, y) &&
      way->t.z == MOVE(a, b, path, z); */
gjk_status gjk_way_set(gjk_way *way, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path);

// B swept along its way: its vertices at the start of the way, and those at the end. (ux, uy, uz) is from its centre to B's at
// the start; c's vertices are s's.
/*@ predicate early_vertices(gjk_collider *c, gjk_collider *b, integer ux, integer uy, integer uz) = \forall integer j;
      0 <= j < corners(b) ==> px(c, j) == px(b, j) + ux && py(c, j) == py(b, j) + uy && pz(c, j) == pz(b, j) + uz;
    predicate late_vertices(gjk_collider *c, gjk_collider *b, integer ux, integer uy, integer uz) = \forall integer j;
      corners(b) <= j < 2 * corners(b) ==> px(c, j) == px(b, j - corners(b)) + ux && py(c, j) == py(b, j - corners(b)) + uy &&
      pz(c, j) == pz(b, j - corners(b)) + uz;
    predicate swept_vertices(gjk_collider *c, gjk_collider *b, integer ux, integer uy, integer uz,
        integer tx, integer ty, integer tz) = corners(c) == 2 * corners(b) && early_vertices(c, b, ux, uy, uz) &&
      late_vertices(c, b, ux + tx, uy + ty, uz + tz);
    predicate same_vertices(gjk_collider *c, gjk_collider *a) = corners(c) == corners(a) &&
      \forall integer i; 0 <= i < corners(a) ==> px(c, i) == px(a, i) && py(c, i) == py(a, i) && pz(c, i) == pz(a, i);
    predicate swept_pair(gjk_collider *s, gjk_collider *c, gjk_collider *a, gjk_collider *b, integer ux, integer uy, integer uz,
        integer tx, integer ty, integer tz) = same_vertices(s, a) && swept_vertices(c, b, ux, uy, uz, tx, ty, tz);
    predicate spheres_off(gjk_collider *s, gjk_collider *c, integer x, integer y, integer z, integer r) =
      \exists integer ca, cs; 0 <= ca && 0 <= cs && cored(s, ca) && cored(c, cs) && spheres_apart(x, y, z, ca + cs + r);
    // The swept shape and A are farther apart than r; or some of their points are at most that far apart.
    predicate swept_off(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer tx, integer ty, integer tz,
        integer r) = \exists gjk_collider *s, *c; \exists integer ux, uy, uz; swept_pair(s, c, a, b, ux, uy, uz, tx, ty, tz) &&
      (spheres_off(s, c, x + ux, y + uy, z + uz, r) || separated_by3(s, c, x + ux, y + uy, z + uz, r));
    predicate swept_near(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer tx, integer ty, integer tz,
        integer r) = \exists gjk_collider *s, *c; \exists integer ux, uy, uz; swept_pair(s, c, a, b, ux, uy, uz, tx, ty, tz) &&
      together3(s, c, x + ux, y + uy, z + uz, r); */

/*@ lemma swept_off: \forall gjk_collider *a, *b, *s, *c, integer x, y, z, tx, ty, tz, r, ux, uy, uz;
      swept_pair(s, c, a, b, ux, uy, uz, tx, ty, tz) && (spheres_off(s, c, x + ux, y + uy, z + uz, r) ||
      separated_by3(s, c, x + ux, y + uy, z + uz, r)) ==> swept_off(a, b, x, y, z, tx, ty, tz, r);
    lemma swept_near: \forall gjk_collider *a, *b, *s, *c, integer x, y, z, tx, ty, tz, r, ux, uy, uz;
      swept_pair(s, c, a, b, ux, uy, uz, tx, ty, tz) && together3(s, c, x + ux, y + uy, z + uz, r) ==>
      swept_near(a, b, x, y, z, tx, ty, tz, r);
    lemma spheres_off: \forall gjk_collider *s, *c, integer x, y, z, r, ca, cs, m; 0 <= ca && 0 <= cs && cored(s, ca) &&
      cored(c, cs) && spheres_apart(x, y, z, m) && m == ca + cs + r ==> spheres_off(s, c, x, y, z, r); */

#include "src/arith/gjk_root.h"
#include "src/motion/gjk_cast_report.h"
#include "src/motion/gjk_swept.h"

// A point at most half of t, and an LSB, away along each axis is within this length.
#define BELOW27(x) (-0x8000000 < (x) < 0x8000000)
#define SHORT_WAY(x, y, z) (BELOW27(x) && BELOW27(y) && BELOW27(z))
/*@ predicate half_of(integer u, integer t) = -(size(t) + 1) <= 2 * u <= size(t) + 1;
    predicate reached_by(integer tx, integer ty, integer tz, integer l) = \forall integer x, y, z;
      half_of(x, tx) && half_of(y, ty) && half_of(z, tz) ==> in_ball(x, y, z, l); */

/*@ predicate halved_square(integer u, integer t) = 4 * (u * u) <= (size(t) + 1) * (size(t) + 1);
    lemma halved_square: \forall integer u, t; half_of(u, t) ==> halved_square(u, t);
    predicate half_norm(integer x, integer y, integer z, integer tx, integer ty, integer tz) =
      4 * norm3(x, y, z) <= norm3(tx, ty, tz) + 2 * size3(tx, ty, tz) + 3;
    predicate size_squared(integer t) = (size(t) + 1) * (size(t) + 1) == t * t + 2 * size(t) + 1;
    lemma size_squared: \forall integer t; size_squared(t);
    lemma half_norm: \forall integer x, y, z, tx, ty, tz; halved_square(x, tx) && halved_square(y, ty) && halved_square(z, tz) &&
      size_squared(tx) && size_squared(ty) && size_squared(tz) ==> half_norm(x, y, z, tx, ty, tz);
    predicate root_of(integer r, integer n) = 0 <= r && r * r <= n < (r + 1) * (r + 1);
    predicate size_most(integer x, integer y, integer z, integer r) = size3(x, y, z) <= 2 * (r + 1);
    predicate size_square3(integer x, integer y, integer z) = size3(x, y, z) * size3(x, y, z) <= 3 * norm3(x, y, z);
    predicate sum_squared(integer a, integer b, integer c) = (a + b + c) * (a + b + c) <= 3 * norm3(a, b, c);
    lemma sum_squared: \forall integer a, b, c; sum_squared(a, b, c);
    predicate same_norm(integer x, integer y, integer z) = norm3(size(x), size(y), size(z)) == norm3(x, y, z);
    lemma same_norm: \forall integer x, y, z; same_norm(x, y, z);
    lemma sizes_squared: \forall integer x, y, z; sum_squared(size(x), size(y), size(z)) && same_norm(x, y, z) ==>
      size_square3(x, y, z);
    lemma size_square3: \forall integer x, y, z; size_square3(x, y, z);
    lemma size_most: \forall integer x, y, z, r; root_of(r, norm3(x, y, z)) && size_square3(x, y, z) &&
      square_ordered(2 * (r + 1), size3(x, y, z)) ==> size_most(x, y, z, r);
    predicate in_length(integer n, integer r, integer l) = 4 * n <= (r + 3) * (r + 3) && r + 3 <= 2 * l;
    lemma in_length: \forall integer x, y, z, tx, ty, tz, r, l; half_norm(x, y, z, tx, ty, tz) && root_of(r, norm3(tx, ty, tz)) &&
      size3(tx, ty, tz) <= 2 * (r + 1) && r + 3 <= 2 * l ==> in_length(norm3(x, y, z), r, l);
    lemma length_ball: \forall integer x, y, z, r, l; in_length(norm3(x, y, z), r, l) && square_ordered(r + 3, 2 * l) ==>
      in_ball(x, y, z, l);
    lemma root_below: \forall integer r, n; root_of(r, n) && n <= 3 * 0x40000000000000 && square_ordered(0xe000000, r) ==>
      r < 0xe000000;
    lemma root_most: \forall integer r, n; root_of(r, n) && n <= 3 * 0x40000000000000 ==> r < 0xe000000; */

// Tested for each of Newton's steps, not proven.
/*@ assigns \nothing;
    ensures root_of(\result, x); */
uint32_t gjk_isqrt64(uint64_t x);

/*@ requires \valid_read(t) && SHORT_WAY(t->x, t->y, t->z);
    assigns \nothing;
    ensures 2 <= \result <= 0x7000001;
    ensures reached_by(XYZ(*t), \result); */
static int32_t half_length(const gjk_vec3 *t);

/*@ requires -0x80000000 <= apart < 0x80000000 && \valid(other);
    assigns *other;
    ensures \result - *other == apart; */
static int32_t part_of(int64_t apart, int32_t *other);

/*@ requires \valid(to) && \valid_read(from) && \separated(to, from);
    assigns *to;
    ensures to->shape == from->shape && to->core_radius == from->core_radius && to->radius == from->radius; */
static void copy_collider(gjk_collider *to, const gjk_collider *from);

#define BACK(s) XYZ((s)->back)
// Centres and sizes for which B may be swept.
#define SWEEPS(a, b)                                                                                   \
  (CENTRES(a, b) && b->core_radius + b->shape->convex_radius <= 0x8000000 && b->radius <= 0x8000000 && \
   (b->shape->type->kind != GJK_KIND_AXES || b->count <= 3))

// That the class's vertex function gives these vertices, and that the copy of A has A's, is taken as given.
/*@ requires \valid(s) && solid(a) && solid(b) && a->shape->type->stalls == \null && b->shape->type->stalls == \null;
    requires \valid_read(way) && \separated(s, a) && \separated(s, b) && \separated(s, way);
    requires \separated(s, a->shape) && \separated(s, b->shape) && \separated(s, a->shape->type) && \separated(s, b->shape->type);
    requires SHORT_WAY(way->t.x, way->t.y, way->t.z) && SWEEPS(a, b);
    assigns *s;
    ensures \result == 0 || \result == 1;
    ensures back: \result == 1 ==> half_of(s->back.x, way->t.x) && half_of(s->back.y, way->t.y) && half_of(s->back.z, way->t.z);
    ensures ahead: \result == 1 ==> s->ahead.x == s->back.x + way->t.x && s->ahead.y == s->back.y + way->t.y &&
      s->ahead.z == s->back.z + way->t.z;
    ensures ends: \result == 1 ==> half_of(s->ahead.x, way->t.x) && half_of(s->ahead.y, way->t.y) && half_of(s->ahead.z, way->t.z);
    ensures apart: \result == 1 ==> APART_X(&s->still, &s->swept) == APART_X(a, b) + s->back.x &&
      APART_Y(&s->still, &s->swept) == APART_Y(a, b) + s->back.y && APART_Z(&s->still, &s->swept) == APART_Z(a, b) + s->back.z;
    ensures still: \result == 1 ==> s->still.shape == a->shape && s->still.core_radius == a->core_radius &&
      s->still.radius == a->radius;
    ensures shape: \result == 1 ==> s->swept.shape == &s->shape && s->shape.convex_radius == b->shape->convex_radius;
    ensures length: \result == 1 ==> reached_by(XYZ(way->t), s->swept.core_radius - b->core_radius) &&
      s->swept.core_radius - b->core_radius == s->swept.radius - b->radius &&
      2 <= s->swept.core_radius - b->core_radius <= 0x7000001;
    ensures count: \result == 1 ==> s->count <= 0x7fff;
    admit ensures counted: \result == 1 ==> s->count == corners(b);
    admit ensures class: \result == 1 ==> \valid_read(s->shape.type) && s->shape.type->vertex == &space_vertex &&
      s->shape.type->stalls == \null;
    admit ensures vertices: \result == 1 ==> swept_pair(&s->still, &s->swept, a, b, BACK(s), XYZ(way->t)); */
bool gjk_swept_set(gjk_swept *s, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

// The checker.
/*@ predicate within_sum(integer x, integer y, integer z, integer u, integer v, integer w, integer r, integer l) =
      in_ball(x + u, y + v, z + w, r + l);
    lemma within_sum: \forall integer x, y, z, u, v, w, r, l; 0 <= r && 0 <= l && in_ball(x, y, z, r) && in_ball(u, v, w, l) ==>
      within_sum(x, y, z, u, v, w, r, l);
    predicate cored_beside(gjk_collider *b, integer ux, integer uy, integer uz, integer r, integer l) = \forall integer j;
      0 <= j < corners(b) ==> within_sum(px(b, j), py(b, j), pz(b, j), ux, uy, uz, r, l);
    lemma cored_beside: \forall gjk_collider *b, integer ux, uy, uz, r, l; 0 <= r && 0 <= l && cored(b, r) &&
      in_ball(ux, uy, uz, l) ==> cored_beside(b, ux, uy, uz, r, l);
    predicate cored_early(gjk_collider *c, integer n, integer r) = \forall integer j;
      0 <= j < n ==> in_ball(px(c, j), py(c, j), pz(c, j), r);
    predicate cored_late(gjk_collider *c, integer n, integer r) = \forall integer j;
      n <= j < corners(c) ==> in_ball(px(c, j), py(c, j), pz(c, j), r);
    lemma cored_early: \forall gjk_collider *c, *b, integer ux, uy, uz, r, l; cored_beside(b, ux, uy, uz, r, l) &&
      early_vertices(c, b, ux, uy, uz) ==> cored_early(c, corners(b), r + l);
    lemma cored_late: \forall gjk_collider *c, *b, integer ux, uy, uz, r, l; cored_beside(b, ux, uy, uz, r, l) &&
      late_vertices(c, b, ux, uy, uz) && corners(c) == 2 * corners(b) ==> cored_late(c, corners(b), r + l);
    lemma cored_ends: \forall gjk_collider *c, integer n, r; cored_early(c, n, r) && cored_late(c, n, r) ==> cored(c, r);
    lemma cored_swept: \forall gjk_collider *c, *b, integer ux, uy, uz, tx, ty, tz, r, l; cored_beside(b, ux, uy, uz, r, l) &&
      cored_beside(b, ux + tx, uy + ty, uz + tz, r, l) && swept_vertices(c, b, ux, uy, uz, tx, ty, tz) ==> cored(c, r + l);
    lemma ball_larger: \forall integer x, y, z, r, s; square_ordered(r, s) && in_ball(x, y, z, r) ==> in_ball(x, y, z, s);
    lemma cored_larger: \forall gjk_collider *c, integer r; 0 <= r <= 0x10000000 && cored(c, r) &&
      square_ordered(r, 0x10000000) ==> cored(c, 0x10000000);
    lemma cored_same: \forall gjk_collider *c, *a, integer r; cored(a, r) && same_vertices(c, a) ==> cored(c, r); */

/*@ assigns *out; */
gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, gjk_cache *cache,
                      gjk_decision *out);

/*@ requires solid(a) && solid(b);
    assigns \nothing;
    ensures \result == GJK_OK && within != 0 ==> together3(a, b, APART(a, b), RADII(a, b) + margin);
    ensures \result == GJK_OK && within == 0 ==>
      SPHERES(a, b, RADII(a, b) + margin) || separated_by3(a, b, APART(a, b), RADII(a, b) + margin); */
static gjk_status prove_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, bool within);

/*@ assigns *out; */
void gjk_cast_report_start(const gjk_collider *a, const gjk_collider *b, gjk_cast_result *out);

/*@ requires \valid_read(v) && \valid_read(w);
    assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool same_vector(const gjk_vec3 *v, const gjk_vec3 *w);

/*@ requires \valid_read(v) && \valid_read(w);
    assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool same_normal(const gjk_unit3 *v, const gjk_unit3 *w);

/*@ requires \valid_read(r) && \valid_read(s);
    assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool same_report(const gjk_cast_result *r, const gjk_cast_result *s);

/*@ requires solid(a) && solid(b) && \valid_read(result);
    assigns \nothing;
    ensures \result == GJK_OK ==> together3(a, b, APART(a, b), RADII(a, b) + margin); */
static gjk_status prove_start(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin,
                              const gjk_cast_result *result);

/*@ requires solid(a) && solid(b) && a->shape->type->stalls == \null && b->shape->type->stalls == \null;
    requires \valid_read(way) && \valid_read(result) && SHORT_WAY(way->t.x, way->t.y, way->t.z) && SWEEPS(a, b);
    assigns \nothing;
    ensures miss: \result == GJK_OK && result->hit == 0 ==>
      swept_off(a, b, APART(a, b), XYZ(way->t), RADII(a, b) + margin);
    ensures comes: \result == GJK_OK && result->hit != 0 ==> swept_near(a, b, APART(a, b), XYZ(way->t), RADII(a, b) + margin);
    ensures inside: \result == GJK_OK && result->hit != 0 && result->inside != 0 ==>
      together3(a, b, APART(a, b), RADII(a, b) + margin);
    ensures later: \result == GJK_OK && result->hit != 0 && result->inside == 0 ==>
      SPHERES(a, b, RADII(a, b) + margin) || separated_by3(a, b, APART(a, b), RADII(a, b) + margin); */
static gjk_status check_rounded(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, gjk_q16 margin,
                                const gjk_cast_result *result);

/*@ assigns *p; */
void gjk_portal_start(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

/*@ assigns *p; */
void gjk_portal_face(gjk_portal *p, const gjk_vec3 *g);

/*@ assigns *p; */
bool gjk_portal_load(gjk_portal *p, const gjk_cast_certificate *certificate);

/*@ assigns p->axis; */
bool gjk_portal_is_entry(gjk_portal *p);

/*@ assigns *out; */
void gjk_cast_report_entry(const gjk_portal *p, const gjk_way *way, gjk_cast_result *out);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool is_small(const gjk_vec3 *d);

/*@ assigns *p; */
static bool is_beside(gjk_portal *p, const gjk_vec3 *direction);

/*@ assigns \nothing; */
static bool is_behind_ends(const gjk_portal *p);

/*@ assigns *p; */
static bool is_entry_facet(gjk_portal *p);

/*@ requires solid(a) && solid(b) && \valid_read(way) && \valid_read(result);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 && result->hit != 0 && result->inside != 0 ==> together3(a, b, APART(a, b), RADII(a, b)); */
static bool is_proven(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, const gjk_cast_result *result);

/*@ requires \valid_read(shape) && \valid_read(shape->type);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 <==> shape->type->stalls == \null; */
static inline bool gjk_is_curved(const gjk_shape *shape);

#define MARGIN(a, b, p) (RADII(a, b) + (p)->margin)

// What a checked cast means for the vertices; solid.v goes on from there. For ways of less than 2^27 LSB along each axis,
// and a B of at most that radius.
/*@ requires solid(a) && solid(b) && PATH(path) && \valid_read(result);
    requires SHORT_WAY(MOVE(a, b, path, x), MOVE(a, b, path, y), MOVE(a, b, path, z)) && SWEEPS(a, b);
    assigns \nothing;
    ensures \result == GJK_OK ==> 0 <= path->margin;
    ensures miss: \result == GJK_OK && result->hit == 0 && 0 < MARGIN(a, b, path) ==>
      spheres_pass3(APART(a, b), MOVE3(a, b, path), CORES(a, b) + MARGIN(a, b, path)) ||
      swept_off(a, b, APART(a, b), MOVE3(a, b, path), MARGIN(a, b, path));
    ensures inside: \result == GJK_OK && result->hit != 0 && result->inside != 0 ==>
      together3(a, b, APART(a, b), MARGIN(a, b, path));
    ensures comes: \result == GJK_OK && result->hit != 0 && 0 < MARGIN(a, b, path) ==>
      swept_near(a, b, APART(a, b), MOVE3(a, b, path), MARGIN(a, b, path));
    ensures later: \result == GJK_OK && result->hit != 0 && result->inside == 0 && 0 < MARGIN(a, b, path) ==>
      SPHERES(a, b, MARGIN(a, b, path)) || separated_by3(a, b, APART(a, b), MARGIN(a, b, path)); */
gjk_status gjk_check_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                          const gjk_cast_result *result);

#endif
