// Contracts of the decision checker of space, where it says that shapes are apart by spheres or by a direction.
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
#include "src/gjk/gjk_frame.h"

// Vertex i of a collider, relative to its centre, and how many there are.
/*@ axiomatic corners {
      logic integer px(gjk_collider *c, integer i) reads \nothing;
      logic integer py(gjk_collider *c, integer i) reads \nothing;
      logic integer pz(gjk_collider *c, integer i) reads \nothing;
      logic integer corners(gjk_collider *c) reads \nothing;
    } */

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
    predicate solid(gjk_collider *c) =
      \valid_read(c) && \valid_read(c->shape) && \valid_read(c->shape->type) &&
      0 <= c->core_radius && 0 <= c->shape->convex_radius && c->core_radius + c->shape->convex_radius <= 0x10000000 &&
      (c->shape->type->stalls == \null ==> polyhedral(c)); */

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

// The checker.
#define REACH 0x60000000
#define EXTENT 0x1200000000000000
#define DIRECTION(d) (-REACH <= (d).x <= REACH && -REACH <= (d).y <= REACH && -REACH <= (d).z <= REACH)

/*@ requires SOLID(c) && \valid_read(d) && DIRECTION(*d);
    assigns \nothing;
    ensures \forall integer i; 0 <= i < corners(c) ==> dot3(px(c, i), py(c, i), pz(c, i), XYZ(*d)) <= \result;
    ensures -EXTENT <= \result <= EXTENT; */
static int64_t farthest(const gjk_collider *c, const gjk_vec3 *d);

// What holds of each vertex of A - B.
/*@ predicate behind3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z,
        integer dx, integer dy, integer dz, integer h) = \forall integer i, j; 0 <= i < corners(a) && 0 <= j < corners(b) ==>
      behind_one3(dx, dy, dz, x, y, z, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j), h);
    predicate all_beyond3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z,
        integer dx, integer dy, integer dz, integer r) = \forall integer i, j; 0 <= i < corners(a) && 0 <= j < corners(b) ==>
      beyond_one3(dx, dy, dz, x, y, z, px(a, i), py(a, i), pz(a, i), px(b, j), py(b, j), pz(b, j), r); */
/*@ lemma all_beyond3: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz, h, r;
      behind3(a, b, x, y, z, dx, dy, dz, h) && clear3(dx, dy, dz, h, r) ==> all_beyond3(a, b, x, y, z, dx, dy, dz, r); */

/*@ requires \valid_read(it) && SOLID(it->a) && SOLID(it->b) && NEAR(it->a, it->b);
    requires \valid_read(direction) && 0 <= radius;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> all_beyond3(it->a, it->b, APART(it->a, it->b), XYZ(*direction), radius); */
static bool is_separating(const gjk_iteration *it, const gjk_vec3 *direction, int64_t radius);

// Not looked at here: what follows from a feature.
/*@ assigns it->simplex; */
static bool is_nearest(gjk_iteration *it, const gjk_certificate *certificate);
/*@ assigns it->simplex; */
static bool is_together(gjk_iteration *it, const gjk_certificate *certificate);
/*@ assigns \nothing; */
bool gjk_iteration_near(const gjk_iteration *it);

/*@ predicate separated_by3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer r) =
      \exists integer dx, dy, dz; all_beyond3(a, b, x, y, z, dx, dy, dz, r); */

/*@ requires \valid(it) && SOLID(it->a) && SOLID(it->b) && NEAR(it->a, it->b) && 0 <= radius;
    requires \valid_read(certificate) && \separated(it, certificate) && \separated(it, it->a) && \separated(it, it->b);
    assigns it->simplex;
    ensures \result == 1 && certificate->proof == GJK_PROOF_DIRECTION ==>
      separated_by3(it->a, it->b, APART(it->a, it->b), radius); */
static bool is_apart(gjk_iteration *it, const gjk_certificate *certificate, int64_t radius);

// The frame.
/*@ requires \valid_read(v) && n <= 3 && 0 <= r < 0x200000000;
    requires -0x100000000 <= v->x <= 0x100000000 && -0x100000000 <= v->y <= 0x100000000 && -0x100000000 <= v->z <= 0x100000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures n == 0 && \result == 1 ==> spheres_apart(XYZ(*v), r);
    ensures n == 0 && \result == 0 && r < 0x80000000 ==> in_ball(XYZ(*v), r); */
static bool longer_than(const gjk_long3 *v, unsigned n, int64_t r);

/*@ requires \valid_read(delta);
    requires -0x100000000 <= delta->x <= 0x100000000 && -0x100000000 <= delta->y <= 0x100000000 &&
      -0x100000000 <= delta->z <= 0x100000000;
    assigns \nothing;
    ensures -3 <= \result <= 0;
    ensures \result == 0 ==> in_ball(XYZ(*delta), 0x40000000); */
static int far_shift(const gjk_long3 *delta);

/*@ assigns \nothing; */
static int32_t far_component(int64_t difference, int shift);

#define ROUND(it, c) (\valid_read(c) && \separated(it, c) && 0 <= (c)->core_radius <= 0x10000000)

/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= radius <= 0xffffffff;
    assigns it->shift, it->delta, it->radius;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> SPHERES(it->a, it->b, radius);
    ensures \result == 1 && it->shift >= 0 ==> NEAR(it->a, it->b); */
bool gjk_frame_set_far(gjk_iteration *it, bool spheres, int64_t radius);

// Taken as given: provers do not see what bits say of sizes.
/*@ requires \valid(it) && ROUND(it, it->a) && ROUND(it, it->b) && 0 <= radius <= 0xffffffff;
    assigns it->shift, it->delta, it->radius;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> SPHERES(it->a, it->b, radius);
    ensures \result == 1 && it->shift >= 0 ==> NEAR(it->a, it->b); */
static inline bool gjk_frame_set(gjk_iteration *it, bool spheres, int64_t radius);

/*@ assigns \nothing; */
static inline bool gjk_goal_separates(gjk_goal goal);

/*@ requires \valid(s);
    assigns *s; */
void gjk_simplex_clear(gjk_simplex *s);

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
    ensures spheres: \result == 0 ==> SPHERES(a, b, radius);
    ensures \result == 1 ==> it->a == a && it->b == b;
    ensures \result == 1 && it->shift >= 0 ==> NEAR(a, b);
    ensures \result == 1 && it->stalls == \null ==> a->shape->type->stalls == \null && b->shape->type->stalls == \null; */
bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius);

// What a checked "no" means for the vertices; hull.v goes on from there.
/*@ requires solid(a) && solid(b) && \valid_read(decision);
    assigns \nothing;
    ensures no: \result == GJK_OK && decision->yes == 0 && decision->certificate.proof == GJK_PROOF_DIRECTION ==>
      SPHERES(a, b, RADII(a, b) + distance) || separated_by3(a, b, APART(a, b), RADII(a, b) + distance);
    ensures \result == GJK_OK ==> 0 <= distance; */
gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision);

#endif
