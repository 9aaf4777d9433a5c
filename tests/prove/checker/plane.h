// Contracts of the plane's decision checker: what each function means for the vertices of two colliders.
#ifndef PROVE_CHECKER_PLANE_H
#define PROVE_CHECKER_PLANE_H

#include "geometry.h"
#include "gjk2/check.h"
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
      c->shape->type->vertex == &plane_vertex && c->count >= 1 && 0 <= c->core_radius <= 0x10000000 &&
      (\forall integer i; 0 <= i < c->count ==> in_disc(vx(c, i), vy(c, i), c->core_radius));
    predicate posed(gjk2_collider *c) =
      \valid_read(c) && \valid_read(c->shape) && \valid_read(c->shape->type) &&
      0 <= c->core_radius && 0 <= c->shape->convex_radius && c->core_radius + c->shape->convex_radius <= 0x10000000 &&
      (c->ordered != 0 ==> c->shape->type->vertex != \null) &&
      (c->shape->type->vertex != \null ==> polygonal(c)); */

// The geometry of vertices: p = A's vertex i less B's vertex j.
/*@ logic integer px(gjk2_collider *a, gjk2_collider *b, integer i, integer j) =
      a->centre.x - b->centre.x + vx(a, i) - vx(b, j);
    logic integer py(gjk2_collider *a, gjk2_collider *b, integer i, integer j) =
      a->centre.y - b->centre.y + vy(a, i) - vy(b, j); */

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

// The frame: a point is in reach if it is at most 3 2^29 from the origin.
#define REACH 0x60000000
#define COLLIDER(c) (\valid_read(c) && \valid_read((c)->shape) && \valid_read((c)->shape->type) && polygonal(c))
#define BESIDE(s, c) (\separated(s, c) && \separated(s, (c)->shape) && \separated(s, (c)->shape->type))
#define BOTH(s) (COLLIDER(s->a) && COLLIDER(s->b))
#define NEAR(s) (s->far == 0 && in_disc(s->delta.x, s->delta.y, 0x40000000))
#define PAIR(s) (\valid(s) && BOTH(s) && BESIDE(s, s->a) && BESIDE(s, s->b) && NEAR(s))

/*@ logic integer qx(gjk2_search *s, integer i, integer j) = s->delta.x + vx(s->a, i) - vx(s->b, j);
    logic integer qy(gjk2_search *s, integer i, integer j) = s->delta.y + vy(s->a, i) - vy(s->b, j); */

/*@ requires s->far == 0 && \valid_read(s);
    requires -0x80000000 <= s->delta.x + offset.x <= 0x7fffffff && -0x80000000 <= s->delta.y + offset.y <= 0x7fffffff;
    assigns \nothing;
    ensures \result.x == s->delta.x + offset.x && \result.y == s->delta.y + offset.y; */
static gjk2_vec framed(const gjk2_search *s, gjk2_vec offset);

/*@ requires \valid_read(s) && BOTH(s) && NEAR(s);
    requires \valid(out) && BESIDE(out, s->a) && BESIDE(out, s->b);
    requires \separated(out, &s->a, &s->b, &s->delta, &s->far);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> a < s->a->count && b < s->b->count;
    ensures \result == 1 ==> out->w.x == qx(s, a, b) && out->w.y == qy(s, a, b);
    ensures \result == 1 ==> in_disc(out->w.x, out->w.y, REACH);
    ensures \result == 1 ==> -0x20000000 <= out->w.x - s->delta.x <= 0x20000000 &&
      -0x20000000 <= out->w.y - s->delta.y <= 0x20000000; */
bool gjk2_search_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vertex *out);

// The checker.
#define DIRECTION(d) (-REACH <= (d).x <= REACH && -REACH <= (d).y <= REACH)
#define EXTENT 0xC00000000000000

/*@ requires COLLIDER(c) && DIRECTION(d);
    assigns \nothing;
    ensures \forall integer i; 0 <= i < c->count ==> dot(vx(c, i), vy(c, i), d.x, d.y) <= \result;
    ensures -EXTENT <= \result <= EXTENT; */
static int64_t plane_farthest(const gjk2_collider *c, gjk2_vec d);

/*@ predicate behind(gjk2_search *s, integer dx, integer dy, integer h) = \forall integer i, j;
      0 <= i < s->a->count && 0 <= j < s->b->count ==>
        dot(s->delta.x, s->delta.y, dx, dy) + dot(vx(s->a, i), vy(s->a, i), dx, dy) +
        dot(vx(s->b, j), vy(s->b, j), -dx, -dy) <= h;
    predicate all_beyond(gjk2_search *s, integer dx, integer dy, integer r) = \forall integer i, j;
      0 <= i < s->a->count && 0 <= j < s->b->count ==> beyond(dx, dy, qx(s, i, j), qy(s, i, j), r);
    predicate named(gjk2_search *s, gjk2_certificate *c, integer k) =
      c->a[k] < s->a->count && c->b[k] < s->b->count && in_disc(s->slot[k].w.x, s->slot[k].w.y, REACH) &&
      -0x20000000 <= s->slot[k].w.x - s->delta.x <= 0x20000000 && -0x20000000 <= s->slot[k].w.y - s->delta.y <= 0x20000000 &&
      s->slot[k].w.x == qx(s, c->a[k], c->b[k]) && s->slot[k].w.y == qy(s, c->a[k], c->b[k]); */

/*@ requires \valid_read(s) && BOTH(s) && NEAR(s) && DIRECTION(d);
    assigns \nothing;
    ensures behind(s, d.x, d.y, \result);
    ensures -0x7000000000000000 <= \result <= 0x7000000000000000; */
static int64_t support(const gjk2_search *s, gjk2_vec d);

#define CERTIFICATE(s, c) (\valid_read(c) && \separated(s, c))

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && most <= 3;
    assigns s->slot[0 .. 3];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> 1 <= certificate->count <= most;
    ensures \result == 1 ==> \forall integer k; 0 <= k < certificate->count ==> named(s, certificate, k); */
static bool load_named(gjk2_search *s, const gjk2_certificate *certificate, unsigned most);

/*@ requires \valid_read(p) && \valid_read(q) && in_disc(p->x, p->y, REACH) && in_disc(q->x, q->y, REACH);
    requires -0x40000000 <= q->x - p->x <= 0x40000000 && -0x40000000 <= q->y - p->y <= 0x40000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> foot(p->x, p->y, q->x, q->y); */
static bool has_foot(const gjk2_vec *p, const gjk2_vec *q);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate);
    assigns s->slot[0 .. 3], s->count, s->d, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> DIRECTION(s->d) && -0x4000000000000000 < s->base < 0;
    ensures \result == 1 ==> dot(s->d.x, s->d.y, s->d.x, s->d.y) < 0x4000000000000000;
    ensures \result == 1 ==> !farther(-s->base, REACH, dot(s->d.x, s->d.y, s->d.x, s->d.y)); */
static bool plane_set_feature(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate);
    assigns s->slot[0 .. 3], s->count, s->d, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> behind(s, s->d.x, s->d.y, s->base);
    ensures \result == 1 ==> DIRECTION(s->d) && -0x4000000000000000 < s->base < 0;
    ensures \result == 1 ==> dot(s->d.x, s->d.y, s->d.x, s->d.y) < 0x4000000000000000;
    ensures \result == 1 ==> !farther(-s->base, REACH, dot(s->d.x, s->d.y, s->d.x, s->d.y)); */
static bool plane_is_nearest(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires \valid_read(p) && \valid_read(q) && in_disc(p->x, p->y, REACH) && in_disc(q->x, q->y, REACH);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> on_segment(p->x, p->y, q->x, q->y); */
static bool holds_origin(const gjk2_vec *p, const gjk2_vec *q);

#define K2(c) ((c)->count > 1 ? 1 : 0)
#define K3(c) ((c)->count > 2 ? 2 : 0)

/*@ predicate enclosing(gjk2_search *s, gjk2_certificate *c) = in_triangle(qx(s, c->a[0], c->b[0]),
      qy(s, c->a[0], c->b[0]), qx(s, c->a[K2(c)], c->b[K2(c)]), qy(s, c->a[K2(c)], c->b[K2(c)]),
      qx(s, c->a[K3(c)], c->b[K3(c)]), qy(s, c->a[K3(c)], c->b[K3(c)]));
    predicate near_by(gjk2_search *s, gjk2_certificate *c, integer r) = c->count == 1 ?
      near_point(qx(s, c->a[0], c->b[0]), qy(s, c->a[0], c->b[0]), r) :
      foot(qx(s, c->a[0], c->b[0]), qy(s, c->a[0], c->b[0]), qx(s, c->a[1], c->b[1]), qy(s, c->a[1], c->b[1])) &&
      near_line(qx(s, c->a[0], c->b[0]), qy(s, c->a[0], c->b[0]), qx(s, c->a[1], c->b[1]), qy(s, c->a[1], c->b[1]), r);
    predicate numbered(gjk2_search *s, gjk2_certificate *c) = 1 <= c->count <= 3 &&
      \forall integer k; 0 <= k < c->count ==> c->a[k] < s->a->count && c->b[k] < s->b->count; */

/*@ requires PAIR(s) && CERTIFICATE(s, certificate);
    assigns s->slot[0 .. 3];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> numbered(s, certificate) && enclosing(s, certificate); */
static bool plane_is_enclosing(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && 0 <= s->radius;
    assigns s->slot[0 .. 3];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> certificate->count <= 2 && numbered(s, certificate) && near_by(s, certificate, s->radius); */
static bool plane_proves_near(gjk2_search *s, const gjk2_certificate *certificate);

/*@ requires \valid_read(s) && BOTH(s) && NEAR(s) && \valid_read(direction) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> all_beyond(s, direction->x, direction->y, radius); */
static bool direction_separates(const gjk2_search *s, const gjk2_vec *direction, int64_t radius);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && 0 <= radius;
    requires s->radius == (radius < REACH ? radius : REACH);
    assigns s->slot[0 .. 3], s->count, s->d, s->base;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 && certificate->proof == GJK2_PROOF_DIRECTION ==>
      all_beyond(s, certificate->direction.x, certificate->direction.y, radius);
    ensures \result == 1 && certificate->proof != GJK2_PROOF_DIRECTION ==> all_beyond(s, s->d.x, s->d.y, radius); */
static bool plane_is_apart(gjk2_search *s, const gjk2_certificate *certificate, int64_t radius);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && 0 <= s->radius;
    assigns s->slot[0 .. 3];
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> numbered(s, certificate) &&
      (enclosing(s, certificate) || (certificate->count <= 2 && near_by(s, certificate, s->radius))); */
static bool plane_is_together(gjk2_search *s, const gjk2_certificate *certificate);

#endif
