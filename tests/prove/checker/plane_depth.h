// Contracts of the plane's checker of depths: that the depth is enough, and that B moved by it along the normal is apart.
#ifndef PROVE_CHECKER_PLANE_DEPTH_H
#define PROVE_CHECKER_PLANE_DEPTH_H

#include "plane.h"
#include "src/plane/gjk2_edges.h"
#include "src/plane/gjk2_outward.h"

// Along d no vertex of A - B, with r for both radii, lies more than the depth beyond the origin.
/*@ predicate enough(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r,
        integer depth, integer u, integer v) = \exists integer dx, dy, h; 0 < dot(dx, dy, dx, dy) &&
      behind(a, b, x, y, na, nb, dx, dy, h) && at_most_root(h, depth - r, dot(dx, dy, dx, dy)) && along_unit(dx, dy, u, v);
    // Nor does any lie beyond the origin once B has moved by (tx, ty).
    predicate cleared(integer h, integer r, integer square) = 0 <= h && r * r * square <= h * h;
    predicate moves(integer dx, integer dy, integer h, integer r, integer tx, integer ty) =
      cleared(dot(dx, dy, tx, ty) - h, r, dot(dx, dy, dx, dy));
    predicate parted(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r,
        integer tx, integer ty) = \exists integer dx, dy, h; 0 < dot(dx, dy, dx, dy) &&
      behind(a, b, x, y, na, nb, dx, dy, h) && moves(dx, dy, h, r, tx, ty);
    // t is depth u / 2^30, rounded away from 0.
    predicate steps(integer t, integer depth, integer u) =
      (0 <= u ==> 0x40000000 * (t - 1) < depth * u <= 0x40000000 * t) &&
      (u < 0 ==> 0x40000000 * t <= depth * u < 0x40000000 * (t + 1));
    predicate moved(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer r,
        integer depth, integer u, integer v) = \exists integer tx, ty; steps(tx, depth, u) && steps(ty, depth, v) &&
      parted(a, b, x, y, na, nb, r, tx, ty); */

/*@ lemma enough: \forall gjk2_collider *a, *b, integer x, y, na, nb, r, core, depth, dx, dy, h, u, v; core == depth - r &&
      0 < dot(dx, dy, dx, dy) && behind(a, b, x, y, na, nb, dx, dy, h) && at_most_root(h, core, dot(dx, dy, dx, dy)) &&
      along_unit(dx, dy, u, v) ==> enough(a, b, x, y, na, nb, r, depth, u, v);
    lemma parted: \forall gjk2_collider *a, *b, integer x, y, na, nb, r, tx, ty, dx, dy, h; 0 < dot(dx, dy, dx, dy) &&
      behind(a, b, x, y, na, nb, dx, dy, h) && moves(dx, dy, h, r, tx, ty) ==> parted(a, b, x, y, na, nb, r, tx, ty);
    lemma moved: \forall gjk2_collider *a, *b, integer x, y, na, nb, r, depth, u, v, tx, ty; steps(tx, depth, u) &&
      steps(ty, depth, v) && parted(a, b, x, y, na, nb, r, tx, ty) ==> moved(a, b, x, y, na, nb, r, depth, u, v); */

/*@ predicate lies_from(integer h, integer square, integer low, integer more) =
      (0 <= low ==> reaches(h, square, low * low, more)) && !reaches(h, square, (low + 1) * (low + 1), more);
    lemma below_next: \forall integer h, square, core; 0 <= h && lies_from(h, square, core - 1, 1) && 0 <= core ==>
      at_most_root(h, core, square);
    lemma above_low: \forall integer h, square, core; h < 0 && core <= 0 && 0 <= square && lies_from(-h, square, -core, 0) ==>
      at_most_root(h, core, square);
    predicate clears(integer h, integer r, integer square) =
      reaches(h, square, r * r, 0) <==> r * r * square <= h * h;
    lemma clears: \forall integer h, r, square; clears(h, r, square);
    lemma clears_none: \forall integer h, square; 0 <= h ==> cleared(h, 0, square);
    lemma above_none: \forall integer h, square; h <= 0 ==> at_most_root(h, 0, square);
    lemma near_height: \forall integer h, r, square; 0 <= h && 0 <= r <= 0x20000000 && 0 <= square < 0x4000000000000000 &&
      !farther(h, r, square) ==> h <= 0x1000000000000000;
    lemma vertex_near: \forall integer x, y, dx, dy, h, r; 0 <= r && h < 0 && of_vertex(x, y, dx, dy, h) &&
      !farther(-h, r, dot(dx, dy, dx, dy)) ==> near_point(x, y, r);
    predicate discs(integer x, integer y, integer u, integer v, integer s, integer t) =
      in_disc(x, y, 0x40000000) && in_disc(u, v, 0x10000000) && in_disc(s, t, 0x10000000);
    predicate reach_sum(integer x, integer y, integer u, integer v, integer s, integer t) = in_disc(-s, -t, 0x10000000) &&
      sum_in(u, v, -s, -t, 0x10000000, 0x10000000) && sum_in(x, y, u - s, v - t, 0x40000000, 0x20000000);
    predicate reach_one(integer x, integer y, integer u, integer v, integer s, integer t) =
      in_reach(x, y, x + u - s, y + v - t);
    lemma reach_sum: \forall integer x, y, u, v, s, t; discs(x, y, u, v, s, t) ==> reach_sum(x, y, u, v, s, t);
    lemma reach_one: \forall integer x, y, u, v, s, t; discs(x, y, u, v, s, t) && reach_sum(x, y, u, v, s, t) ==>
      reach_one(x, y, u, v, s, t);
    predicate turned(integer x, integer y, integer u, integer v) =
      dot(v - y, -(u - x), v - y, -(u - x)) == dot(u - x, v - y, u - x, v - y);
    lemma turned: \forall integer x, y, u, v; turned(x, y, u, v);
    predicate near_by(integer h, integer r, integer square) = !farther(-h, r, square) ==> h * h <= r * r * square;
    lemma near_by: \forall integer h, r, square; near_by(h, r, square);
    lemma edge_near: \forall integer x, y, u, v, dx, dy, h, r; turned(x, y, u, v) &&
      near_by(h, r, dot(u - x, v - y, u - x, v - y)) && of_edge(x, y, u, v, dx, dy, h) &&
      !farther(-h, r, dot(dx, dy, dx, dy)) ==> near_line(x, y, u, v, r); */

/*@ requires h < 0x4000000000000000 && squared < 0x4000000000000000 && more <= 1 && -0x80000000 <= low <= 0x80000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> -1 <= low < 0x7fffffff && lies_from(h, squared, low, more); */
static bool plane_lies_from(uint64_t h, uint64_t squared, int64_t low, unsigned more);

// The searches leave the pair and its frame as they were.
#define SEARCHED(s)                                                                                                    \
  s->d, s->base, s->along, s->iterations, s->count, s->warm, s->walks, s->whole, s->alone, s->first, s->apex, s->last, \
      s->spare, s->slot[0..3]

/*@ requires \valid(s);
    assigns SEARCHED(s); */
void gjk2_search_aim(gjk2_search *s, const gjk2_cache *cache);

/*@ requires \valid(s);
    assigns SEARCHED(s); */
gjk2_outcome gjk2_search_run(gjk2_search *s, gjk2_goal goal, uint32_t limit);

/*@ requires \valid_read(s) && \valid(out) && \separated(s, out);
    assigns *out; */
void gjk2_search_certify(const gjk2_search *s, gjk2_outcome outcome, gjk2_certificate *out);

/*@ requires \valid(s) && \valid(edge) && \separated(s, edge);
    assigns SEARCHED(s), *edge; */
gjk2_lie gjk2_nearest_edge(gjk2_search *s, gjk2_edge *edge);

/*@ assigns \nothing; */
bool gjk2_edge_is_lower(const gjk2_edge *edge, uint64_t height, const gjk2_length *length);

/*@ requires \valid(length);
    assigns *length; */
void gjk2_length_set(gjk2_length *length, gjk2_vec n);

/*@ requires PAIR(s);
    assigns SEARCHED(s);
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> enclosing(COUNTS(s)); */
static bool cores_intersect(gjk2_search *s);

#define MEET(s, r) (enclosing(COUNTS(s)) || near_vertex(COUNTS(s), r) || near_edge(COUNTS(s), r))
#define ALONE(p, s) \
  (\valid(p) && \separated(p, s) && \separated(p, s->a) && \separated(p, s->b) && \separated(p, s->a->shape) &&       \
   \separated(p, s->b->shape) && \separated(p, s->a->shape->type) && \separated(p, s->b->shape->type))
#define BOUND(s, n, h)                                                                                           \
  (-REACH <= n->x <= REACH && -REACH <= n->y <= REACH && 0 < dot(n->x, n->y, n->x, n->y) < 0x4000000000000000 && \
   -0x1000000000000000 <= *h < 0x4000000000000000 && behind(COUNTS(s), n->x, n->y, *h))
#define DEEP(n, h, core) at_most_root(*h, core, dot(n->x, n->y, n->x, n->y))

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && ALONE(n, s) && ALONE(height, s) && \separated(n, height);
    requires \separated(n, certificate) && \separated(height, certificate);
    requires 0 <= s->radius <= 0x20000000 && -0x20000000 <= core <= 0x20000000;
    assigns s->d.x, s->d.y, s->base, *n, *height;
    ensures \result == 0 || \result == 1;
    ensures bound: \result == 1 ==> BOUND(s, n, height);
    ensures deep: \result == 1 ==> DEEP(n, height, core);
    ensures named: \result == 1 ==> 1 <= certificate->count <= 2;
    ensures meet: \result == 1 ==> near_vertex(COUNTS(s), s->radius) || near_edge(COUNTS(s), s->radius); */
static bool feature_is_depth(gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                             int64_t *height);

/*@ requires READS(s) && \valid_read(certificate) && ALONE(n, s) && ALONE(height, s) && \separated(n, height);
    requires \separated(n, certificate) && \separated(height, certificate);
    assigns *n, *height;
    ensures \result == 0 || \result == 1;
    ensures bound: \result == 1 ==> BOUND(s, n, height);
    ensures deep: \result == 1 ==> DEEP(n, height, core);
    ensures named: \result == 1 ==> 1 <= certificate->count <= 2;
    ensures meet: \result == 1 ==> enclosing(COUNTS(s)); */
static bool line_is_depth(const gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                          int64_t *height);

/*@ requires PAIR(s) && CERTIFICATE(s, certificate) && ALONE(n, s) && ALONE(height, s) && \separated(n, height);
    requires \separated(n, certificate) && \separated(height, certificate) && -0x20000000 <= core <= 0x20000000;
    assigns SEARCHED(s), *n, *height;
    ensures \result == 0 || \result == 1;
    ensures bound: \result == 1 ==> BOUND(s, n, height);
    ensures deep: \result == 1 ==> DEEP(n, height, core);
    ensures named: \result == 1 ==> 1 <= certificate->count <= 2;
    ensures meet: \result == 1 ==> enclosing(COUNTS(s)); */
static bool edge_is_depth(gjk2_search *s, const gjk2_certificate *certificate, int64_t core, gjk2_vec *n,
                          int64_t *height);

/*@ requires PAIR(s) && CERTIFICATE(s, result) && ALONE(n, s) && ALONE(height, s) && \separated(n, height);
    requires \separated(n, result) && \separated(height, result) && 0 <= result->depth <= 0x20000000;
    requires 0 <= s->radius <= 0x20000000 && s->radius == RADII(s->a, s->b);
    assigns SEARCHED(s), *n, *height;
    ensures \result == 0 || \result == 1;
    ensures bound: \result == 1 ==> BOUND(s, n, height);
    ensures deep: \result == 1 ==> DEEP(n, height, result->depth - s->radius);
    ensures named: \result == 1 ==> 1 <= result->certificate.count <= 2;
    ensures meet: \result == 1 ==> MEET(s, s->radius); */
static bool plane_is_depth(gjk2_search *s, const gjk2_penetration_result *result, gjk2_vec *n, int64_t *height);

// The move.

/*@ requires 0 <= depth <= 0x20000000 && -MOST_UNIT <= u <= MOST_UNIT;
    assigns \nothing;
    ensures steps(\result, depth, u);
    ensures -0x20000002 <= \result <= 0x20000002; */
static inline gjk_q16 gjk2_outward_step(gjk_q16 depth, gjk_q30 u);

/*@ requires 0 <= depth <= 0x20000000 && -MOST_UNIT <= normal.x <= MOST_UNIT && -MOST_UNIT <= normal.y <= MOST_UNIT;
    assigns \nothing;
    ensures steps(\result.x, depth, normal.x) && steps(\result.y, depth, normal.y);
    ensures -0x20000002 <= \result.x <= 0x20000002 && -0x20000002 <= \result.y <= 0x20000002; */
gjk2_vec gjk2_outward_move(gjk_q16 depth, gjk2_unit normal);

/*@ requires DIRECTION(n) && dot(n.x, n.y, n.x, n.y) < 0x4000000000000000 && 0 <= radius <= 0x20000000;
    requires -0x1000000000000000 <= height < 0x4000000000000000;
    requires -0x20000002 <= t.x <= 0x20000002 && -0x20000002 <= t.y <= 0x20000002;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> moves(n.x, n.y, height, radius, t.x, t.y); */
bool gjk2_outward_clears(gjk2_vec n, int64_t height, int32_t radius, gjk2_vec t);

// The points are as far apart as the depth along the normal (u, v), to 3 LSB and 2^-28 of it. Halves of what they are off,
// in units of 2^-29 LSB, are rounded to the nearest.
/*@ logic integer half_off(integer depth, integer u, integer g) = down(0x40000000 * g - depth * u + 1, 1);
    predicate overlap(integer depth, integer u, integer v, integer gx, integer gy) =
      half_off(depth, u, gx) * half_off(depth, u, gx) + half_off(depth, v, gy) * half_off(depth, v, gy) <=
      (0x60000000 + 2 * depth) * (0x60000000 + 2 * depth); */

/*@ requires 0 <= depth && \valid_read(normal) && \valid_read(a) && \valid_read(b);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> overlap(depth, UNIT(*normal), a->x - b->x, a->y - b->y); */
bool gjk2_claim_overlap(gjk_q16 depth, const gjk2_unit *normal, const gjk2_vec *a, const gjk2_vec *b);

#define OVERLAP(result)                                                                    \
  (overlap((result).depth, UNIT((result).normal), (result).point_a.x - (result).point_b.x, \
           (result).point_a.y - (result).point_b.y) ||                                     \
   AT_END((result).point_a) || AT_END((result).point_b))

/*@ requires READS(s) && ROUNDED(s->a) && ROUNDED(s->b) && \valid_read(result) && 1 <= result->certificate.count <= 2;
    requires 0 <= result->depth;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures of_a: \result == 1 ==> HELD(s->a, result->point_a, 1);
    ensures of_b: \result == 1 ==> HELD(s->b, result->point_b, 1);
    ensures overlap: \result == 1 ==> OVERLAP(*result); */
static bool plane_coincide(const gjk2_search *s, const gjk2_penetration_result *result);

// What a checked depth means for the vertices.
/*@ requires posed(a) && posed(b) && \valid_read(result) && 0 <= a->radius <= 0x10000000 && 0 <= b->radius <= 0x10000000;
    assigns \nothing;
    ensures apart: \result == GJK_OK && result->intersecting == 0 ==> CIRCLES(a, b, RADII(a, b)) ||
      separated_by(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count, RADII(a, b));
    ensures meet: \result == GJK_OK && result->intersecting != 0 ==> TOGETHER(a, b, RADII(a, b));
    ensures enough: \result == GJK_OK && result->intersecting != 0 ==> 0 <= result->depth &&
      enough(a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count, RADII(a, b), result->depth, UNIT(result->normal));
    ensures moved: \result == GJK_OK && result->intersecting != 0 ==> moved(a, b, APART_X(a, b), APART_Y(a, b), a->count,
      b->count, RADII(a, b), result->depth, UNIT(result->normal));
    ensures point_a: \result == GJK_OK && result->intersecting != 0 ==> HELD(a, result->point_a, 1);
    ensures point_b: \result == GJK_OK && result->intersecting != 0 ==> HELD(b, result->point_b, 1);
    ensures overlap: \result == GJK_OK && result->intersecting != 0 ==> OVERLAP(*result); */
gjk_status gjk2_check_penetration(const gjk2_collider *a, const gjk2_collider *b,
                                  const gjk2_penetration_result *result);

#endif
