// Contracts of the checker of depths in space: that the depth is enough.
#ifndef PROVE_CHECKER_DEPTH_H
#define PROVE_CHECKER_DEPTH_H

#include "measure.h"

// Along d no vertex of A - B, with r for both radii, lies more than the depth beyond the origin.
/*@ predicate enough3(gjk_collider *a, gjk_collider *b, integer x, integer y, integer z, integer r, integer depth) =
      \exists integer f, dx, dy, dz, wx, wy, wz; 1 <= f && 0 < norm3(dx, dy, dz) &&
        support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) &&
        at_most_root(dot3(dx, dy, dz, wx, wy, wz), (depth - r) * f, norm3(dx, dy, dz)); */

/*@ lemma enough3: \forall gjk_collider *a, *b, integer x, y, z, f, dx, dy, dz, wx, wy, wz, r, depth, t;
      1 <= f && 0 < norm3(dx, dy, dz) && support3(a, b, x, y, z, f, dx, dy, dz, wx, wy, wz) && t == (depth - r) * f &&
      at_most_root(dot3(dx, dy, dz, wx, wy, wz), t, norm3(dx, dy, dz)) ==> enough3(a, b, x, y, z, r, depth);
    lemma level_one3: \forall integer dx, dy, dz, x, y, z, u, v, w, s, t, q;
      behind_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, 0) ==> support_one3(x, y, z, 1, dx, dy, dz, 0, 0, 0, u, v, w, s, t, q);
    lemma level3: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz;
      behind3(a, b, x, y, z, dx, dy, dz, 0) ==> support3(a, b, x, y, z, 1, dx, dy, dz, 0, 0, 0);
    lemma level_along: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz, ex, ey, ez, m, n;
      all_along(a, dx, dy, dz, m) && all_along(b, ex, ey, ez, n) && ex == -dx && ey == -dy && ez == -dz &&
      dot3(x, y, z, dx, dy, dz) + m + n == 0 ==> behind3(a, b, x, y, z, dx, dy, dz, 0);
    lemma level_enough: \forall gjk_collider *a, *b, integer x, y, z, dx, dy, dz, r, depth; depth == r && 0 < norm3(dx, dy, dz) &&
      behind3(a, b, x, y, z, dx, dy, dz, 0) ==> enough3(a, b, x, y, z, r, depth); */

/*@ lemma face_root: \forall integer s, t, l, n; n == s * s && 0 <= t && square_at_most(n, l, t) ==> at_most_root(s, t, l);
    lemma turned_least: \forall integer n, m, t, u; t == -u && square_at_least(n, m, u) ==> square_at_least(n, m, t);
    lemma half_square_at_most: \forall integer n, m, t, u; u == 2 * t && 4 * n <= u * u * m ==> square_at_most(n, m, t);
    lemma half_square_at_least: \forall integer n, m, t, u; u == 2 * t && u * u * m <= 4 * n ==> square_at_least(n, m, t);
    lemma beyond_reach: \forall integer n, m, t; in_reach3(n, m) && REACH <= t ==> square_at_most(n, m, t);
    predicate square_over(integer s, integer t, integer l, integer n, integer m) =
      s * s * m == n * l && t * t * m <= n ==> t * t * l <= s * s;
    lemma square_over: \forall integer s, t, l, n, m; 0 < m && 0 < l ==> square_over(s, t, l, n, m);
    lemma below_root: \forall integer s, t, l, n, m; square_over(s, t, l, n, m) && s * s * m == n * l && 0 < m && 0 < l && s <= 0 &&
      t <= 0 && square_at_least(n, m, t) ==> at_most_root(s, t, l);
    lemma feature_root: \forall integer dx, dy, dz, x, y, z, n, m, t; across3(dx, dy, dz, x, y, z, n, m) && 0 < m &&
      0 < norm3(dx, dy, dz) && dot3(dx, dy, dz, x, y, z) <= 0 && t <= 0 && square_at_least(n, m, t) ==>
      at_most_root(dot3(dx, dy, dz, x, y, z), t, norm3(dx, dy, dz)); */

#define TWICE (uint64_t)((uint64_t)(uint32_t)((uint32_t)d << it->shift) * 2)

/*@ requires \valid_read(it) && FORMED(&it->simplex) && 0 <= it->shift <= 29 && -0x100000000 <= d <= 0x100000000;
    requires in_reach3(TOP_OF(&it->simplex), BOTTOM_OF(&it->simplex));
    assigns \nothing;
    ensures most: \result <= 0 ==> 0 <= d && square_at_most(TOP_OF(&it->simplex), BOTTOM_OF(&it->simplex), d * scale(it->shift));
    ensures least: \result >= 0 && 0 <= d ==>
      square_at_least(TOP_OF(&it->simplex), BOTTOM_OF(&it->simplex), d * scale(it->shift));
    ensures above: \result < 0 ==> 0 < d; */
static int compare_to(const gjk_iteration *it, int64_t d);

/*@ requires \valid_read(it) && \valid_read(it->a) && \valid_read(it->b) && \valid_read(it->a->shape) && \valid_read(it->b->shape);
    assigns \nothing;
    ensures \result == RADII(it->a, it->b); */
static inline int64_t gjk_convex_radii(const gjk_iteration *it);

/*@ requires FRAME(it) && CLAIM(it, certificate) && \valid(n) && \separated(n, it) && \separated(n, certificate);
    requires \separated(n, it->a) && \separated(n, it->b) && \separated(n, it->a->shape) && \separated(n, it->b->shape);
    requires \separated(n, it->a->shape->type) && \separated(n, it->b->shape->type);
    requires -0x100000000 <= depth <= 0x80000000;
    assigns it->simplex, *n;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enough3(it->a, it->b, APART_AT(it, Old), 0, depth); */
static bool is_facet(gjk_iteration *it, const gjk_certificate *certificate, int64_t depth, gjk_long3 *n);

/*@ requires \valid_read(it) && SOLID(it->a) && SOLID(it->b) && NEAR(it->a, it->b) && \valid_read(direction);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures way: \result == 1 ==> 0 < norm3(XYZ(*direction));
    ensures level: \result == 1 ==> behind3(it->a, it->b, APART(it->a, it->b), XYZ(*direction), 0); */
static bool is_level(const gjk_iteration *it, const gjk_vec3 *direction);

/*@ lemma enough_moved: \forall gjk_collider *a, *b, integer x, y, z, r, core, depth;
      enough3(a, b, x, y, z, 0, core) && core == depth - r ==> enough3(a, b, x, y, z, r, depth); */

/*@ requires FRAME(it) && CLAIM(it, result) && \valid(direction) && \separated(direction, it) && \separated(direction, result);
    requires \separated(direction, it->a) && \separated(direction, it->b);
    requires \separated(direction, it->a->shape) && \separated(direction, it->b->shape);
    requires \separated(direction, it->a->shape->type) && \separated(direction, it->b->shape->type);
    requires NEAR(it->a, it->b) && 0 <= RADII(it->a, it->b) <= 0x20000000;
    assigns it->simplex, *direction;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enough3(it->a, it->b, APART_AT(it, Old), \old(RADII(it->a, it->b)), result->depth); */
static bool is_depth(gjk_iteration *it, const gjk_penetration_result *result, gjk_long3 *direction);

// The search leaves the pair and its frame as they were.
/*@ requires \valid(it);
    assigns it->iterations, it->limit, it->recalls, it->seen[0 .. 1], it->ties[0 .. 1], it->scans, it->diagonal,
      it->direction, it->simplex; */
static inline gjk_outcome gjk_search_any(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache, unsigned limit);

/*@ requires \valid_read(it) && \valid(out) && \separated(it, out);
    assigns *out; */
void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out);

/*@ requires solid(a) && solid(b) && a->shape->type->stalls == \null && b->shape->type->stalls == \null;
    requires NEAR(a, b) && radius == RADII(a, b);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> together3(a, b, APART(a, b), radius); */
static bool intersect(const gjk_collider *a, const gjk_collider *b, int64_t radius);

/*@ assigns \nothing; */
static bool coincide(const gjk_iteration *it, const gjk_penetration_result *result);

/*@ assigns \nothing; */
static bool proves_parting(const gjk_iteration *it, const gjk_penetration_result *result, const gjk_long3 *direction);

// What a checked depth means for the vertices; solid.v goes on from there.
/*@ requires solid(a) && solid(b) && \valid_read(result);
    assigns \nothing;
    ensures apart: \result == GJK_OK && result->intersecting == 0 ==>
      SPHERES(a, b, RADII(a, b)) || separated_by3(a, b, APART(a, b), RADII(a, b));
    ensures meet: \result == GJK_OK && result->intersecting != 0 ==> together3(a, b, APART(a, b), RADII(a, b));
    ensures enough: \result == GJK_OK && result->intersecting != 0 ==>
      0 <= result->depth && enough3(a, b, APART(a, b), RADII(a, b), result->depth); */
gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result);

#endif
