// Contracts of the plane's decision checker: what each function means for the vertices of two colliders.
#ifndef PROVE_CHECKER_PLANE_H
#define PROVE_CHECKER_PLANE_H

#include "geometry.h"
#include "gjk2/check.h"
#include "src/plane/gjk2_claim.h"
#include "src/plane/gjk2_search.h"
#include "wide.h"

// Vertex i of a collider, relative to its centre. What follows holds for any vertices that obey `posed`.
/*@ axiomatic vertices {
      logic integer vx(gjk2_collider *c, integer i) reads \nothing;
      logic integer vy(gjk2_collider *c, integer i) reads \nothing;
    } */

// Stands for the class's vertex function.
/*@ requires \valid(offset) && \valid_read(c) && \separated(offset, c);
    assigns *offset;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> number < c->count;
    ensures \result == 1 ==> offset->x == vx(c, number) && offset->y == vy(c, number); */
bool plane_vertex(const gjk2_collider *c, uint16_t number, gjk2_vec *offset);

// What gjk2_collider_init and gjk2_collider_pose leave in a collider, as far as the checker needs it. Taken as given.
/*@ predicate polygonal(gjk2_collider *c) =
      c->shape->type->vertex == &plane_vertex && c->count >= 1 &&
      (\forall integer i; 0 <= i < c->count ==> in_disc(vx(c, i), vy(c, i), 0x10000000));
    predicate posed(gjk2_collider *c) =
      \valid_read(c) && \valid_read(c->shape) && \valid_read(c->shape->type) &&
      0 <= c->core_radius && 0 <= c->shape->convex_radius && c->core_radius + c->shape->convex_radius <= 0x10000000 &&
      (c->ordered != 0 ==> c->shape->type->vertex != \null) &&
      (c->shape->type->vertex != \null ==> polygonal(c)); */

// w is the vertex (i, j) of A - B, of centres (x, y) apart. A point is in reach if it is at most 3 2^29 from the origin.
#define REACH 0x60000000
/*@ predicate place(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer i, integer j, integer wx, integer wy) =
      wx == x + vx(a, i) - vx(b, j) && wy == y + vy(a, i) - vy(b, j);
    predicate in_reach(integer x, integer y, integer wx, integer wy) = in_disc(wx, wy, REACH) &&
      -0x20000000 <= wx - x <= 0x20000000 && -0x20000000 <= wy - y <= 0x20000000; */

// Vectors.
/*@ requires -0x80000000 <= a.x + b.x <= 0x7fffffff && -0x80000000 <= a.y + b.y <= 0x7fffffff;
    assigns \nothing;
    ensures \result.x == a.x + b.x && \result.y == a.y + b.y; */
static inline gjk2_vec gjk2_add(gjk2_vec a, gjk2_vec b);

/*@ requires -0x80000000 < a.x - b.x <= 0x7fffffff && -0x80000000 < a.y - b.y <= 0x7fffffff;
    assigns \nothing;
    ensures \result.x == a.x - b.x && \result.y == a.y - b.y; */
static inline gjk2_vec gjk2_sub(gjk2_vec a, gjk2_vec b);

/*@ requires a.x > -0x80000000 && a.y > -0x80000000;
    assigns \nothing;
    ensures \result.x == -a.x && \result.y == -a.y; */
static inline gjk2_vec gjk2_negate(gjk2_vec a);

#define FITS64(x) (-0x8000000000000000 <= (x) <= 0x7fffffffffffffff)

/*@ requires dot_fits(a.x, a.y, b.x, b.y);
    assigns \nothing;
    ensures \result == dot(a.x, a.y, b.x, b.y); */
static inline int64_t gjk2_dot(gjk2_vec a, gjk2_vec b);

/*@ requires cross_fits(a.x, a.y, b.x, b.y) && a.y > -0x80000000;
    assigns \nothing;
    ensures \result == cross(a.x, a.y, b.x, b.y); */
static inline int64_t gjk2_cross(gjk2_vec a, gjk2_vec b);

/*@ requires v.x > -0x80000000 && v.y > -0x80000000;
    assigns \nothing;
    ensures \result == 0 <==> v.x == 0 && v.y == 0; */
static inline uint32_t gjk2_norm1(gjk2_vec v);

/*@ requires edge.x > -0x80000000;
    assigns \nothing;
    ensures \result.x == edge.y && \result.y == -edge.x; */
static inline gjk2_vec gjk2_outward(gjk2_vec edge);

/*@ requires \valid(to) && \valid_read(from) && \separated(to, from);
    assigns *to;
    ensures to->x == from->x && to->y == from->y; */
static inline void gjk2_copy(gjk2_vec *to, const gjk2_vec *from);

/*@ requires \valid(to) && \valid_read(from) && \separated(to, from);
    assigns *to; */
static inline void gjk2_copy_support(gjk2_support *to, const gjk2_support *from);

/*@ requires \valid(to) && \valid_read(from) && \separated(to, from);
    assigns *to;
    ensures to->w.x == from->w.x && to->w.y == from->w.y; */
static inline void gjk2_copy_vertex(gjk2_vertex *to, const gjk2_vertex *from);

// Lengths.
/*@ requires -0x80000000 < n.x && -0x80000000 < n.y;
    assigns \nothing;
    ensures longer(\result, dot(n.x, n.y, n.x, n.y)); */
static inline uint32_t gjk2_length_bound(gjk2_vec n);

/*@ requires h < 0x4000000000000000 && x < 0x4000000000000000 && squared < 0x4000000000000000;
    requires rest < 0x8000000000000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> reaches(h, squared, x, rest); */
bool gjk2_reaches(uint64_t h, uint64_t squared, uint64_t x, uint64_t rest);

/*@ requires 0 <= h < 0x4000000000000000 && 0 <= radius && -0x80000000 < n.x && -0x80000000 < n.y;
    requires dot(n.x, n.y, n.x, n.y) < 0x4000000000000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 <==> farther(h, radius, dot(n.x, n.y, n.x, n.y)); */
bool gjk2_is_within(int64_t h, gjk2_vec n, int32_t radius);

// A search in a near frame.
#define RADII(a, b) ((a)->shape->convex_radius + (b)->shape->convex_radius)
#define COLLIDER(c) (\valid_read(c) && \valid_read((c)->shape) && \valid_read((c)->shape->type) && polygonal(c))
#define BESIDE(s, c) (\separated(s, c) && \separated(s, (c)->shape) && \separated(s, (c)->shape->type))
#define BOTH(s) (COLLIDER(s->a) && COLLIDER(s->b))
#define NEAR(s) (s->far == 0 && in_disc(s->delta.x, s->delta.y, 0x40000000))
#define PAIR(s) (\valid(s) && BOTH(s) && BESIDE(s, s->a) && BESIDE(s, s->b) && NEAR(s))
#define FRAME(s) s->a, s->b, s->delta.x, s->delta.y

/*@ requires in_disc(delta.x, delta.y, 0x40000000);
    requires in_disc(of_a.x, of_a.y, 0x10000000) && in_disc(of_b.x, of_b.y, 0x10000000);
    assigns \nothing;
    ensures \result.x == delta.x + of_a.x - of_b.x && \result.y == delta.y + of_a.y - of_b.y;
    ensures in_reach(delta.x, delta.y, \result.x, \result.y); */
static gjk2_vec plane_difference(gjk2_vec delta, gjk2_vec of_a, gjk2_vec of_b);

/*@ requires \valid_read(s) && BOTH(s) && NEAR(s) && \valid(out) && \separated(out, s);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> a < s->a->count && b < s->b->count;
    ensures \result == 1 ==> place(FRAME(s), a, b, out->x, out->y);
    ensures \result == 1 ==> in_reach(s->delta.x, s->delta.y, out->x, out->y); */
static bool plane_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vec *out);

// The checker.
#define DIRECTION(d) (-REACH <= (d).x <= REACH && -REACH <= (d).y <= REACH)
#define EXTENT 0xC00000000000000

/*@ requires COLLIDER(c) && DIRECTION(d);
    assigns \nothing;
    ensures \forall integer i; 0 <= i < c->count ==> dot(vx(c, i), vy(c, i), d.x, d.y) <= \result;
    ensures -EXTENT <= \result <= EXTENT; */
int64_t gjk2_claim_farthest(const gjk2_collider *c, gjk2_vec d);

// What holds of each vertex of A - B; na and nb are the numbers of vertices.
/*@ predicate behind(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb,
        integer dx, integer dy, integer h) = \forall integer i, j; 0 <= i < na && 0 <= j < nb ==>
      behind_one(dx, dy, x, y, vx(a, i), vy(a, i), vx(b, j), vy(b, j), h);
    predicate all_beyond(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb,
        integer dx, integer dy, integer r) = \forall integer i, j; 0 <= i < na && 0 <= j < nb ==>
      beyond_one(dx, dy, x, y, vx(a, i), vy(a, i), vx(b, j), vy(b, j), r);
    predicate named(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb,
        integer i, integer j, integer wx, integer wy) = 0 <= i < na && 0 <= j < nb &&
      place(a, b, x, y, i, j, wx, wy) && in_reach(x, y, wx, wy); */
/*@ lemma all_beyond: \forall gjk2_collider *a, *b, integer x, y, na, nb, dx, dy, h, r;
      behind(a, b, x, y, na, nb, dx, dy, h) && clear(dx, dy, h, r) ==> all_beyond(a, b, x, y, na, nb, dx, dy, r); */
#define COUNTS(s) FRAME(s), s->a->count, s->b->count
#define NAMED(s, c, k, w) named(COUNTS(s), c->a[k], c->b[k], (w).x, (w).y)

/*@ requires \valid_read(s) && BOTH(s) && NEAR(s) && DIRECTION(d);
    assigns \nothing;
    ensures behind(COUNTS(s), d.x, d.y, \result);
    ensures -0x7000000000000000 <= \result <= 0x7000000000000000; */
static int64_t support(const gjk2_search *s, gjk2_vec d);

#define CERTIFICATE(s, c) (\valid_read(c) && \separated(s, c))
#define READS(s) (\valid_read(s) && BOTH(s) && NEAR(s))

/*@ requires READS(s) && \valid_read(certificate) && most <= 3;
    requires \valid(out + (0 .. most - 1)) && \separated(out + (0 .. most - 1), s);
    assigns out[0 .. most - 1];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> 1 <= certificate->count <= most;
    ensures \result == 1 ==> NAMED(s, certificate, 0, out[0]);
    ensures \result == 1 && certificate->count > 1 ==> NAMED(s, certificate, 1, out[1]);
    ensures \result == 1 && certificate->count > 2 ==> NAMED(s, certificate, 2, out[2]); */
static bool load_named(const gjk2_search *s, const gjk2_certificate *certificate, unsigned most, gjk2_vec *out);

// Two vertices of A - B, in reach and at most 2^30 apart per component.
#define SPOT(p) (\valid_read(p) && in_disc(p->x, p->y, REACH))
#define APART(p, q) (-0x40000000 <= q->x - p->x <= 0x40000000 && -0x40000000 <= q->y - p->y <= 0x40000000)

/*@ requires SPOT(p) && SPOT(q) && APART(p, q);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> foot(p->x, p->y, q->x, q->y); */
static bool has_foot(const gjk2_vec *p, const gjk2_vec *q);

#define LINE(s) line(s->d.x, s->d.y, s->base)

// d . w = h is the line of the feature of A - B that `count` names: the vertex (i, j), or the edge from there to (k, l).
/*@ predicate feature(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer count,
        integer i, integer j, integer k, integer l, integer dx, integer dy, integer h) =
      0 <= i < na && 0 <= j < nb &&
      (count == 1 ==> of_vertex(x + vx(a, i) - vx(b, j), y + vy(a, i) - vy(b, j), dx, dy, h)) &&
      (count != 1 ==> 0 <= k < na && 0 <= l < nb && of_edge(x + vx(a, i) - vx(b, j), y + vy(a, i) - vy(b, j),
        x + vx(a, k) - vx(b, l), y + vy(a, k) - vy(b, l), dx, dy, h)); */
#define NAMES(c) (c).count, (c).a[0], (c).b[0], (c).a[1], (c).b[1]
#define FEATURE(s, c) feature(COUNTS(s), NAMES(*c), s->d.x, s->d.y, s->base)

/*@ requires PAIR(s) && CERTIFICATE(s, certificate);
    assigns s->d.x, s->d.y, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> LINE(s);
    ensures \result == 1 ==> 1 <= certificate->count <= 2;
    ensures feature: \result == 1 ==> FEATURE(s, certificate); */
static bool plane_set_feature(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate);
    assigns s->d.x, s->d.y, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> LINE(s) && behind(COUNTS(s), s->d.x, s->d.y, s->base);
    ensures \result == 1 ==> 1 <= certificate->count <= 2;
    ensures feature: \result == 1 ==> FEATURE(s, certificate); */
static bool plane_is_nearest(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires SPOT(p) && SPOT(q);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> on_segment(p->x, p->y, q->x, q->y); */
static bool holds_origin(const gjk2_vec *p, const gjk2_vec *q);

/*@ requires SPOT(p) && SPOT(q) && SPOT(r);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> in_triangle(p->x, p->y, q->x, q->y, r->x, r->y); */
static bool triangle_holds_origin(const gjk2_vec *p, const gjk2_vec *q, const gjk2_vec *r);

// The named vertices, of which the last stands for those that are not named.
/*@ predicate enclosing(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb) =
      \exists integer i, j, k, l, m, n, px, py, qx, qy, rx, ry; named(a, b, x, y, na, nb, i, j, px, py) &&
        named(a, b, x, y, na, nb, k, l, qx, qy) && named(a, b, x, y, na, nb, m, n, rx, ry) &&
        in_triangle(px, py, qx, qy, rx, ry);
    predicate near_vertex(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r) =
      \exists integer i, j, px, py; named(a, b, x, y, na, nb, i, j, px, py) && near_point(px, py, r);
    predicate near_edge(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r) =
      \exists integer i, j, k, l, px, py, qx, qy; named(a, b, x, y, na, nb, i, j, px, py) &&
        named(a, b, x, y, na, nb, k, l, qx, qy) && foot(px, py, qx, qy) && near_line(px, py, qx, qy, r); */

/*@ requires READS(s) && \valid_read(certificate);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enclosing(COUNTS(s)); */
static bool plane_is_enclosing(const gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires SPOT(p) && SPOT(q) && APART(p, q) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> foot(p->x, p->y, q->x, q->y) && near_line(p->x, p->y, q->x, q->y, radius); */
static bool edge_is_near(const gjk2_vec *p, const gjk2_vec *q, int32_t radius);

/*@ requires SPOT(p) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> near_point(p->x, p->y, radius); */
static bool vertex_is_near(const gjk2_vec *p, int32_t radius);

/*@ requires READS(s) && \valid_read(certificate) && 0 <= s->radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> near_vertex(COUNTS(s), s->radius) || near_edge(COUNTS(s), s->radius); */
static bool plane_proves_near(const gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires -0x4000000000000000 < height && dot(d.x, d.y, d.x, d.y) < 0x4000000000000000 && 0 <= radius;
    requires -0x80000000 < d.x && -0x80000000 < d.y;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> clear(d.x, d.y, height, radius); */
static bool line_is_clear(gjk2_vec d, int64_t height, int32_t radius);

/*@ requires READS(s) && \valid_read(direction) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> all_beyond(COUNTS(s), direction->x, direction->y, radius); */
static bool direction_separates(const gjk2_search *s, const gjk2_vec *direction, int64_t radius);

/*@ predicate separated_by(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r) =
      \exists integer dx, dy; all_beyond(a, b, x, y, na, nb, dx, dy, r); */

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && 0 <= radius;
    requires s->radius == (radius < REACH ? radius : REACH);
    assigns s->d.x, s->d.y, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> separated_by(COUNTS(s), radius); */
static bool plane_is_apart(gjk2_search *s, const gjk2_certificate *certificate, int64_t radius);

/*@ requires READS(s) && \valid_read(certificate) && 0 <= s->radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enclosing(COUNTS(s)) || near_vertex(COUNTS(s), s->radius) || near_edge(COUNTS(s), s->radius); */
static bool plane_is_together(const gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires height < 0x4000000000000000 && squared < 0x4000000000000000 && distance < 0x80000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> rounded(height, squared, distance); */
static bool plane_rounds_to(uint64_t height, uint64_t squared, uint32_t distance);

// (u, v) of Q2.30 is a unit vector along d: 2^62 (sine)^2 + (its square - 2^60)^2 is at most 255/16 2^62.
/*@ predicate same_sign(integer d, integer u) = (d == 0 ==> u == 0) && (d > 0 ==> 0 <= u) && (d < 0 ==> u <= 0);
    predicate along_unit(integer dx, integer dy, integer u, integer v) = same_sign(dx, u) && same_sign(dy, v) &&
      0x4000000000000000 * (cross(u, v, dx, dy) * cross(u, v, dx, dy)) + (dot(u, v, u, v) - 0x1000000000000000) *
        (dot(u, v, u, v) - 0x1000000000000000) * dot(dx, dy, dx, dy) <= 0x3fc000000000000000 * dot(dx, dy, dx, dy); */

#define MOST_UNIT 0x40000004
#define UNIT(n) (n).x, (n).y
#define GAP(d) (d).point_b.x - (d).point_a.x, (d).point_b.y - (d).point_a.y

/*@ requires DIRECTION(n) && 0 < dot(n.x, n.y, n.x, n.y) && \valid_read(normal);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> -MOST_UNIT <= normal->x <= MOST_UNIT && -MOST_UNIT <= normal->y <= MOST_UNIT;
    ensures along: \result == 1 ==> along_unit(n.x, n.y, normal->x, normal->y); */
bool gjk2_claim_normal(gjk2_vec n, const gjk2_unit *normal);

// 8 h / |d| is at least e, where square is |d|^2; and the points are as far apart as the shapes, to 2 LSB: e is 8 times the
// distance of the cores, rounded down.
/*@ predicate eighths(integer h, integer square, integer e) = e * e * square <= 64 * (h * h);
    predicate eighths_apart(integer e, integer x, integer y) = 64 * (x * x + y * y) <= (e + 16) * (e + 16) &&
      (15 < e ==> (e - 15) * (e - 15) <= 64 * (x * x + y * y));
    predicate as_far(integer h, integer square, integer r, integer x, integer y) = \exists integer e;
      0 <= e && eighths(h, square, e) && !eighths(h, square, e + 1) && eighths_apart(e - 8 * r, x, y);
    predicate points_as_far(integer dx, integer dy, integer h, integer r, integer saturated, integer x, integer y) =
      saturated == 0 ==> as_far(-h, dot(dx, dy, dx, dy), r, x, y); */

// The distance of A and B, with r for both radii, is that of the line from the origin, rounded.
/*@ predicate line_measures(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r,
        integer distance, integer dx, integer dy, integer h) =
      behind(a, b, x, y, na, nb, dx, dy, h) && clear(dx, dy, h, r) && rounded(-h, dot(dx, dy, dx, dy), distance + r);
    predicate measured(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r,
        integer distance, integer count, integer i, integer j, integer k, integer l, integer u, integer v,
        integer saturated, integer gx, integer gy) = \exists integer dx, dy, h;
      feature(a, b, x, y, na, nb, count, i, j, k, l, dx, dy, h) &&
      line_measures(a, b, x, y, na, nb, r, distance, dx, dy, h) && along_unit(dx, dy, u, v) &&
      points_as_far(dx, dy, h, r, saturated, gx, gy);
    lemma measured: \forall gjk2_collider *a, *b, integer x, y, na, nb, r, distance, count, i, j, k, l, u, v, saturated, gx, gy, dx, dy, h;
      feature(a, b, x, y, na, nb, count, i, j, k, l, dx, dy, h) &&
      line_measures(a, b, x, y, na, nb, r, distance, dx, dy, h) && along_unit(dx, dy, u, v) &&
      points_as_far(dx, dy, h, r, saturated, gx, gy) ==>
      measured(a, b, x, y, na, nb, r, distance, count, i, j, k, l, u, v, saturated, gx, gy);
    lemma line_length: \forall integer dx, dy, h; line(dx, dy, h) ==> 0 < dot(dx, dy, dx, dy); */

/*@ requires \valid_read(s) && \valid_read(s->a) && \valid_read(s->b) && \valid_read(s->a->shape) && \valid_read(s->b->shape);
    requires -0x80000000 <= RADII(s->a, s->b) <= 0x7fffffff;
    assigns \nothing;
    ensures \result == RADII(s->a, s->b); */
static inline int32_t gjk2_convex_radii(const gjk2_search *s);

/*@ requires PAIR(s) && \valid_read(result) && \separated(s, result);
    requires 0 <= s->radius <= 0x20000000 && s->radius == RADII(s->a, s->b);
    assigns s->d.x, s->d.y, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> 0 <= result->distance && result->distance + s->radius <= 0x7fffffff;
    ensures meet: \result == 1 && result->intersecting != 0 ==> result->distance == 0 && (enclosing(COUNTS(s)) ||
      near_vertex(COUNTS(s), s->radius) || near_edge(COUNTS(s), s->radius));
    ensures \result == 1 && result->intersecting == 0 ==> 1 <= result->certificate.count <= 2;
    ensures apart: \result == 1 && result->intersecting == 0 ==> LINE(s) && FEATURE(s, (&result->certificate)) &&
      line_measures(COUNTS(s), s->radius, result->distance, s->d.x, s->d.y, s->base);
    ensures rounded: \result == 1 && result->intersecting == 0 ==>
      rounded(-s->base, dot(s->d.x, s->d.y, s->d.x, s->d.y), result->distance + s->radius); */
static bool plane_proves_distance(gjk2_search *s, const gjk2_distance_result *result);

// A point of the hull's boundary that two vertices name is within r of the point, or one of them is; (x, y) is the centre
// less the point.
/*@ predicate beside_vertex(gjk2_collider *c, integer x, integer y, integer n, integer r) =
      \exists integer i; 0 <= i < n && near_point(x + vx(c, i), y + vy(c, i), r);
    predicate beside_edge(gjk2_collider *c, integer x, integer y, integer n, integer r) =
      \exists integer i, k; 0 <= i < n && 0 <= k < n && foot(x + vx(c, i), y + vy(c, i), x + vx(c, k), y + vy(c, k)) &&
        near_line(x + vx(c, i), y + vy(c, i), x + vx(c, k), y + vy(c, k), r); */
#define BESIDE_SHAPE(c, p)                                                                                      \
  (beside_vertex(c, (c)->centre.x - (p).x, (c)->centre.y - (p).y, (c)->count, (c)->shape->convex_radius + 1) || \
   beside_edge(c, (c)->centre.x - (p).x, (c)->centre.y - (p).y, (c)->count, (c)->shape->convex_radius + 1))

/*@ requires COLLIDER(c) && 0 <= c->shape->convex_radius <= 0x10000000 && 1 <= count <= 2;
    requires \valid_read(named + (0 .. count - 1)) && \valid_read(point);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> BESIDE_SHAPE(c, *point); */
bool gjk2_claim_point(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point);

#define END(x) ((x) == 0x7fffffff || (x) == -0x80000000)
#define AT_END(p) (END((p).x) || END((p).y))

/*@ requires COLLIDER(c) && 0 <= c->shape->convex_radius <= 0x10000000 && 1 <= count <= 2;
    requires \valid_read(named + (0 .. count - 1)) && \valid_read(point);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> AT_END(*point); */
bool gjk2_claim_saturated(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point);

// The point is on the shape, to 1 LSB, or it is at an end of Q16.16 and may be saturated.
#define HELD(c, p, saturated) (BESIDE_SHAPE(c, p) || (saturated != 0 && AT_END(p)))
#define ROUNDED(c) (0 <= (c)->shape->convex_radius <= 0x10000000)

/*@ requires READS(s) && ROUNDED(s->a) && ROUNDED(s->b) && \valid_read(c) && 1 <= c->count <= 2;
    requires \valid_read(a) && \valid_read(b);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures of_a: \result == 1 ==> HELD(s->a, *a, saturated);
    ensures of_b: \result == 1 ==> HELD(s->b, *b, saturated);
    ensures end: \result == 1 && saturated != 0 ==> AT_END(*a) || AT_END(*b); */
static bool plane_points_hold(const gjk2_search *s, const gjk2_certificate *c, const gjk2_vec *a, const gjk2_vec *b,
                              bool saturated);

/*@ requires \valid_read(s) && LINE(s) && \valid_read(a) && \valid_read(b) && 0 <= distance;
    requires \valid_read(s->a) && \valid_read(s->b) && \valid_read(s->a->shape) && \valid_read(s->b->shape);
    requires 0 <= RADII(s->a, s->b) <= 0x20000000 && distance + RADII(s->a, s->b) <= 0x7fffffff;
    requires rounded(-s->base, dot(s->d.x, s->d.y, s->d.x, s->d.y), distance + RADII(s->a, s->b));
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> as_far(-s->base, dot(s->d.x, s->d.y, s->d.x, s->d.y), RADII(s->a, s->b), b->x - a->x, b->y - a->y); */
bool gjk2_claim_gap(const gjk2_search *s, gjk_q16 distance, const gjk2_vec *a, const gjk2_vec *b);

/*@ requires READS(s) && ROUNDED(s->a) && ROUNDED(s->b) && \valid_read(result);
    requires 0 <= s->radius <= 0x20000000 && s->radius == RADII(s->a, s->b);
    requires result->intersecting == 0 ==> LINE(s) && 1 <= result->certificate.count <= 2 && 0 <= result->distance;
    requires result->intersecting == 0 ==> result->distance + s->radius <= 0x7fffffff;
    requires result->intersecting == 0 ==> rounded(-s->base, dot(s->d.x, s->d.y, s->d.x, s->d.y), result->distance + s->radius);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures of_a: \result == 1 && result->intersecting == 0 ==> HELD(s->a, result->point_a, result->saturated);
    ensures of_b: \result == 1 && result->intersecting == 0 ==> HELD(s->b, result->point_b, result->saturated);
    ensures far: \result == 1 && result->intersecting == 0 ==>
      points_as_far(s->d.x, s->d.y, s->base, s->radius, result->saturated, GAP(*result));
    ensures \result == 1 && result->intersecting == 0 ==> along_unit(s->d.x, s->d.y, UNIT(result->normal)); */
static bool plane_proves_points(const gjk2_search *s, const gjk2_distance_result *result);

// The frame.
/*@ requires \valid_read(shape) && \valid_read(shape->type);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> shape->type->vertex != \null; */
static inline bool gjk2_is_curved(const gjk2_shape *shape);

/*@ requires \valid_read(a) && \valid_read(b);
    assigns \nothing;
    ensures \result == GJK_OK || \result == GJK_ERROR_NULL || \result == GJK_ERROR_UNINITIALISED; */
static inline gjk_status gjk2_check_pair(const gjk2_collider *a, const gjk2_collider *b, const void *out);

/*@ requires \valid(s);
    assigns s->d.x;
    ensures s->far == \old(s->far) && s->radius == \old(s->radius); */
static inline void gjk2_search_need_direction(gjk2_search *s);

/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> s->far == 0 && s->curved == 0; */
static inline bool gjk2_search_is_exact(const gjk2_search *s);

/*@ requires \valid_read(a) && \valid_read(b);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> close_centres(a->centre.x - b->centre.x, a->centre.y - b->centre.y); */
static inline bool gjk2_frame_is_near(const gjk2_collider *a, const gjk2_collider *b);

/*@ requires n <= 3;
    assigns \nothing;
    ensures n == 0 ==> \result == x;
    ensures n == 1 ==> 2 * \result <= x < 2 * \result + 2;
    ensures n == 2 ==> 4 * \result <= x < 4 * \result + 4;
    ensures n == 3 ==> 8 * \result <= x < 8 * \result + 8; */
static int64_t shift_far(int64_t x, unsigned n);

/*@ requires 0 <= x <= 0x100000000 && 0 <= y <= 0x100000000 && far <= 3;
    requires far == 0 ==> x <= 0x80000000 && y <= 0x80000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures far == 0 && \result == 0 ==> in_disc(x, y, 0x40000000);
    ensures far == 1 && \result == 0 ==> x <= 0x80000001 && y <= 0x80000001;
    ensures far == 3 ==> \result == 0; */
static bool is_long(int64_t x, int64_t y, unsigned far);

#define APART_X(a, b) (a->centre.x - b->centre.x)
#define APART_Y(a, b) (a->centre.y - b->centre.y)
#define CIRCLES(a, b, radius) circles_apart(APART_X(a, b), APART_Y(a, b), a->core_radius + b->core_radius + radius)
#define RADIUS(r) ((r) < REACH ? (r) : REACH)
#define ROUND(s, c) (\valid_read(c) && \separated(s, c) && 0 <= (c)->core_radius <= 0x10000000)
#define FRAMED(s, a, b, radius)                                                                                 \
  (s->delta.x == APART_X(a, b) && s->delta.y == APART_Y(a, b) && in_disc(s->delta.x, s->delta.y, 0x40000000) && \
   s->radius == RADIUS(radius))

/*@ requires \valid(s) && ROUND(s, s->a) && ROUND(s, s->b);
    requires close_centres(APART_X(s->a, s->b), APART_Y(s->a, s->b));
    assigns s->radius, s->delta.x, s->delta.y;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> circles != 0 && CIRCLES(s->a, s->b, radius);
    ensures \result == 1 ==> FRAMED(s, s->a, s->b, radius) && close_centres(s->delta.x, s->delta.y); */
static bool start_near(gjk2_search *s, bool circles, uint32_t radius);

/*@ requires \valid(s) && ROUND(s, s->a) && ROUND(s, s->b);
    assigns s->far, s->radius, s->delta.x, s->delta.y;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> circles != 0 && CIRCLES(s->a, s->b, radius);
    ensures \result == 1 && s->far == 0 ==> FRAMED(s, s->a, s->b, radius);
    ensures \result == 1 ==> -0x40000001 <= s->delta.x <= 0x40000000 && -0x40000001 <= s->delta.y <= 0x40000000; */
static bool start_far(gjk2_search *s, bool circles, uint32_t radius);

/*@ requires \valid(s) && posed(a) && posed(b) && BESIDE(s, a) && BESIDE(s, b);
    assigns *s;
    ensures \result == 0 || \result == 1;
    ensures circles: \result == 0 ==> circles != 0 && CIRCLES(a, b, radius);
    ensures \result == 1 ==> s->a == a && s->b == b;
    ensures framed: \result == 1 && s->far == 0 ==> FRAMED(s, a, b, radius);
    ensures \result == 1 && s->curved == 0 ==> a->shape->type->vertex != \null && b->shape->type->vertex != \null; */
bool gjk2_search_start(gjk2_search *s, const gjk2_collider *a, const gjk2_collider *b, bool circles, uint32_t radius);

#define TOGETHER(a, b, r)                                                    \
  (enclosing(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count) ||      \
   near_vertex(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count, r) || \
   near_edge(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count, r))

// What a checked decision means for the vertices; hull.v goes on from there.
/*@ requires posed(a) && posed(b) && \valid_read(decision);
    assigns \nothing;
    ensures no: \result == GJK_OK && decision->yes == 0 ==> CIRCLES(a, b, RADII(a, b) + distance) ||
      separated_by(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count, RADII(a, b) + distance);
    ensures yes: \result == GJK_OK && decision->yes != 0 ==> TOGETHER(a, b, RADIUS(RADII(a, b) + distance));
    ensures \result == GJK_OK ==> 0 <= distance; */
gjk_status gjk2_check_decision(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance,
                               const gjk2_decision *decision);

// What a checked distance means for the vertices.
/*@ requires posed(a) && posed(b) && \valid_read(result);
    assigns \nothing;
    ensures \result == GJK_OK ==> 0 <= result->distance;
    ensures meet: \result == GJK_OK && result->intersecting != 0 ==> result->distance == 0 && TOGETHER(a, b, RADII(a, b));
    ensures apart: \result == GJK_OK && result->intersecting == 0 ==> measured(a, b, APART_X(a, b), APART_Y(a, b), a->count,
      b->count, RADII(a, b), result->distance, NAMES(result->certificate), UNIT(result->normal), result->saturated, GAP(*result));
    ensures point_a: \result == GJK_OK && result->intersecting == 0 ==> HELD(a, result->point_a, result->saturated);
    ensures point_b: \result == GJK_OK && result->intersecting == 0 ==> HELD(b, result->point_b, result->saturated); */
gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result);

#endif
