// Contracts of the decision checker of space.
#ifndef PROVE_CHECKER_SPACE_H
#define PROVE_CHECKER_SPACE_H

#include "solid.h"
#include "wide.h"

// Centres, A's less B's: before the sources, whose annotations name them.
#define APART_X(a, b) ((a)->centre.x - (b)->centre.x)
#define APART_Y(a, b) ((a)->centre.y - (b)->centre.y)
#define APART_Z(a, b) ((a)->centre.z - (b)->centre.z)
#define APART(a, b) APART_X(a, b), APART_Y(a, b), APART_Z(a, b)
#define NEAR(a, b) in_ball(APART(a, b), 0x40000000)
#define SPHERES(a, b, radius) spheres_apart(APART(a, b), (a)->core_radius + (b)->core_radius + (radius))
#define XYZ(v) (v).x, (v).y, (v).z

#include "gjk/check.h"

// Vertex i of a collider, relative to its centre, and how many there are.
/*@ axiomatic corners {
      logic integer px(gjk_collider *c, integer i) reads \nothing;
      logic integer py(gjk_collider *c, integer i) reads \nothing;
      logic integer pz(gjk_collider *c, integer i) reads \nothing;
      logic integer corners(gjk_collider *c) reads \nothing;
    } */

// What holds of each vertex of A - B.
/*@ predicate behind3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z,
        integer dx, integer dy, integer dz, integer h) = \forall integer i, j; 0 <= i < corners(a) && 0 <= j < corners(b) ==>
      behind_one3(dx, dy, dz, x, y, z, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j), h);
    predicate all_beyond3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z,
        integer dx, integer dy, integer dz, integer r) = \forall integer i, j; 0 <= i < corners(a) && 0 <= j < corners(b) ==>
      beyond_one3(dx, dy, dz, x, y, z, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j), r); */
// No vertex of the collider lies beyond h along d.
/*@ predicate all_along(gjk_collider *c, integer dx, integer dy, integer dz, integer h) =
      \forall integer i; 0 <= i < corners(c) ==> dot3(px(c, i), py(c, i), pz(c, i), dx, dy, dz) <= h;
    lemma sum_along: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz, ex, ey, ez, m, n, h;
      all_along(a, dx, dy, dz, m) && all_along(b, ex, ey, ez, n) && ex == -dx && ey == -dy && ez == -dz &&
      h == dot3(x, y, z, dx, dy, dz) + m + n ==> behind3(a, b, x, y, z, dx, dy, dz, h); */
/*@ lemma all_beyond3: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz, h, r;
      behind3(a, b, x, y, z, dx, dy, dz, h) && clear3(dx, dy, dz, h, r) ==> all_beyond3(a, b, x, y, z, dx, dy, dz, r); */

// Sizes of edges and products.
/*@ lemma difference_square: \forall integer x, u; (u - x) * (u - x) <= 2 * (u * u) + 2 * (x * x);
    lemma difference_norm: \forall integer x, y, z, u, v, w;
      norm3(u - x, v - y, w - z) <= 2 * norm3(x, y, z) + 2 * norm3(u, v, w);
    lemma difference_ball: \forall integer x, y, z, u, v, w, r;
      in_ball(x, y, z, r) && in_ball(u, v, w, r) ==> in_ball(u - x, v - y, w - z, 2 * r);
    predicate span3(integer x, integer y, integer z, integer u, integer v, integer w) =
      in_ball(u - x, v - y, w - z, 0x7fffffff); */

/*@ predicate cross_small3(integer x, integer y, integer z, integer u, integer v, integer w) =
      SMALL62(cross(y, z, v, w)) && SMALL62(cross(z, x, w, u)) && SMALL62(cross(x, y, u, v)) &&
      SMALL62(dot3(x, y, z, u, v, w));
    lemma lagrange_cross: \forall integer x, y, z, u, v, w; norm3(x, y, z) * norm3(u, v, w) == square(dot3(x, y, z, u, v, w)) +
      square(cross(x, y, u, v)) + square(cross(y, z, v, w)) + square(cross(z, x, w, u));
    predicate all_below(integer a, integer b, integer c, integer d, integer n) =
      square(a) <= n && square(b) <= n && square(c) <= n && square(d) <= n;
    lemma all_below: \forall integer n, a, b, c, d;
      square(d) + square(a) + square(b) + square(c) == n ==> all_below(a, b, c, d, n);
    lemma cross_below: \forall integer x, y, z, u, v, w; all_below(cross(x, y, u, v), cross(y, z, v, w), cross(z, x, w, u),
      dot3(x, y, z, u, v, w), norm3(x, y, z) * norm3(u, v, w));
    lemma square_small: \forall integer t; square(t) < 0x10000000000000000000000000000000 ==> SMALL62(t);
    lemma all_small: \forall integer a, b, c, d, n; all_below(a, b, c, d, n) && n < 0x10000000000000000000000000000000 ==>
      SMALL62(a) && SMALL62(b) && SMALL62(c) && SMALL62(d);
    predicate product_small(integer a, integer b) = a * b < 0x10000000000000000000000000000000;
    lemma cross_small3: \forall integer x, y, z, u, v, w;
      product_small(norm3(x, y, z), norm3(u, v, w)) ==> cross_small3(x, y, z, u, v, w);
    lemma spots_product: \forall integer a, b;
      0 <= a <= 0x60000000 * 0x60000000 && 0 <= b <= 0x60000000 * 0x60000000 ==> product_small(a, b);
    lemma spans_product: \forall integer a, b;
      0 <= a <= 0x7fffffff * 0x7fffffff && 0 <= b <= 0x7fffffff * 0x7fffffff ==> product_small(a, b);
    lemma cross_of_spots: \forall integer x, y, z, u, v, w;
      in_ball(x, y, z, 0x60000000) && in_ball(u, v, w, 0x60000000) ==> cross_small3(x, y, z, u, v, w);
    lemma cross_of_spans: \forall integer x, y, z, u, v, w;
      in_ball(x, y, z, 0x7fffffff) && in_ball(u, v, w, 0x7fffffff) ==> cross_small3(x, y, z, u, v, w);
    predicate dot_within(integer x, integer y, integer z, integer u, integer v, integer w) =
      -0x3000000000000000 <= dot3(x, y, z, u, v, w) <= 0x3000000000000000;
    lemma under_opposite: \forall integer t, d, p; under(t, d, p) ==> under(-t, d, p);
    lemma balls_opposite: \forall integer x, y, z, u, v, w, r, s;
      0 <= r && 0 <= s && in_ball(x, y, z, r) && in_ball(u, v, w, s) ==> at_most(-dot3(x, y, z, u, v, w), r, s);
    lemma at_most_constant: \forall integer t; at_most(t, 0x60000000, 0x7fffffff) ==> t <= 0x3000000000000000;
    lemma dot_within: \forall integer x, y, z, u, v, w;
      in_ball(x, y, z, 0x60000000) && in_ball(u, v, w, 0x7fffffff) ==> dot_within(x, y, z, u, v, w);
    lemma toward_dot: \forall integer x, y, z, u, v, w; toward3(x, y, z, u, v, w) == -dot3(x, y, z, u - x, v - y, w - z);
    lemma toward_dots: \forall integer x, y, z, u, v, w, s, t, q;
      toward3(x, y, z, u, v, w) - toward3(x, y, z, s, t, q) == -dot3(x, y, z, u - s, v - t, w - q); */

/*@ predicate toward_small(integer x, integer y, integer z, integer u, integer v, integer w) =
      -0x3000000000000000 <= toward3(x, y, z, u, v, w) <= 0x3000000000000000;
    lemma toward_small: \forall integer x, y, z, u, v, w;
      in_ball(x, y, z, 0x60000000) && span3(x, y, z, u, v, w) ==> toward_small(x, y, z, u, v, w);
    predicate toward_apart(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      -0x3000000000000000 <= toward3(x, y, z, u, v, w) - toward3(x, y, z, s, t, q) <= 0x3000000000000000;
    lemma toward_apart: \forall integer x, y, z, u, v, w, s, t, q;
      in_ball(x, y, z, 0x60000000) && span3(s, t, q, u, v, w) ==> toward_apart(x, y, z, u, v, w, s, t, q);
    lemma span_turned: \forall integer x, y, z, u, v, w; span3(x, y, z, u, v, w) ==> span3(u, v, w, x, y, z); */

/*@ predicate area_turned(integer x, integer y, integer u, integer v, integer s, integer t) =
      area3(u, v, x, y, s, t) == -area3(x, y, u, v, s, t);
    lemma area_turned: \forall integer x, y, u, v, s, t; area_turned(x, y, u, v, s, t);
    predicate area_small(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      SMALL62(area3(y, z, v, w, t, q)) && SMALL62(area3(z, x, w, u, q, s)) && SMALL62(area3(x, y, u, v, s, t));
    lemma area_of_cross: \forall integer x, y, z, u, v, w, s, t, q;
      cross_small3(u - x, v - y, w - z, s - x, t - y, q - z) ==> area_small(x, y, z, u, v, w, s, t, q);
    lemma area_small: \forall integer x, y, z, u, v, w, s, t, q;
      span3(x, y, z, u, v, w) && span3(x, y, z, s, t, q) ==> area_small(x, y, z, u, v, w, s, t, q); */

// Dot products of numbers in two digits: x = 2^32 high_part + low_part, -2^31 <= low_part < 2^31.
/*@ logic integer high_part(integer x) = down(x + 0x80000000, 32);
    logic integer low_part(integer x) = x - 0x100000000 * high_part(x);
    predicate half_parts(integer x) = -0x80000000 <= low_part(x) <= 0x7fffffff;
    predicate small_high(integer x) = -0x40000000 <= high_part(x) <= 0x40000000;
    logic integer size(integer x) = x < 0 ? -x : x;
    predicate sized(integer l, integer x, integer m) = -(m * size(x)) <= l * x <= m * size(x);
    predicate square_short(integer t) = t * t < 0x10000000000000000;
    predicate sum_small(integer a, integer b, integer c) = a + b + c < 0x100000000;
    predicate short3(integer x, integer y, integer z) = sum_small(size(x), size(y), size(z));
    predicate sized3(integer a, integer b, integer c, integer x, integer y, integer z, integer m) =
      sized(a, x, m) && sized(b, y, m) && sized(c, z, m);
    predicate dot_below(integer a, integer b, integer c, integer x, integer y, integer z, integer m) =
      -m < dot3(a, b, c, x, y, z) < m && -m < a * x + b * y < m && -m < a * x < m;
    predicate dot_split(integer a, integer b, integer c, integer p, integer q, integer r, integer x, integer y, integer z) =
      dot3(a, b, c, x, y, z) == 0x100000000 * dot3(p, q, r, x, y, z) +
      dot3(a - 0x100000000 * p, b - 0x100000000 * q, c - 0x100000000 * r, x, y, z); */

#include "src/arith/gjk_vector.h"

// 2^n.
/*@ axiomatic scales {
      logic integer scale(integer n) reads \nothing;
      axiom scale_none: scale(0) == 1;
      axiom scale_next: \forall integer n; 0 <= n ==> scale(n + 1) == 2 * scale(n);
      axiom scale_least: \forall integer n; 0 <= n ==> 1 <= scale(n);
    } */

// What C's shifts to the left have to do with it.
/*@ predicate scales_joined(integer m, integer n) = scale(m) * scale(n) == scale(m + n);
    predicate moved_left(integer x, integer n) = (x << n) == x * scale(n);
    predicate moved_right(integer x, integer n) = scale(n) * down(x, n) <= x < scale(n) * (down(x, n) + 1);
    axiomatic scaled {
      axiom scales_joined: \forall integer m, n; 0 <= m && 0 <= n ==> scales_joined(m, n);
      axiom moved_left: \forall integer x, n; 0 <= n ==> moved_left(x, n);
      axiom moved_right: \forall integer x, n; 0 <= n ==> moved_right(x, n);
    } */

#define REACH 0x60000000
// What the frame holds: f times the centres' difference (x, y, z), with room for cores whose radii add up to c; and the
// radius r, or less.
/*@ predicate framed(integer x, integer y, integer z, integer c, integer f, integer dx, integer dy, integer dz) =
      1 <= f && dx == f * x && dy == f * y && dz == f * z && 0 <= f * c <= 0x3fffffff &&
      in_ball(dx, dy, dz, 0x40000000) && in_ball(dx, dy, dz, REACH - f * c); */
// In the frame a radius of r LSB is f r, or a lower one that no point at most f c from (x, y, z) is beyond.
/*@ predicate radius_kept(integer radius, integer r, integer f, integer x, integer y, integer z, integer c) =
      radius == f * r || (f * c <= radius && in_ball(x, y, z, radius - f * c)); */
/*@ predicate room_one(integer c) = 0x40000000 * 0x40000000 <= (REACH - c) * (REACH - c);
    lemma room_one: \forall integer c; 0 <= c <= 0x20000000 ==> room_one(c);
    lemma framed_one: \forall integer x, y, z, c;
      0 <= c <= 0x20000000 && in_ball(x, y, z, 0x40000000) ==> framed(x, y, z, c, 1, x, y, z); */
#define CORES(a, b) ((a)->core_radius + (b)->core_radius)

#include "src/gjk/gjk_frame.h"

// Stands for the class's vertex function.
/*@ requires \valid(offset) && \valid_read(c) && \separated(offset, c);
    assigns *offset;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> number < corners(c);
    ensures \result == 1 ==> offset->x == px(c, number) && offset->y == py(c, number) && offset->z == pz(c, number); */
bool space_vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset);

// What gjk_collider_init and gjk_collider_pose leave in a collider, as far as the checker needs it. Taken as given.
/*@ predicate polyhedral(gjk_collider *c) =
      c->shape->type->vertex == &space_vertex && 1 <= corners(c) <= 0xffff &&
      (\forall integer i; 0 <= i < corners(c) ==> in_ball(px(c, i), py(c, i), pz(c, i), 0x10000000));
    predicate cored(gjk_collider *c, integer r) =
      \forall integer i; 0 <= i < corners(c) ==> in_ball(px(c, i), py(c, i), pz(c, i), r);
    predicate solid(gjk_collider *c) =
      \valid_read(c) && \valid_read(c->shape) && \valid_read(c->shape->type) &&
      1 <= c->core_radius && 0 <= c->shape->convex_radius && c->core_radius + c->shape->convex_radius <= 0xfff0004 &&
      0 <= c->radius <= 0x10000000 &&
      (c->shape->type->stalls == \null ==> polyhedral(c) && cored(c, c->core_radius)); */

#define RADII(a, b) ((a)->shape->convex_radius + (b)->shape->convex_radius)
#define SOLID(c) (\valid_read(c) && \valid_read((c)->shape) && \valid_read((c)->shape->type) && polyhedral(c))
#define FITS(x) (-0x8000000000000000 <= (x) <= 0x7fffffffffffffff)

// Vectors.
/*@ requires -0x80000000 < a.x - b.x <= 0x7fffffff && -0x80000000 < a.y - b.y <= 0x7fffffff;
    requires -0x80000000 < a.z - b.z <= 0x7fffffff;
    assigns \nothing;
    ensures \result.x == a.x - b.x && \result.y == a.y - b.y && \result.z == a.z - b.z; */
static inline gjk_vec3 gjk_sub(gjk_vec3 a, gjk_vec3 b);

/*@ requires a.x > -0x80000000 && a.y > -0x80000000 && a.z > -0x80000000;
    assigns \nothing;
    ensures \result.x == -a.x && \result.y == -a.y && \result.z == -a.z; */
static inline gjk_vec3 gjk_negate(gjk_vec3 a);

/*@ requires \valid_read(a) && \valid_read(b);
    requires FITS(a->x * b->x + a->y * b->y) && FITS(a->x * b->x + a->y * b->y + a->z * b->z);
    assigns \nothing;
    ensures \result == dot3(XYZ(*a), XYZ(*b)); */
static inline int64_t gjk_dot(const gjk_vec3 *a, const gjk_vec3 *b);

/*@ requires SMALL62(p) && SMALL62(q) && SMALL62(r) && SMALL62(s);
    assigns \nothing;
    ensures \result == (p * q + r * s < 0 ? -1 : p * q + r * s == 0 ? 0 : 1); */
static inline int gjk_sum_of_products_sign(int64_t p, int64_t q, int64_t r, int64_t s);

/*@ requires \valid_read(a) && \valid_read(b) && \valid(out) && \separated(out, a) && \separated(out, b);
    requires cross_small3(XYZ(*a), XYZ(*b)) && a->x > -0x80000000 && a->y > -0x80000000 && a->z > -0x80000000;
    assigns *out;
    ensures out->x == cross(a->y, a->z, b->y, b->z);
    ensures out->y == cross(a->z, a->x, b->z, b->x);
    ensures out->z == cross(a->x, a->y, b->x, b->y); */
static inline void gjk_cross(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out);

#define SMALL_LONG(n) (SMALL62((n)->x) && SMALL62((n)->y) && SMALL62((n)->z))
#define SIGN(x) ((x) < 0 ? -1 : (x) == 0 ? 0 : 1)

/*@ requires \valid_read(n) && \valid_read(v) && SMALL_LONG(n) && in_ball(XYZ(*v), 0x60000000);
    assigns \nothing;
    ensures \result == SIGN(dot3(XYZ(*n), XYZ(*v))); */
int gjk_dot_sign_exact(const gjk_long3 *n, const gjk_vec3 *v);

/*@ requires \valid_read(n) && \valid_read(v) && SMALL_LONG(n) && in_ball(XYZ(*v), 0x60000000);
    assigns \nothing;
    ensures \result == SIGN(dot3(XYZ(*n), XYZ(*v))); */
static inline int gjk_dot_sign(const gjk_long3 *n, const gjk_vec3 *v);

/*@ requires \valid_read(a) && \valid_read(b) && \valid_read(c) && \valid(out);
    requires \separated(out, a) && \separated(out, b) && \separated(out, c);
    requires span3(XYZ(*a), XYZ(*b)) && span3(XYZ(*a), XYZ(*c));
    assigns *out;
    ensures out->x == area3(a->y, a->z, b->y, b->z, c->y, c->z);
    ensures out->y == area3(a->z, a->x, b->z, b->x, c->z, c->x);
    ensures out->z == area3(a->x, a->y, b->x, b->y, c->x, c->y); */
static inline void gjk_triangle_normal(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, gjk_long3 *out);

/*@ requires 0 < x;
    assigns \nothing;
    ensures \result <= 31 && 0x80000000 <= x * scale(\result) <= 0xffffffff; */
static inline unsigned gjk_clz32(uint32_t x);

/*@ requires n <= 31 && -0x80000000 <= x * scale(n) <= 0x7fffffff;
    assigns \nothing;
    ensures \result == x * scale(n); */
static inline int32_t gjk_shl32(int32_t x, unsigned n);

/*@ requires v.x > -0x80000000 && v.y > -0x80000000 && v.z > -0x80000000;
    requires size3(XYZ(v)) <= 0xffffffff;
    assigns \nothing;
    ensures \result == size3(XYZ(v)); */
static inline uint32_t gjk_norm1(gjk_vec3 v);

// The direction from an edge to the origin.
#define SPAN33(x) (-0x100000000 <= (x) < 0x100000000)
#define SPAN32(x) (-0x80000000 <= (x) < 0x80000000)

#define LOW31(x) ((x)-0x80000000 * down(x, 31))

/*@ requires \valid_read(v);
    assigns \nothing;
    ensures \result == 0 ==> SPAN33(v->x) && SPAN33(v->y) && SPAN33(v->z);
    ensures v->x == 0 && v->y == 0 && v->z == 0 ==> \result == 0; */
static uint32_t high_bits(const gjk_long3 *v);

/*@ requires \valid_read(v) && SPAN33(v->x) && SPAN33(v->y) && SPAN33(v->z);
    assigns \nothing;
    ensures (\result & 0x80000000) == 0 ==> SPAN32(v->x) && SPAN32(v->y) && SPAN32(v->z);
    ensures v->x == 0 && v->y == 0 && v->z == 0 ==> \result == 0; */
static uint32_t low_bits(const gjk_long3 *v);

/*@ requires n == 31 && SPAN32(x);
    assigns \nothing;
    ensures \result == 0x80000000 * x; */
static inline int64_t gjk_shl64(int64_t x, unsigned n);

#define PART(t) (0 < (t) <= 0x3000000000000000)
/*@ requires -REACH <= a <= REACH && -REACH <= b <= REACH && PART(ta) && PART(tb) && \valid(high);
    assigns *high;
    ensures 0 <= \result < 0x80000000;
    ensures 0x80000000 * *high + \result == -(a * tb + b * ta); */
static uint32_t combine(int32_t a, int64_t tb, int32_t b, int64_t ta, int64_t *high);

/*@ requires \valid_read(n) && \valid(out) && \separated(n, out);
    assigns *out; */
void gjk_search_direction_of(const gjk_long3 *n, gjk_search_direction *out);

/*@ requires \valid_read(a) && \valid_read(b) && \valid(out) && \separated(a, out) && \separated(b, out);
    requires -REACH <= a->x <= REACH && -REACH <= a->y <= REACH && -REACH <= a->z <= REACH && PART(ta);
    requires -REACH <= b->x <= REACH && -REACH <= b->y <= REACH && -REACH <= b->z <= REACH && PART(tb);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> meets_one(a->x, b->x, ta, tb) && meets_one(a->y, b->y, ta, tb) && meets_one(a->z, b->z, ta, tb);
    ensures led: \result == 1 ==>
      !(meets_one(a->x, b->x, ta, tb) && meets_one(a->y, b->y, ta, tb) && meets_one(a->z, b->z, ta, tb)); */
bool gjk_search_direction_of_edge(const gjk_vec3 *a, int64_t tb, const gjk_vec3 *b, int64_t ta,
                                  gjk_search_direction *out);

// The exact direction from a feature to the origin, or its opposite: a component of it.
/*@ logic integer way(integer opposite, integer count, integer a, integer tb, integer b, integer ta, integer n) =
      opposite == 0 ? (count == 3 ? n : count == 1 ? -a : -(a * tb + b * ta)) :
      (count == 3 ? -n : count == 1 ? a : a * tb + b * ta); */
#define WAY_X(g, o) way(o, (g)->spanning, (g)->a->x, (g)->tb, (g)->b->x, (g)->ta, (g)->n->x)
#define WAY_Y(g, o) way(o, (g)->spanning, (g)->a->y, (g)->tb, (g)->b->y, (g)->ta, (g)->n->y)
#define WAY_Z(g, o) way(o, (g)->spanning, (g)->a->z, (g)->tb, (g)->b->z, (g)->ta, (g)->n->z)
#define WAY(g, o) WAY_X(g, o), WAY_Y(g, o), WAY_Z(g, o)
#define LEADS(g)                                                                                                      \
  (1 <= (g)->spanning <= 3 && ((g)->spanning == 3 || (\valid_read((g)->a) && in_ball(XYZ(*(g)->a), REACH))) &&        \
   ((g)->spanning != 2 || (\valid_read((g)->b) && in_ball(XYZ(*(g)->b), REACH) && PART((g)->ta) && PART((g)->tb))) && \
   ((g)->spanning != 3 || (\valid_read((g)->n) && SMALL_LONG((g)->n))))

/*@ requires \valid_read(direction) && LEADS(direction) && \valid_read(v) && in_ball(XYZ(*v), 0x20000000);
    assigns \nothing;
    ensures \result == SIGN(dot3(WAY(direction, direction->opposite), XYZ(*v))); */
int gjk_direction_sign(const gjk_direction *direction, const gjk_vec3 *v);

// The checker.
#define EXTENT 0x1800000000000000
#define DIRECTION(d) (-REACH <= (d).x <= REACH && -REACH <= (d).y <= REACH && -REACH <= (d).z <= REACH)
#define FULL(x) (-0x7fffffff <= (x) <= 0x7fffffff)

/*@ requires SOLID(c) && \valid_read(d) && FULL(d->x) && FULL(d->y) && FULL(d->z);
    assigns \nothing;
    ensures all_along(c, XYZ(*d), \result);
    ensures -EXTENT <= \result <= EXTENT; */
static int64_t farthest(const gjk_collider *c, const gjk_vec3 *d);

// No vertex of the collider lies before vertex o along d; or behind it.
/*@ predicate none_before_one(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w) = dot3(dx, dy, dz, u, v, w) <= dot3(dx, dy, dz, x, y, z);
    predicate none_behind_one(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w) = dot3(dx, dy, dz, x, y, z) <= dot3(dx, dy, dz, u, v, w);
    predicate none_before3(gjk_collider *c, integer dx, integer dy, integer dz, integer o) =
      \forall integer i; 0 <= i < corners(c) ==>
      none_before_one(dx, dy, dz, px(c, o), py(c, o), pz(c, o), px(c, i), py(c, i), pz(c, i));
    predicate none_behind3(gjk_collider *c, integer dx, integer dy, integer dz, integer o) =
      \forall integer i; 0 <= i < corners(c) ==>
      none_behind_one(dx, dy, dz, px(c, o), py(c, o), pz(c, o), px(c, i), py(c, i), pz(c, i));
    predicate dot_apart(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w) =
      dot3(dx, dy, dz, u - x, v - y, w - z) == dot3(dx, dy, dz, u, v, w) - dot3(dx, dy, dz, x, y, z);
    lemma dot_apart: \forall integer dx, dy, dz, x, y, z, u, v, w; dot_apart(dx, dy, dz, x, y, z, u, v, w);
    lemma turned_one: \forall integer dx, dy, dz, ex, ey, ez, x, y, z, u, v, w; ex == -dx && ey == -dy && ez == -dz &&
      none_before_one(ex, ey, ez, x, y, z, u, v, w) ==> none_behind_one(dx, dy, dz, x, y, z, u, v, w);
    lemma turned: \forall gjk_collider *c, integer dx, dy, dz, ex, ey, ez, o; ex == -dx && ey == -dy && ez == -dz &&
      none_before3(c, ex, ey, ez, o) ==> none_behind3(c, dx, dy, dz, o); */

/*@ requires SOLID(c) && origin < corners(c) && \valid_read(direction) && LEADS(direction);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> none_before3(c, WAY(direction, direction->opposite), origin); */
static bool none_before(const gjk_collider *c, const gjk_direction *direction, uint16_t origin);

/*@ requires \valid_read(it) && SOLID(it->a) && SOLID(it->b) && NEAR(it->a, it->b);
    requires \valid_read(direction) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> all_beyond3(it->a, it->b, APART(it->a, it->b), XYZ(*direction), radius); */
static bool is_separating(const gjk_iteration *it, const gjk_vec3 *direction, int64_t radius);

// Vertices of A - B in the frame, of f units an LSB, where A's centre less B's is (x, y, z).
/*@ logic integer seat(integer x, integer f, integer p, integer q) = x + f * (p - q);
    predicate named3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer i, integer j,
        integer wx, integer wy, integer wz) = 0 <= i < corners(a) && 0 <= j < corners(b) &&
      wx == seat(x, f, px(a, i), px(b, j)) && wy == seat(y, f, py(a, i), py(b, j)) && wz == seat(z, f, pz(a, i), pz(b, j));
    predicate reach3(integer x, integer y, integer z, integer wx, integer wy, integer wz) =
      in_ball(wx, wy, wz, REACH) && in_ball(wx - x, wy - y, wz - z, 0x3fffffff);
    predicate point_within(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer r) =
      \exists integer i, j, tx, ty, tz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) && in_ball(tx, ty, tz, r);
    predicate edge_within(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer r) =
      \exists integer i, j, k, l, tx, ty, tz, ux, uy, uz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) &&
        named3(a, b, x, y, z, f, k, l, ux, uy, uz) && near_edge3(tx, ty, tz, ux, uy, uz, r);
    predicate face_within(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer r) =
      \exists integer i, j, k, l, m, n, tx, ty, tz, ux, uy, uz, vx, vy, vz;
        named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
        named3(a, b, x, y, z, f, m, n, vx, vy, vz) && near_face3(tx, ty, tz, ux, uy, uz, vx, vy, vz, r);
    predicate edge_holds(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f) =
      \exists integer i, j, k, l, tx, ty, tz, ux, uy, uz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) &&
        named3(a, b, x, y, z, f, k, l, ux, uy, uz) && on_edge3(tx, ty, tz, ux, uy, uz);
    predicate face_holds(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f) =
      \exists integer i, j, k, l, m, n, tx, ty, tz, ux, uy, uz, vx, vy, vz;
        named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
        named3(a, b, x, y, z, f, m, n, vx, vy, vz) && on_face3(tx, ty, tz, ux, uy, uz, vx, vy, vz);
    predicate cell_holds(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f) =
      \exists integer i, j, k, l, m, n, o, p, tx, ty, tz, ux, uy, uz, vx, vy, vz, wx, wy, wz;
        named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
        named3(a, b, x, y, z, f, m, n, vx, vy, vz) && named3(a, b, x, y, z, f, o, p, wx, wy, wz) &&
        in_tetrahedron(tx, ty, tz, ux, uy, uz, vx, vy, vz, wx, wy, wz);
    predicate enclosing3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f) =
      point_within(a, b, x, y, z, f, 0) || edge_holds(a, b, x, y, z, f) || face_holds(a, b, x, y, z, f) ||
      cell_holds(a, b, x, y, z, f);
    predicate near3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer r) =
      point_within(a, b, x, y, z, f, r) || edge_within(a, b, x, y, z, f, r) || face_within(a, b, x, y, z, f, r); */

#define KEPT_RADIUS(it, r) radius_kept((it)->radius, r, scale((it)->shift), XYZ((it)->delta), CORES((it)->a, (it)->b))

/*@ predicate radius_framed(integer radius, integer r, integer f) = 0 <= radius <= f * r;
    predicate reached3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer r) =
      enclosing3(a, b, x, y, z, f) || near3(a, b, x, y, z, f, r);
    predicate together3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer r) =
      \exists integer f, s; 1 <= f && radius_framed(s, r, f) && reached3(a, b, f * x, f * y, f * z, f, s); */

/*@ lemma edge_near: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, k, l, tx, ty, tz, ux, uy, uz, r;
      named3(a, b, x, y, z, f, i, j, tx, ty, tz) && named3(a, b, x, y, z, f, k, l, ux, uy, uz) &&
      near_edge3(tx, ty, tz, ux, uy, uz, r) ==> near3(a, b, x, y, z, f, r);
    lemma face_near: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, k, l, m, n,
        tx, ty, tz, ux, uy, uz, vx, vy, vz, r; named3(a, b, x, y, z, f, i, j, tx, ty, tz) &&
      named3(a, b, x, y, z, f, k, l, ux, uy, uz) && named3(a, b, x, y, z, f, m, n, vx, vy, vz) &&
      near_face3(tx, ty, tz, ux, uy, uz, vx, vy, vz, r) ==> near3(a, b, x, y, z, f, r);
    lemma cell: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, k, l, m, n, o, p,
        tx, ty, tz, ux, uy, uz, vx, vy, vz, wx, wy, wz; named3(a, b, x, y, z, f, i, j, tx, ty, tz) &&
      named3(a, b, x, y, z, f, k, l, ux, uy, uz) && named3(a, b, x, y, z, f, m, n, vx, vy, vz) &&
      named3(a, b, x, y, z, f, o, p, wx, wy, wz) && in_tetrahedron(tx, ty, tz, ux, uy, uz, vx, vy, vz, wx, wy, wz) ==>
      cell_holds(a, b, x, y, z, f);
    lemma cell_encloses: \forall gjk_collider *a, *b, integer x, y, z, f;
      cell_holds(a, b, x, y, z, f) ==> enclosing3(a, b, x, y, z, f);
    lemma reached_by_enclosing: \forall gjk_collider *a, *b, integer x, y, z, f, r;
      enclosing3(a, b, x, y, z, f) ==> reached3(a, b, x, y, z, f, r);
    lemma together: \forall gjk_collider *a, *b, integer x, y, z, r, f, s, dx, dy, dz; 1 <= f && radius_framed(s, r, f) &&
      dx == f * x && dy == f * y && dz == f * z && reached3(a, b, dx, dy, dz, f, s) ==> together3(a, b, x, y, z, r);
    lemma reached_by_near: \forall gjk_collider *a, *b, integer x, y, z, f, r;
      near3(a, b, x, y, z, f, r) ==> reached3(a, b, x, y, z, f, r); */

#define FRAMED(it) framed(APART((it)->a, (it)->b), CORES((it)->a, (it)->b), scale((it)->shift), XYZ((it)->delta))
#define SLOT(s, k) XYZ((s)->slot[k].w)
#define AT(it, L)                                                                                        \
  \at((it)->a, L), \at((it)->b, L), \at((it)->delta.x, L), \at((it)->delta.y, L), \at((it)->delta.z, L), \
      scale(\at((it)->shift, L))
#define NAMED3(it, c, k, L)                                                            \
  (named3(AT(it, L), \at((c)->a[k], L), \at((c)->b[k], L), SLOT(&(it)->simplex, k)) && \
   reach3(\at((it)->delta.x, L), \at((it)->delta.y, L), \at((it)->delta.z, L), SLOT(&(it)->simplex, k)))
#define CORED(c) (SOLID(c) && 1 <= (c)->core_radius <= 0xfff0004 && cored(c, (c)->core_radius))
#define FRAME(it) \
  (\valid(it) && CORED((it)->a) && CORED((it)->b) && \separated(it, (it)->a) && \separated(it, (it)->b) &&           \
   \separated(it, (it)->a->shape) && \separated(it, (it)->b->shape) && \separated(it, (it)->a->shape->type) &&       \
   \separated(it, (it)->b->shape->type) && 0 <= (it)->shift <= 29 && 0 <= (it)->radius && FRAMED(it))

// The simplex.
#define KEPT(s, k)                                                                             \
  ((s)->slot[k].w.x == \old((s)->slot[k].w.x) && (s)->slot[k].w.y == \old((s)->slot[k].w.y) && \
   (s)->slot[k].w.z == \old((s)->slot[k].w.z))
#define IN_ORDER(s) ((s)->order[0] == 0 && (s)->order[1] == 1 && (s)->order[2] == 2 && (s)->order[3] == 3)
#define SPOT(s, k) in_ball(SLOT(s, k), REACH)
/*@ lemma span3: \forall integer x, y, z, px, py, pz, qx, qy, qz;
      reach3(x, y, z, px, py, pz) && reach3(x, y, z, qx, qy, qz) ==> span3(px, py, pz, qx, qy, qz); */
#define SPAN(s, i, j) span3(SLOT(s, i), SLOT(s, j))
#define TOWARD(s, i, j) ((s)->toward[i][j] == toward3(SLOT(s, i), SLOT(s, j)))
#define SQUARE(s, i) ((s)->toward[i][i] == norm3(SLOT(s, i)))
#define OF3(word, s, i, j, k) word(SLOT(s, i), SLOT(s, j), SLOT(s, k))
#define AREA_X(s, i, j, k) \
  area3((s)->slot[i].w.y, (s)->slot[i].w.z, (s)->slot[j].w.y, (s)->slot[j].w.z, (s)->slot[k].w.y, (s)->slot[k].w.z)
#define AREA_Y(s, i, j, k) \
  area3((s)->slot[i].w.z, (s)->slot[i].w.x, (s)->slot[j].w.z, (s)->slot[j].w.x, (s)->slot[k].w.z, (s)->slot[k].w.x)
#define AREA_Z(s, i, j, k) \
  area3((s)->slot[i].w.x, (s)->slot[i].w.y, (s)->slot[j].w.x, (s)->slot[j].w.y, (s)->slot[k].w.x, (s)->slot[k].w.y)
#define NORMAL(s, i, j, k) \
  ((s)->normal.x == AREA_X(s, i, j, k) && (s)->normal.y == AREA_Y(s, i, j, k) && (s)->normal.z == AREA_Z(s, i, j, k))
#define FACE(s)                                                        \
  (((s)->order[0] == 0 && (s)->order[1] == 1 && NORMAL(s, 0, 1, 2) ||  \
    (s)->order[0] == 1 && (s)->order[1] == 0 && NORMAL(s, 1, 0, 2)) && \
   (s)->order[2] == 2)

/*@ requires \valid(s);
    assigns s->count, s->order[0 .. 3];
    ensures s->count == 0 && IN_ORDER(s); */
void gjk_simplex_clear(gjk_simplex *s);

#define ROUNDS(s, i, j, k) (SPOT(s, i) && SPOT(s, j) && SPOT(s, k) && SPAN(s, i, j) && SPAN(s, i, k) && SPAN(s, j, k))
#define CORNERS(i, j, k) ((i) <= 2 && (j) <= 2 && (k) <= 2 && (i) != (j) && (j) != (k) && (i) != (k))

/*@ requires \valid(s) && n <= 3 && CORNERS(i, j, k);
    assigns s->count, s->order[0 .. 3];
    ensures s->count == n && s->order[0] == i && s->order[1] == j && s->order[2] == k && s->order[3] == 3; */
static void set_feature(gjk_simplex *s, unsigned n, unsigned i, unsigned j, unsigned k);

/*@ requires \valid_read(s) && CORNERS(i, j, k) && SPOT(s, i) && SPOT(s, j) && SPAN(s, i, j) && SPAN(s, i, k) && SPAN(s, j, k);
    requires TOWARD(s, i, j) && TOWARD(s, j, i) && TOWARD(s, i, k) && TOWARD(s, j, k);
    assigns \nothing;
    ensures \result == SIGN(OF3(share3, s, i, j, k)); */
static int beyond_edge(const gjk_simplex *s, unsigned i, unsigned j, unsigned k);

/*@ requires \valid_read(s) && CORNERS(i, j, k) && SPOT(s, i) && SPOT(s, j) && SPAN(s, i, j) && SPAN(s, i, k) && SPAN(s, j, k);
    requires TOWARD(s, i, j) && TOWARD(s, j, i) && TOWARD(s, i, k) && TOWARD(s, j, k);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> OF3(share3, s, i, j, k) <= 0; */
static bool is_within_edge(const gjk_simplex *s, unsigned i, unsigned j, unsigned k);

/*@ requires \valid(s) && w <= 3 && slot <= 3 && w != slot && SPOT(s, slot) && SPAN(s, w, slot) && SPOT(s, w);
    requires \valid_read(v) && \separated(s, v) && v->x == s->slot[w].w.x && v->y == s->slot[w].w.y && v->z == s->slot[w].w.z;
    requires square == norm3(SLOT(s, w)) && SQUARE(s, slot);
    assigns s->toward[w][slot], s->toward[slot][w];
    ensures TOWARD(s, w, slot) && TOWARD(s, slot, w); */
static void set_product(gjk_simplex *s, unsigned w, int64_t square, const gjk_vec3 *v, unsigned slot);

/*@ requires \valid(s) && w <= 2 && w == n && IN_ORDER(s) && SPOT(s, w);
    requires w > 0 ==> SPOT(s, 0) && SPAN(s, w, 0) && SQUARE(s, 0);
    requires w > 1 ==> SPOT(s, 1) && SPAN(s, w, 1) && SQUARE(s, 1);
    assigns s->toward[w][0 .. w], s->toward[0 .. w][w];
    ensures SQUARE(s, w);
    ensures w > 0 ==> TOWARD(s, w, 0) && TOWARD(s, 0, w);
    ensures w > 1 ==> TOWARD(s, w, 1) && TOWARD(s, 1, w); */
static void set_products(gjk_simplex *s, unsigned w, unsigned n);

/*@ requires \valid(s) && w <= 2 && w == s->count && IN_ORDER(s) && SPOT(s, w);
    requires w > 0 ==> SPOT(s, 0) && SPAN(s, w, 0) && SQUARE(s, 0);
    requires w > 1 ==> SPOT(s, 1) && SPAN(s, w, 1) && SQUARE(s, 1);
    assigns s->toward[w][0 .. w], s->toward[0 .. w][w];
    ensures SQUARE(s, w);
    ensures w > 0 ==> TOWARD(s, w, 0) && TOWARD(s, 0, w);
    ensures w > 1 ==> TOWARD(s, w, 1) && TOWARD(s, 1, w); */
static void set_all_products(gjk_simplex *s, unsigned w);

/*@ requires \valid(s) && x <= 2 && y <= 2 && w <= 2 && SPAN(s, x, y) && SPAN(s, x, w);
    assigns s->normal;
    ensures NORMAL(s, x, y, w); */
static void set_triangle_normal(gjk_simplex *s, unsigned x, unsigned y, unsigned w);

/*@ requires \valid(s) && x == 0 && y == 1 && w == 2 && ROUNDS(s, 0, 1, 2);
    assigns s->normal, s->order[0 .. 3], s->count;
    ensures s->count == 3 && FACE(s) && SMALL_LONG(&s->normal) && dot3(XYZ(s->normal), SLOT(s, 0)) <= 0; */
static gjk_step set_triangle(gjk_simplex *s, unsigned x, unsigned y, unsigned w);

/*@ requires \valid(s) && 1 <= n <= 3 && SPOT(s, 0);
    requires n > 1 ==> SPOT(s, 1) && SPAN(s, 0, 1);
    requires n > 2 ==> SPOT(s, 2) && SPAN(s, 0, 2) && SPAN(s, 1, 2);
    assigns s->toward[0 .. 3][0 .. 3], s->normal, s->order[0 .. 3], s->count;
    ensures \result == 0 || \result == 1;
    ensures s->count == n;
    ensures n < 3 ==> IN_ORDER(s);
    ensures n < 3 ==> SQUARE(s, 0);
    ensures n == 2 ==> SQUARE(s, 1) && TOWARD(s, 0, 1) && TOWARD(s, 1, 0);
    ensures n == 2 ==> (\result == 1 <==> foot3(SLOT(s, 0), SLOT(s, 1)));
    ensures n == 3 ==> FACE(s) && SMALL_LONG(&s->normal) && (\result == 1 <==> OF3(inside3, s, 0, 1, 2));
    ensures n == 3 ==> dot3(XYZ(s->normal), SLOT(s, 0)) <= 0; */
bool gjk_simplex_set(gjk_simplex *s, unsigned n);

// A feature that holds the origin's foot.
#define EDGED(s) (SPOT(s, 1) && SPAN(s, 0, 1) && SQUARE(s, 1) && TOWARD(s, 0, 1) && TOWARD(s, 1, 0))
#define FORMED(s)                                                                              \
  (1 <= (s)->count <= 3 && SPOT(s, 0) && ((s)->count == 3 || (IN_ORDER(s) && SQUARE(s, 0))) && \
   ((s)->count != 2 || (EDGED(s) && foot3(SLOT(s, 0), SLOT(s, 1)))) &&                         \
   ((s)->count != 3 || (SPOT(s, 1) && SPOT(s, 2) && SPAN(s, 0, 1) && SPAN(s, 0, 2) && SPAN(s, 1, 2) && FACE(s))))
#define READY(s) (FORMED(s) && ((s)->count != 3 || OF3(inside3, s, 0, 1, 2)))

/*@ requires \valid_read(s) && READY(s);
    requires \valid(out) && \separated(s, out);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 && s->count == 1 ==> in_ball(SLOT(s, 0), 0);
    ensures \result == 0 && s->count == 2 ==> on_edge3(SLOT(s, 0), SLOT(s, 1));
    ensures vertex: \result == 1 && s->count == 1 ==> norm3(SLOT(s, 0)) > 0;
    ensures edge: \result == 1 && s->count == 2 ==> !on_edge3(SLOT(s, 0), SLOT(s, 1)); */
bool gjk_simplex_direction(const gjk_simplex *s, gjk_search_direction *out);

/*@ requires \valid_read(s) && i <= 3 && j <= 3 && k <= 3 && SPOT(s, i) && SPOT(s, j) && SPOT(s, k);
    assigns \nothing;
    ensures \result == SIGN(OF3(volume3, s, i, j, k)); */
static int volume_sign(const gjk_simplex *s, unsigned i, unsigned j, unsigned k);

#define ENCLOSES(s, n)                                                                   \
  ((n != 1 || in_ball(SLOT(s, 0), 0)) && (n != 2 || on_edge3(SLOT(s, 0), SLOT(s, 1))) && \
   (n != 3 || OF3(on_face3, s, 0, 1, 2)) &&                                              \
   (n != 4 || in_tetrahedron(SLOT(s, 0), SLOT(s, 1), SLOT(s, 2), SLOT(s, 3))))

/*@ requires \valid(s) && 1 <= n <= 4 && SPOT(s, 0);
    requires n > 1 ==> SPOT(s, 1) && SPAN(s, 0, 1);
    requires n > 2 ==> SPOT(s, 2) && SPAN(s, 0, 2) && SPAN(s, 1, 2);
    requires n > 3 ==> SPOT(s, 3);
    assigns s->toward[0 .. 3][0 .. 3], s->normal, s->order[0 .. 3], s->count;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> ENCLOSES(s, n); */
bool gjk_simplex_encloses(gjk_simplex *s, unsigned n);

#define ROUND(it, c) (\valid_read(c) && \separated(it, c) && 1 <= (c)->core_radius <= 0xfff0004)

/*@ predicate times_less(integer k, integer a, integer b) = k * a <= k * b;
    lemma times_less: \forall integer k, a, b; 0 <= k && a <= b ==> times_less(k, a, b);
    predicate room3(integer x, integer y, integer z, integer c) = in_ball(x, y, z, REACH - c);
    lemma room3: \forall integer x, y, z, u, v, w, c;
      0 <= c <= REACH && room3(x, y, z, c) && in_ball(u, v, w, c) ==> in_ball(x + u, y + v, z + w, REACH);
    lemma ball_grown: \forall integer x, y, z, r, s; 0 <= r <= s && in_ball(x, y, z, r) ==> in_ball(x, y, z, s); */
#define MOVED(d, x, f) (-0x40000000 < (f) * (x) < 0x40000000 && -REACH <= (d) + (f) * (x) <= REACH)

/*@ requires \valid_read(it) && \valid(w) && 0 <= it->shift <= 29 && \separated(w, &it->delta) && \separated(w, &it->shift);
    requires MOVED(it->delta.x, offset.x, scale(it->shift)) && MOVED(it->delta.y, offset.y, scale(it->shift)) &&
      MOVED(it->delta.z, offset.z, scale(it->shift));
    assigns *w;
    ensures w->x == it->delta.x + scale(it->shift) * offset.x && w->y == it->delta.y + scale(it->shift) * offset.y &&
      w->z == it->delta.z + scale(it->shift) * offset.z; */
static inline void gjk_frame_move(const gjk_iteration *it, gjk_vec3 offset, gjk_vec3 *w);

// A's vertex less B's, and that in the frame's units.
#define BETWEEN(v, b) (v)->a.offset.x - (b)->offset.x, (v)->a.offset.y - (b)->offset.y, (v)->a.offset.z - (b)->offset.z
#define SCALED(it, v, b)                                                                                          \
  scale((it)->shift) * ((v)->a.offset.x - (b)->offset.x), scale((it)->shift) * ((v)->a.offset.y - (b)->offset.y), \
      scale((it)->shift) * ((v)->a.offset.z - (b)->offset.z)

/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= it->shift <= 29 && FRAMED(it);
    requires 0 <= it->simplex.count <= 3 && v == &it->simplex.slot[it->simplex.count];
    requires \valid_read(b) && \separated(b, it);
    requires in_ball(XYZ(v->a.offset), it->a->core_radius) && in_ball(XYZ(b->offset), it->b->core_radius);
    assigns v->b, v->w;
    ensures v->w.x == seat(it->delta.x, scale(it->shift), v->a.offset.x, b->offset.x) &&
      v->w.y == seat(it->delta.y, scale(it->shift), v->a.offset.y, b->offset.y) &&
      v->w.z == seat(it->delta.z, scale(it->shift), v->a.offset.z, b->offset.z);
    ensures near: in_ball(v->w.x - it->delta.x, v->w.y - it->delta.y, v->w.z - it->delta.z, 0x3fffffff);
    ensures reach: in_ball(XYZ(v->w), REACH); */
static void complete_vertex(const gjk_iteration *it, gjk_vertex *v, const gjk_support *b);

/*@ requires \valid(s) && s->count <= 3 && IN_ORDER(s);
    assigns \nothing;
    ensures \result == &s->slot[s->count]; */
static inline gjk_vertex *gjk_simplex_free(gjk_simplex *s);

/*@ requires \valid(it) && 0 <= it->simplex.count <= 3 && IN_ORDER(&it->simplex) && FRAME(it);
    assigns it->simplex.slot[it->simplex.count];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> named3(AT(it, Old), a, b, SLOT(&it->simplex, \old(it->simplex.count)));
    ensures \result == 1 ==> reach3(\old(it->delta.x), \old(it->delta.y), \old(it->delta.z),
      SLOT(&it->simplex, \old(it->simplex.count)));
    ensures it->simplex.count != 0 ==> KEPT(&it->simplex, 0);
    ensures it->simplex.count != 1 ==> KEPT(&it->simplex, 1);
    ensures it->simplex.count != 2 ==> KEPT(&it->simplex, 2); */
bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b);

#define NEARS(s, n, r)                                                                        \
  ((n != 1 || in_ball(SLOT(s, 0), r)) && (n != 2 || near_edge3(SLOT(s, 0), SLOT(s, 1), r)) && \
   (n != 3 || near_face3(SLOT(s, 0), SLOT(s, 1), SLOT(s, 2), r)))

// A feature's exact direction, and whether it points from the feature to the origin.
#define FEATURE_X(s) \
  way(0, (s)->count, (s)->slot[0].w.x, (s)->toward[1][0], (s)->slot[1].w.x, (s)->toward[0][1], (s)->normal.x)
#define FEATURE_Y(s) \
  way(0, (s)->count, (s)->slot[0].w.y, (s)->toward[1][0], (s)->slot[1].w.y, (s)->toward[0][1], (s)->normal.y)
#define FEATURE_Z(s) \
  way(0, (s)->count, (s)->slot[0].w.z, (s)->toward[1][0], (s)->slot[1].w.z, (s)->toward[0][1], (s)->normal.z)
#define FEATURE(s) FEATURE_X(s), FEATURE_Y(s), FEATURE_Z(s)
#define FRONT(s) ((s)->count != 3 || dot3(XYZ((s)->normal), SLOT(s, 0)) <= 0)

/*@ predicate far_point3(integer x, integer y, integer z, integer r) =
      norm3(x, y, z) > r * r ==> beyond3(-x, -y, -z, x, y, z, r);
    logic integer edge_way(integer x, integer u, integer s, integer t) = -(x * t + u * s);
    predicate edge_shares(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t) =
      s == norm3(x, y, z) - dot3(x, y, z, u, v, w) && t == norm3(u, v, w) - dot3(x, y, z, u, v, w);
    predicate norm_of_edge(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t) =
      norm3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t)) ==
      norm3(x, y, z) * t * t + 2 * dot3(x, y, z, u, v, w) * s * t + norm3(u, v, w) * s * s;
    predicate dot_of_edge(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t) =
      dot3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t), x, y, z) ==
      -(norm3(x, y, z) * t + dot3(x, y, z, u, v, w) * s);
    predicate gram_is(integer x, integer y, integer z, integer u, integer v, integer w, integer n) =
      n == norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w);
    predicate face_across(integer x, integer y, integer z, integer u, integer v, integer w,
        integer s, integer t, integer q) =
      dot3(area3(v, w, y, z, t, q), area3(w, u, z, x, q, s), area3(u, v, x, y, s, t), x, y, z) ==
      -volume3(x, y, z, u, v, w, s, t, q);
    lemma face_across: \forall integer x, y, z, u, v, w, s, t, q; face_across(x, y, z, u, v, w, s, t, q);
    predicate gram_of_edge(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer n) =
      dot3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t), x, y, z) == -n &&
      norm3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t)) == n * (s + t);
    predicate far_edge3(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t,
        integer n, integer r) = n > r * r * (s + t) ==>
      beyond3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t), x, y, z, r);
    predicate far_gram(integer n, integer d, integer r) = n > r * r * d ==> 0 < n && (- -n) * (- -n) > r * r * (n * d);
    predicate far_height(integer g, integer h, integer r, integer d) =
      (g == h || g == -h) && g <= 0 && h * h > r * r * d ==> g < 0 && (-g) * (-g) > r * r * d;
    predicate far_face3(integer dx, integer dy, integer dz, integer x, integer y, integer z, integer h, integer r) =
      (dot3(dx, dy, dz, x, y, z) == h || dot3(dx, dy, dz, x, y, z) == -h) && dot3(dx, dy, dz, x, y, z) <= 0 &&
      h * h > r * r * norm3(dx, dy, dz) ==> beyond3(dx, dy, dz, x, y, z, r);
    lemma far_point3: \forall integer x, y, z, r; far_point3(x, y, z, r);
    lemma norm_of_edge: \forall integer x, y, z, u, v, w, s, t; norm_of_edge(x, y, z, u, v, w, s, t);
    lemma dot_of_edge: \forall integer x, y, z, u, v, w, s, t; dot_of_edge(x, y, z, u, v, w, s, t);
    lemma gram_of_edge: \forall integer x, y, z, u, v, w, s, t, n; edge_shares(x, y, z, u, v, w, s, t) &&
      norm_of_edge(x, y, z, u, v, w, s, t) && dot_of_edge(x, y, z, u, v, w, s, t) && gram_is(x, y, z, u, v, w, n) ==>
      gram_of_edge(x, y, z, u, v, w, s, t, n);
    lemma far_gram: \forall integer n, d, r; 0 <= d ==> far_gram(n, d, r);
    lemma far_edge3: \forall integer x, y, z, u, v, w, s, t, n, r;
      gram_of_edge(x, y, z, u, v, w, s, t, n) && far_gram(n, s + t, r) ==> far_edge3(x, y, z, u, v, w, s, t, n, r);
    lemma far_height: \forall integer g, h, r, d; 0 <= d ==> far_height(g, h, r, d);
    lemma far_face3: \forall integer dx, dy, dz, x, y, z, h, r;
      far_height(dot3(dx, dy, dz, x, y, z), h, r, norm3(dx, dy, dz)) ==> far_face3(dx, dy, dz, x, y, z, h, r); */

/*@ requires \valid_read(it) && 0 <= it->radius && READY(&it->simplex);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> NEARS(&it->simplex, it->simplex.count, it->radius);
    ensures far: \result == 0 && FRONT(&it->simplex) ==>
      beyond3(FEATURE(&it->simplex), SLOT(&it->simplex, 0), it->radius); */
bool gjk_iteration_near(const gjk_iteration *it);

#define CLAIM(it, c) (\valid_read(c) && \separated(it, c))

/*@ requires FRAME(it) && CLAIM(it, certificate) && certificate->count <= 4;
    assigns it->simplex;
    ensures \result == 0 || \result == 1;
    ensures it->radius == \old(it->radius);
    ensures \result == 1 && certificate->count > 0 ==> NAMED3(it, certificate, 0, Old);
    ensures \result == 1 && certificate->count > 1 ==> NAMED3(it, certificate, 1, Old) && SPAN(&it->simplex, 0, 1);
    ensures \result == 1 && certificate->count > 2 ==> NAMED3(it, certificate, 2, Old) && SPAN(&it->simplex, 0, 2) &&
      SPAN(&it->simplex, 1, 2);
    ensures \result == 1 && certificate->count > 3 ==> NAMED3(it, certificate, 3, Old); */
static bool load(gjk_iteration *it, const gjk_certificate *certificate);

/*@ requires FRAME(it) && CLAIM(it, certificate);
    assigns it->simplex;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enclosing3(AT(it, Old)); */
static bool is_enclosing(gjk_iteration *it, const gjk_certificate *certificate);

/*@ requires FRAME(it) && CLAIM(it, certificate);
    assigns it->simplex;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> near3(AT(it, Old), \old(it->radius)); */
static bool proves_near(gjk_iteration *it, const gjk_certificate *certificate);

/*@ requires FRAME(it) && CLAIM(it, certificate);
    assigns it->simplex;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> reached3(AT(it, Old), \old(it->radius)); */
static bool is_together(gjk_iteration *it, const gjk_certificate *certificate);

// Shapes that are apart by the nearest feature.
/*@ requires \valid_read(s) && READY(s) && \valid(out) && \separated(s, out);
    assigns *out;
    ensures out->spanning == s->count && out->opposite == 0 && out->n == &s->normal;
    ensures out->a == &s->slot[s->order[0]].w && out->b == &s->slot[s->order[1]].w;
    ensures s->count == 2 ==> out->ta == s->toward[0][1] && out->tb == s->toward[1][0]; */
void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out);

/*@ requires \valid_read(it) && SOLID(it->a) && SOLID(it->b) && CLAIM(it, certificate);
    requires \valid(direction) && LEADS(direction) && \separated(direction, it) && \separated(direction, certificate);
    requires \separated(direction, direction->a) && \separated(direction, direction->b) && \separated(direction, direction->n);
    requires certificate->a[0] < corners(it->a) && certificate->b[0] < corners(it->b);
    assigns direction->opposite;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> none_before3(it->a, WAY(direction, 0), certificate->a[0]);
    ensures \result == 1 ==> none_behind3(it->b, WAY(direction, 0), certificate->b[0]); */
static bool is_support(const gjk_iteration *it, const gjk_certificate *certificate, gjk_direction *direction);

#define APART_AT(it, L) \
  \at(APART_X((it)->a, (it)->b), L), \at(APART_Y((it)->a, (it)->b), L), \at(APART_Z((it)->a, (it)->b), L)

// No vertex of A - B, in units of which f are an LSB, lies before w along d; and w is at most f c from (x, y, z).
/*@ predicate support_one3(integer x, integer y, integer z, integer f, integer dx, integer dy, integer dz,
        integer wx, integer wy, integer wz, integer u, integer v, integer w, integer s, integer t, integer q) =
      f * (dot3(dx, dy, dz, x, y, z) + dot3(dx, dy, dz, u, v, w) - dot3(dx, dy, dz, s, t, q)) <= dot3(dx, dy, dz, wx, wy, wz);
    predicate support3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f,
        integer dx, integer dy, integer dz, integer wx, integer wy, integer wz) =
      \forall integer i, j; 0 <= i < corners(a) && 0 <= j < corners(b) ==>
      support_one3(x, y, z, f, dx, dy, dz, wx, wy, wz, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j));
    predicate placed3(integer x, integer y, integer z, integer wx, integer wy, integer wz, integer f, integer c) =
      in_ball(wx - x, wy - y, wz - z, f * c); */

/*@ predicate times_is(integer k, integer f, integer x) = k == f * x;
    predicate sum_is(integer c, integer a, integer b) = c == a + b;
    predicate base_one3(integer x, integer y, integer z, integer f, integer dx, integer dy, integer dz,
        integer wx, integer wy, integer wz, integer u, integer v, integer w, integer s, integer t, integer q) =
      f * (dot3(dx, dy, dz, x, y, z) + dot3(dx, dy, dz, u, v, w) - dot3(dx, dy, dz, s, t, q)) == dot3(dx, dy, dz, wx, wy, wz);
    predicate base_of(integer x, integer y, integer z, integer f, integer dx, integer dy, integer dz,
        integer u, integer v, integer w, integer s, integer t, integer q) = base_one3(x, y, z, f, dx, dy, dz,
      seat(f * x, f, u, s), seat(f * y, f, v, t), seat(f * z, f, w, q), u, v, w, s, t, q);
    lemma base_of: \forall integer x, y, z, f, dx, dy, dz, u, v, w, s, t, q; base_of(x, y, z, f, dx, dy, dz, u, v, w, s, t, q);
    lemma base_joined: \forall integer x, y, z, kx, ky, kz, f, dx, dy, dz, u, v, w, s, t, q;
      base_of(x, y, z, f, dx, dy, dz, u, v, w, s, t, q) && times_is(kx, f, x) && times_is(ky, f, y) && times_is(kz, f, z) ==>
      base_one3(x, y, z, f, dx, dy, dz, seat(kx, f, u, s), seat(ky, f, v, t), seat(kz, f, w, q), u, v, w, s, t, q);
    lemma base_one3: \forall integer x, y, z, kx, ky, kz, f, dx, dy, dz, u, v, w, s, t, q;
      times_is(kx, f, x) && times_is(ky, f, y) && times_is(kz, f, z) ==>
      base_one3(x, y, z, f, dx, dy, dz, seat(kx, f, u, s), seat(ky, f, v, t), seat(kz, f, w, q), u, v, w, s, t, q);
    lemma support_one3: \forall integer x, y, z, f, dx, dy, dz, wx, wy, wz, u, v, w, s, t, q, ku, kv, kw, ks, kt, kq;
      0 <= f && base_one3(x, y, z, f, dx, dy, dz, wx, wy, wz, u, v, w, s, t, q) &&
      none_before_one(dx, dy, dz, u, v, w, ku, kv, kw) && none_behind_one(dx, dy, dz, s, t, q, ks, kt, kq) ==>
      support_one3(x, y, z, f, dx, dy, dz, wx, wy, wz, ku, kv, kw, ks, kt, kq);
    predicate base3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer f, integer dx, integer dy,
        integer dz, integer wx, integer wy, integer wz, integer i, integer j) =
      base_one3(x, y, z, f, dx, dy, dz, wx, wy, wz, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j));
    lemma base3: \forall gjk_collider *a, *b, integer x, y, z, kx, ky, kz, f, i, j, dx, dy, dz, wx, wy, wz;
      times_is(kx, f, x) && times_is(ky, f, y) && times_is(kz, f, z) && named3(a, b, kx, ky, kz, f, i, j, wx, wy, wz) ==>
      base3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz, i, j);
    lemma support3: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, dx, dy, dz, wx, wy, wz;
      0 <= f && base3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz, i, j) &&
      none_before3(a, dx, dy, dz, i) && none_behind3(b, dx, dy, dz, j) ==> support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz); */

/*@ predicate apart_in(integer u, integer v, integer w, integer s, integer t, integer q, integer ra, integer rb) =
      norm3(u - s, v - t, w - q) <= (ra + rb) * (ra + rb);
    predicate norm_apart(integer u, integer v, integer w, integer s, integer t, integer q) =
      norm3(u - s, v - t, w - q) == norm3(u, v, w) + norm3(s, t, q) - 2 * dot3(u, v, w, s, t, q);
    lemma norm_apart: \forall integer u, v, w, s, t, q; norm_apart(u, v, w, s, t, q);
    lemma apart_joined: \forall integer u, v, w, s, t, q, ra, rb; norm_apart(u, v, w, s, t, q) &&
      at_most(-dot3(u, v, w, s, t, q), ra, rb) && in_ball(u, v, w, ra) && in_ball(s, t, q, rb) ==>
      apart_in(u, v, w, s, t, q, ra, rb);
    lemma apart_in: \forall integer u, v, w, s, t, q, ra, rb; 0 <= ra && 0 <= rb &&
      in_ball(u, v, w, ra) && in_ball(s, t, q, rb) ==> apart_in(u, v, w, s, t, q, ra, rb);
    lemma placed_apart: \forall integer x, y, z, f, u, v, w, s, t, q, ra, rb, c;
      0 <= f && apart_in(u, v, w, s, t, q, ra, rb) && sum_is(c, ra, rb) ==>
      placed3(x, y, z, seat(x, f, u, s), seat(y, f, v, t), seat(z, f, w, q), f, c);
    lemma placed3: \forall gjk_collider *a, *b, integer x, y, z, f, i, j, wx, wy, wz, ra, rb, c;
      0 <= f && named3(a, b, x, y, z, f, i, j, wx, wy, wz) && sum_is(c, ra, rb) &&
      apart_in(px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j), ra, rb) ==> placed3(x, y, z, wx, wy, wz, f, c); */

// The simplex is the feature that the certificate names, and no vertex of A - B lies before its plane.
#define SPANNED(it, c)                                                                                        \
  ((it)->simplex.count == (c)->count && NAMED3(it, c, 0, Old) && ((c)->count < 2 || NAMED3(it, c, 1, Old)) && \
   ((c)->count < 3 || NAMED3(it, c, 2, Old)))
#define SUPPORTED(it)                                                                              \
  support3((it)->a, (it)->b, APART_AT(it, Old), scale(\old((it)->shift)), FEATURE(&(it)->simplex), \
           SLOT(&(it)->simplex, 0))

// The square of the feature's distance from the origin, as a quotient.
/*@ logic integer top_of(integer count, integer x, integer y, integer z, integer u, integer v, integer w,
        integer s, integer t, integer q) = count == 1 ? norm3(x, y, z) :
      count == 2 ? norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w) :
      volume3(x, y, z, u, v, w, s, t, q) * volume3(x, y, z, u, v, w, s, t, q);
    logic integer bottom_of(integer count, integer x, integer y, integer z, integer u, integer v, integer w,
        integer s, integer t, integer q) = count == 1 ? 1 :
      count == 2 ? toward3(x, y, z, u, v, w) + toward3(u, v, w, x, y, z) :
      norm3(area3(y, z, v, w, t, q), area3(z, x, w, u, q, s), area3(x, y, u, v, s, t)); */
/*@ predicate top_of_two(integer count, integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t,
        integer q) = top_of(count, x, y, z, u, v, w, s, t, q) ==
      norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w);
    lemma top_of_two: \forall integer count, x, y, z, u, v, w, s, t, q;
      count == 2 ==> top_of_two(count, x, y, z, u, v, w, s, t, q); */
#define TOP_OF(s) top_of((s)->count, SLOT(s, 0), SLOT(s, 1), SLOT(s, 2))
#define BOTTOM_OF(s) bottom_of((s)->count, SLOT(s, 0), SLOT(s, 1), SLOT(s, 2))

/*@ predicate point_across(integer dx, integer dy, integer dz, integer x, integer y, integer z) =
      dx == -x && dy == -y && dz == -z ==> across3(dx, dy, dz, x, y, z, norm3(x, y, z), 1);
    lemma point_across: \forall integer dx, dy, dz, x, y, z; point_across(dx, dy, dz, x, y, z);
    predicate times_across(integer a, integer n, integer m, integer l) = a == -n && l == n * m ==> a * a * m == n * l;
    lemma times_across: \forall integer a, n, m, l; times_across(a, n, m, l);
    lemma edge_across: \forall integer x, y, z, u, v, w, s, t, n; gram_of_edge(x, y, z, u, v, w, s, t, n) &&
      times_across(dot3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t), x, y, z), n, s + t,
        norm3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t))) ==>
      across3(edge_way(x, u, s, t), edge_way(y, v, s, t), edge_way(z, w, s, t), x, y, z, n, s + t);
    lemma face_across_height: \forall integer dx, dy, dz, x, y, z, n;
      n == dot3(dx, dy, dz, x, y, z) * dot3(dx, dy, dz, x, y, z) ==> across3(dx, dy, dz, x, y, z, n, norm3(dx, dy, dz));
    lemma meets_way: \forall integer x, u, s, t; edge_way(x, u, s, t) == 0 ==> meets_one(x, u, s, t); */

// n / m is a square distance in the frame's reach; it is at most, or at least, the square of t.
/*@ predicate in_reach3(integer n, integer m) = 0 <= n <= REACH * REACH * m && 0 <= m;
    predicate square_at_most(integer n, integer m, integer t) = n <= t * t * m;
    predicate square_at_least(integer n, integer m, integer t) = t * t * m <= n;
    predicate gram_under(integer x, integer y, integer z, integer u, integer v, integer w) =
      norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w) <=
      norm3(x, y, z) * (toward3(x, y, z, u, v, w) + toward3(u, v, w, x, y, z));
    predicate gram_scalar(integer a, integer b, integer c) = a * b - c * c <= a * (a - c + (b - c));
    predicate dot_turned(integer x, integer y, integer z, integer u, integer v, integer w) =
      dot3(u, v, w, x, y, z) == dot3(x, y, z, u, v, w);
    lemma gram_scalar: \forall integer a, b, c; gram_scalar(a, b, c);
    lemma dot_turned: \forall integer x, y, z, u, v, w; dot_turned(x, y, z, u, v, w);
    lemma gram_under: \forall integer x, y, z, u, v, w; gram_scalar(norm3(x, y, z), norm3(u, v, w), dot3(x, y, z, u, v, w)) &&
      dot_turned(x, y, z, u, v, w) ==> gram_under(x, y, z, u, v, w);
    lemma reach_point: \forall integer x, y, z; in_ball(x, y, z, REACH) ==> in_reach3(norm3(x, y, z), 1);
    predicate top_under(integer n, integer m, integer l) = 0 <= n <= l * m && 0 <= m;
    lemma under_top: \forall integer t, n, m, l; under(t, m, l) && n == t * t && 0 <= m ==> top_under(n, m, l);
    lemma reach_under: \forall integer n, m, l; top_under(n, m, l) && l <= REACH * REACH ==> in_reach3(n, m);
    lemma top_edge: \forall integer x, y, z, u, v, w, s, t, q, n;
      gram_is(x, y, z, u, v, w, n) ==> top_of(2, x, y, z, u, v, w, s, t, q) == n;
    lemma norm_positive: \forall integer x, y, z; (x != 0 || y != 0 || z != 0) ==> 0 < norm3(x, y, z); */

#define ACROSS(s) across3(FEATURE(s), SLOT(s, 0), TOP_OF(s), BOTTOM_OF(s))

/*@ requires FRAME(it) && CLAIM(it, certificate);
    assigns it->simplex;
    ensures \result == 0 || \result == 1;
    ensures it->radius == \old(it->radius);
    ensures \result == 1 ==> READY(&it->simplex);
    ensures \result == 1 ==> SUPPORTED(it);
    ensures names: \result == 1 ==> SPANNED(it, certificate);
    ensures way: \result == 1 ==> 0 < norm3(FEATURE(&it->simplex)) && dot3(FEATURE(&it->simplex), SLOT(&it->simplex, 0)) <= 0;
    ensures across: \result == 1 ==> ACROSS(&it->simplex);
    ensures reach: \result == 1 ==> in_reach3(TOP_OF(&it->simplex), BOTTOM_OF(&it->simplex)) && 0 < BOTTOM_OF(&it->simplex);
    ensures \result == 1 ==> placed3(\old(it->delta.x), \old(it->delta.y), \old(it->delta.z), SLOT(&it->simplex, 0),
      scale(\old(it->shift)), \old(CORES(it->a, it->b)));
    ensures \result == 1 && it->simplex.count == 3 ==> dot3(XYZ(it->simplex.normal), SLOT(&it->simplex, 0)) < 0; */
static bool is_nearest(gjk_iteration *it, const gjk_certificate *certificate);

/*@ predicate separated_by3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer r) =
      \exists integer dx, dy, dz; all_beyond3(a, b, x, y, z, dx, dy, dz, r);
    predicate beyond_scaled(integer dx, integer dy, integer dz, integer x, integer y, integer z, integer f, integer r) =
      beyond3(dx, dy, dz, x, y, z, f * r);
    lemma placed_ball: \forall integer x, y, z, wx, wy, wz, f, c, s; 0 <= f * c <= s && placed3(x, y, z, wx, wy, wz, f, c) &&
      in_ball(x, y, z, s - f * c) ==> in_ball(wx, wy, wz, s);
    lemma not_beyond_under: \forall integer dx, dy, dz, x, y, z, s; 0 <= norm3(dx, dy, dz) && in_ball(x, y, z, s) &&
      under(dot3(dx, dy, dz, x, y, z), norm3(dx, dy, dz), norm3(x, y, z)) ==> !beyond3(dx, dy, dz, x, y, z, s);
    lemma not_beyond: \forall integer dx, dy, dz, x, y, z, s;
      in_ball(x, y, z, s) ==> !beyond3(dx, dy, dz, x, y, z, s);
    lemma beyond_kept: \forall integer dx, dy, dz, x, y, z, wx, wy, wz, s, r, f, c; 0 <= f * c &&
      beyond3(dx, dy, dz, wx, wy, wz, s) && placed3(x, y, z, wx, wy, wz, f, c) && radius_kept(s, r, f, x, y, z, c) ==>
      beyond_scaled(dx, dy, dz, wx, wy, wz, f, r);
    predicate clear_one3(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w, integer s, integer t, integer q, integer r) =
      clear3(dx, dy, dz, dot3(dx, dy, dz, x, y, z) + dot3(dx, dy, dz, u, v, w) - dot3(dx, dy, dz, s, t, q), r);
    lemma unscaled: \forall integer f, g, dx, dy, dz, wx, wy, wz, r; 1 <= f && f * g <= dot3(dx, dy, dz, wx, wy, wz) &&
      beyond_scaled(dx, dy, dz, wx, wy, wz, f, r) ==> clear3(dx, dy, dz, g, r);
    lemma unscaled_one3: \forall integer x, y, z, f, dx, dy, dz, wx, wy, wz, u, v, w, s, t, q, r; 1 <= f &&
      support_one3(x, y, z, f, dx, dy, dz, wx, wy, wz, u, v, w, s, t, q) && beyond_scaled(dx, dy, dz, wx, wy, wz, f, r) ==>
      clear_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, r);
    lemma clear_one3: \forall integer dx, dy, dz, x, y, z, u, v, w, s, t, q, r;
      clear_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, r) ==> beyond_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, r);
    lemma unscaled3: \forall gjk_collider *a, *b, integer x, y, z, f, dx, dy, dz, wx, wy, wz, r; 1 <= f &&
      support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) && beyond_scaled(dx, dy, dz, wx, wy, wz, f, r) ==>
      all_beyond3(a, b, x, y, z, dx, dy, dz, r);
    lemma nearest_apart: \forall gjk_collider *a, *b, integer x, y, z, c, f, kx, ky, kz, dx, dy, dz, wx, wy, wz, s, r;
      framed(x, y, z, c, f, kx, ky, kz) && support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) &&
      placed3(kx, ky, kz, wx, wy, wz, f, c) && radius_kept(s, r, f, kx, ky, kz, c) &&
      beyond3(dx, dy, dz, wx, wy, wz, s) ==> all_beyond3(a, b, x, y, z, dx, dy, dz, r); */

/*@ requires FRAME(it) && CLAIM(it, certificate) && NEAR(it->a, it->b) && 0 <= radius && KEPT_RADIUS(it, radius);
    assigns it->simplex;
    ensures \result == 1 ==> separated_by3(it->a, it->b, APART_AT(it, Old), radius);
    ensures ready: \result == 1 && certificate->proof == GJK_PROOF_NEAREST ==> READY(&it->simplex);
    ensures names: \result == 1 && certificate->proof == GJK_PROOF_NEAREST ==> SPANNED(it, certificate);
    ensures plane: \result == 1 && certificate->proof == GJK_PROOF_NEAREST ==> SUPPORTED(it);
    ensures across: \result == 1 && certificate->proof == GJK_PROOF_NEAREST ==> ACROSS(&it->simplex);
    ensures beyond: \result == 1 && certificate->proof == GJK_PROOF_NEAREST ==>
      beyond_scaled(FEATURE(&it->simplex), SLOT(&it->simplex, 0), scale(\old(it->shift)), radius); */
static bool is_apart(gjk_iteration *it, const gjk_certificate *certificate, int64_t radius);

// The frame.
#define WITHIN(v, n, r) \
  (-(r) <= down((v)->x, n) <= (r) && -(r) <= down((v)->y, n) <= (r) && -(r) <= down((v)->z, n) <= (r))

/*@ requires \valid_read(v) && n <= 3 && 0 <= r < 0x200000000;
    requires -0x100000000 <= v->x <= 0x100000000 && -0x100000000 <= v->y <= 0x100000000 && -0x100000000 <= v->z <= 0x100000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures n == 0 && \result == 1 ==> spheres_apart(XYZ(*v), r);
    ensures n == 0 && \result == 0 && r < 0x80000000 ==> in_ball(XYZ(*v), r);
    ensures \result == 0 ==> WITHIN(v, n, r); */
static bool longer_than(const gjk_long3 *v, unsigned n, int64_t r);

/*@ requires \valid_read(delta);
    requires -0x100000000 <= delta->x <= 0x100000000 && -0x100000000 <= delta->y <= 0x100000000 &&
      -0x100000000 <= delta->z <= 0x100000000;
    assigns \nothing;
    ensures -3 <= \result <= 0;
    ensures \result == 0 ==> in_ball(XYZ(*delta), 0x40000000);
    ensures near: in_ball(XYZ(*delta), 0x40000000) ==> \result == 0;
    ensures WITHIN(delta, -\result, 0x40000000); */
static int far_shift(const gjk_long3 *delta);

/*@ requires -3 <= shift <= 0 && -0x200000000 <= difference <= 0x200000000;
    requires -REACH <= down(difference, -shift) && down(difference, -shift) + (shift == 0 ? 0 : 1) <= REACH;
    assigns \nothing;
    ensures shift == 0 ==> \result == difference; */
static int32_t far_component(int64_t difference, int shift);

/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= radius <= 0xffffffff;
    assigns it->shift, it->delta, it->radius;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> spheres != 0 && SPHERES(it->a, it->b, radius);
    ensures \result == 1 && it->shift >= 0 ==> NEAR(it->a, it->b) && it->shift <= 29 && FRAMED(it);
    ensures near: \result == 1 && spheres != 0 && CORES(it->a, it->b) + radius <= 0x40000000 ==> it->shift >= 0;
    ensures \result == 1 && it->shift >= 0 ==> radius_framed(it->radius, radius, scale(it->shift));
    ensures \result == 1 && it->shift >= 0 ==> KEPT_RADIUS(it, radius); */
bool gjk_frame_set_far(gjk_iteration *it, bool spheres, int64_t radius);

/*@ lemma short_ball: \forall integer x, y, z, r; size3(x, y, z) <= r ==> in_ball(x, y, z, r); */

/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= radius <= 0xffffffff;
    requires \valid_read(delta) && \separated(it, delta) && close3(XYZ(*delta));
    assigns it->shift, it->delta, it->radius;
    ensures 0 <= it->shift <= 29 && framed(XYZ(*delta), CORES(it->a, it->b), scale(it->shift), XYZ(it->delta));
    ensures radius_framed(it->radius, radius, scale(it->shift));
    ensures KEPT_RADIUS(it, radius); */
static inline void gjk_frame_fill(gjk_iteration *it, const gjk_vec3 *delta, int64_t radius);

/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= radius <= 0xffffffff;
    assigns it->shift, it->delta, it->radius;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> spheres != 0 && SPHERES(it->a, it->b, radius);
    ensures \result == 1 && it->shift >= 0 ==> NEAR(it->a, it->b) && it->shift <= 29 && FRAMED(it);
    ensures near: \result == 1 && spheres != 0 && CORES(it->a, it->b) + radius <= 0x40000000 ==> it->shift >= 0;
    ensures \result == 1 && it->shift >= 0 ==> radius_framed(it->radius, radius, scale(it->shift));
    ensures \result == 1 && it->shift >= 0 ==> KEPT_RADIUS(it, radius); */
static inline bool gjk_frame_set(gjk_iteration *it, bool spheres, int64_t radius);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures goal == GJK_GOAL_DISTANCE ==> \result == 0;
    ensures goal == GJK_GOAL_DEPTH || goal == GJK_GOAL_WITHIN ==> \result == 1; */
static inline bool gjk_goal_separates(gjk_goal goal);

/*@ requires \valid_read(it);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 <==> it->stalls == \null; */
static inline bool gjk_pair_is_curved(const gjk_iteration *it);

/*@ requires \valid_read(a) && \valid_read(b);
    assigns \nothing;
    ensures \result == GJK_OK || \result == GJK_ERROR_NULL || \result == GJK_ERROR_UNINITIALISED; */
static inline gjk_status gjk_check_pair(const gjk_collider *a, const gjk_collider *b, const void *out);

#define BESIDE(it, c) (\separated(it, c) && \separated(it, (c)->shape) && \separated(it, (c)->shape->type))

/*@ requires \valid(it) && solid(a) && solid(b) && BESIDE(it, a) && BESIDE(it, b) && 0 <= radius <= 0xffffffff;
    assigns *it;
    ensures \result == 0 || \result == 1;
    ensures spheres: \result == 0 ==> goal != GJK_GOAL_DISTANCE && SPHERES(a, b, radius);
    ensures \result == 1 ==> it->a == a && it->b == b;
    ensures \result == 1 && it->shift >= 0 ==> NEAR(a, b) && it->shift <= 29 && FRAMED(it);
    ensures near: \result == 1 && (goal == GJK_GOAL_DEPTH || goal == GJK_GOAL_WITHIN) && CORES(a, b) + radius <= 0x40000000 ==> it->shift >= 0;
    ensures \result == 1 && it->shift >= 0 ==> radius_framed(it->radius, radius, scale(it->shift));
    ensures \result == 1 && it->shift >= 0 ==> KEPT_RADIUS(it, radius);
    ensures \result == 1 && it->stalls == \null ==> a->shape->type->stalls == \null && b->shape->type->stalls == \null; */
bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius);

// What a checked decision means for the vertices; solid.v goes on from there.
/*@ requires solid(a) && solid(b) && \valid_read(decision);
    assigns \nothing;
    ensures no: \result == GJK_OK && decision->yes == 0 ==>
      SPHERES(a, b, RADII(a, b) + distance) || separated_by3(a, b, APART(a, b), RADII(a, b) + distance);
    ensures yes: \result == GJK_OK && decision->yes != 0 ==> together3(a, b, APART(a, b), RADII(a, b) + distance);
    ensures \result == GJK_OK ==> 0 <= distance; */
gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision);

// Lemmas about these parts, behind all others.
/*@ lemma half_parts: \forall integer x; half_parts(x);
    lemma small_high: \forall integer x; SMALL62(x) ==> small_high(x);
    lemma sized: \forall integer l, x, m; -m <= l <= m ==> sized(l, x, m);
    lemma square_short: \forall integer t; square_short(t) ==> t < 0x100000000;
    lemma sum_square: \forall integer a, b, c; (a + b + c) * (a + b + c) <= 3 * (a * a + b * b + c * c);
    lemma sum_short: \forall integer a, b, c; in_ball(a, b, c, 0x60000000) ==> square_short(a + b + c);
    lemma sum_small: \forall integer a, b, c; in_ball(a, b, c, 0x60000000) ==> sum_small(a, b, c);
    lemma size_square: \forall integer x; square(size(x)) == square(x);
    lemma norm_squares: \forall integer x, y, z; norm3(x, y, z) == square(x) + square(y) + square(z);
    lemma size_norm: \forall integer x, y, z; norm3(size(x), size(y), size(z)) == norm3(x, y, z);
    lemma size_ball: \forall integer x, y, z; in_ball(x, y, z, 0x60000000) ==> in_ball(size(x), size(y), size(z), 0x60000000);
    lemma short3: \forall integer x, y, z; in_ball(x, y, z, 0x60000000) ==> short3(x, y, z);
    lemma low_below: \forall integer a, b, c, x, y, z; sized3(a, b, c, x, y, z, 0x100000000) && short3(x, y, z) ==>
      dot_below(a, b, c, x, y, z, 0x10000000000000000);
    lemma half_below: \forall integer a, b, c, x, y, z; sized3(a, b, c, x, y, z, 0x80000000) && short3(x, y, z) ==>
      dot_below(a, b, c, x, y, z, 0x8000000000000000);
    lemma high_below: \forall integer a, b, c, x, y, z; sized3(a, b, c, x, y, z, 0x40000000) && short3(x, y, z) ==>
      dot_below(a, b, c, x, y, z, 0x4000000000000000);
    lemma dot_split: \forall integer a, b, c, p, q, r, x, y, z; dot_split(a, b, c, p, q, r, x, y, z); */

/*@ assigns \nothing;
    ensures \result == low_part(x); */
static inline int32_t gjk_low_balanced(int64_t x);

/*@ requires SMALL62(x);
    assigns \nothing;
    ensures \result == high_part(x); */
static inline int32_t gjk_high_balanced(int64_t x);

#endif
