// Contracts of the plane's checker of casts, for ways and centres of less than 2^30 LSB along each axis.
#ifndef PROVE_CHECKER_PLANE_CAST_H
#define PROVE_CHECKER_PLANE_CAST_H

#include "plane.h"
#include "src/plane/gjk2_measure.h"
#include "src/plane_motion/gjk2_cast_report.h"
#include "src/plane_motion/gjk2_way.h"

// B moves by (tx, ty) against A. Circles of radii that add up to r, whose centres are (x, y) apart, never meet.
/*@ predicate foot_off(integer x, integer y, integer tx, integer ty, integer r) = dot(tx, ty, x, y) <= 0 ||
      dot(tx, ty, tx, ty) <= dot(tx, ty, x, y) || farther(cross(tx, ty, x, y), r, dot(tx, ty, tx, ty));
    predicate circles_pass(integer x, integer y, integer tx, integer ty, integer r) =
      stays_off(x, tx, r) || stays_off(y, ty, r) ||
      (circles_apart(x, y, r) && circles_apart(x - tx, y - ty, r) && foot_off(x, y, tx, ty, r));
    // Along one direction all of A - B stays more than r behind the way.
    predicate passing(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer tx,
        integer ty, integer r) = \exists integer dx, dy, h; behind(a, b, x, y, na, nb, dx, dy, h) &&
      clear(dx, dy, h, r) && clear(dx, dy, h - dot(dx, dy, tx, ty), r);
    // The way meets A - B at the fraction in Q2.30, rounded down: no vertex lies before the line, on which two lie on either side.
    predicate portion(integer num, integer den, integer fraction) =
      fraction * den <= 0x40000000 * num < (fraction + 1) * den;
    predicate stands(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer i, integer j,
        integer wx, integer wy) = 0 <= i < na && 0 <= j < nb && place(a, b, x, y, i, j, wx, wy);
    predicate entered_by(integer tx, integer ty, integer px, integer py, integer qx, integer qy, integer dx, integer dy,
        integer h, integer fraction) = dot(dx, dy, tx, ty) <= h < 0 && dot(dx, dy, px, py) == h &&
      dot(dx, dy, qx, qy) == h && cross(tx, ty, px, py) <= 0 <= cross(tx, ty, qx, qy) &&
      portion(-h, -dot(dx, dy, tx, ty), fraction);
    predicate entering(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer tx,
        integer ty, integer fraction) = \exists integer i, j, k, l, px, py, qx, qy, dx, dy, h;
      stands(a, b, x, y, na, nb, i, j, px, py) && stands(a, b, x, y, na, nb, k, l, qx, qy) &&
      behind(a, b, x, y, na, nb, dx, dy, h) && entered_by(tx, ty, px, py, qx, qy, dx, dy, h, fraction); */

/*@ lemma passing: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, r, dx, dy, h;
      behind(a, b, x, y, na, nb, dx, dy, h) && clear(dx, dy, h, r) && clear(dx, dy, h - dot(dx, dy, tx, ty), r) ==>
      passing(a, b, x, y, na, nb, tx, ty, r);
    lemma entering: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, fraction, i, j, k, l, px, py, qx, qy, dx, dy, h;
      stands(a, b, x, y, na, nb, i, j, px, py) && stands(a, b, x, y, na, nb, k, l, qx, qy) &&
      behind(a, b, x, y, na, nb, dx, dy, h) && entered_by(tx, ty, px, py, qx, qy, dx, dy, h, fraction) ==>
      entering(a, b, x, y, na, nb, tx, ty, fraction); */

#define SHORT(x) (-0x40000000 < (x) < 0x40000000)
#define MOVES_X(c, to) ((to) == \null ? 0 : (to)->x - (c)->position.x)
#define MOVES_Y(c, to) ((to) == \null ? 0 : (to)->y - (c)->position.y)
#define MOVE_X(a, b, p) (MOVES_X(b, (p)->to_b) - MOVES_X(a, (p)->to_a))
#define MOVE_Y(a, b, p) (MOVES_Y(b, (p)->to_b) - MOVES_Y(a, (p)->to_a))
#define PATH(p) \
  (\valid_read(p) && ((p)->to_a == \null || \valid_read((p)->to_a)) && ((p)->to_b == \null || \valid_read((p)->to_b)))
#define SHORT_PATH(a, b, p) \
  (SHORT(MOVE_X(a, b, p)) && SHORT(MOVE_Y(a, b, p)) && SHORT(APART_X(a, b)) && SHORT(APART_Y(a, b)))

// A way's numbers.
#define NUMBERS(w)                                                                                                 \
  (w->wide == 0 && SHORT(w->t.x) && SHORT(w->t.y) && SHORT(w->delta.x) && SHORT(w->delta.y) && w->d.x == w->t.x && \
   w->d.y == w->t.y && w->base == cross(w->t.x, w->t.y, w->delta.x, w->delta.y))
#define WAY(w) (\valid_read(w) && NUMBERS(w) && COLLIDER(w->a) && COLLIDER(w->b))
#define WAY_FRAME(w) w->a, w->b, w->delta.x, w->delta.y, w->a->count, w->b->count
#define WAY_T(w) w->t.x, w->t.y
#define OFFSET(o) (-0x20000000 <= (o).x <= 0x20000000 && -0x20000000 <= (o).y <= 0x20000000)

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> -0x100000000 < x < 0x100000000; */
static bool plane_way_fits(int64_t x);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> -0x80000000 <= x <= 0x7fffffff; */
static inline bool plane_way_ends_inside(int64_t x);

/*@ requires \valid_read(c) && (to == \null || \valid_read(to)) && \valid(way) && \separated(way, c) && \separated(way, to);
    assigns *way;
    ensures \result == 0 || \result == 1;
    ensures way->x == MOVES_X(c, to) && way->y == MOVES_Y(c, to); */
static bool plane_way_of(const gjk2_collider *c, const gjk2_vec *to, gjk2_long *way);

#define MAGNITUDE(x) ((x) < 0 ? -(x) : (x))

/*@ predicate below30(integer x, integer y) = 0 <= (x | y) < 0x40000000 && down(x | y, 30) == 0;
    lemma below30: \forall integer x, y; 0 <= x < 0x40000000 && 0 <= y < 0x40000000 ==> below30(x, y); */

/*@ requires \valid_read(v);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures SHORT(v->x) && SHORT(v->y) ==> \result == 1; */
static bool plane_is_short(const gjk2_long *v);

/*@ requires \valid(way) && SHORT(way->t.x) && SHORT(way->t.y) && SHORT(way->delta.x) && SHORT(way->delta.y);
    assigns way->d, way->base, way->wide;
    ensures NUMBERS(way); */
static void plane_way_aim(gjk2_way *way);

/*@ requires \valid(way) && \valid_read(a) && \valid_read(b) && PATH(path) && SHORT_PATH(a, b, path);
    requires \separated(way, a) && \separated(way, b) && \separated(way, path);
    requires \separated(way, path->to_a) && \separated(way, path->to_b);
    assigns *way;
    ensures \result == GJK_OK ==> way->a == a && way->b == b && path->margin >= 0 && NUMBERS(way);
    ensures \result == GJK_OK ==> way->t.x == MOVE_X(a, b, path) && way->t.y == MOVE_Y(a, b, path);
    ensures \result == GJK_OK ==> way->delta.x == APART_X(a, b) && way->delta.y == APART_Y(a, b); */
gjk_status gjk2_way_set(gjk2_way *way, const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                        const void *out);

#define BELOW34(x) (-0x400000000 < (x) < 0x400000000)

/*@ requires -0x80000000 < x < 0x80000000 && -0x80000000 < y < 0x80000000 && 0 <= reach < 0x80000000;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> circles_apart(x, y, reach); */
static bool plane_is_longer(int64_t x, int64_t y, int64_t reach);

/*@ requires BELOW34(x) && BELOW34(y) && BELOW34(reach);
    assigns \nothing; */
static bool plane_is_outside(int64_t x, int64_t y, int64_t reach);

/*@ requires BELOW34(from) && BELOW34(to) && BELOW34(reach);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> stays_off(from, from - to, reach); */
static bool plane_stays_off(int64_t from, int64_t to, int64_t reach);

#define REACH_OF(w, radius) (w->a->core_radius + w->b->core_radius + radius)

/*@ requires \valid_read(way) && NUMBERS(way) && \valid_read(way->a) && \valid_read(way->b) && \valid(early) && \valid(late);
    requires \separated(early, late) && \separated(early, way) && \separated(late, way);
    requires 0 <= way->a->core_radius <= 0x10000000 && 0 <= way->b->core_radius <= 0x10000000 && 0 <= radius < 0x100000000;
    assigns *early, *late;
    ensures \result == 0 || \result == 1;
    ensures \result == 0 ==> circles_pass(way->delta.x, way->delta.y, WAY_T(way), REACH_OF(way, radius)); */
bool gjk2_way_may_meet(const gjk2_way *way, int64_t radius, bool *early, bool *late);

/*@ predicate left_most(gjk2_collider *c, integer n, integer tx, integer ty, integer most) = \forall integer i;
      0 <= i < n ==> cross(tx, ty, vx(c, i), vy(c, i)) <= most;
    predicate right_most(gjk2_collider *c, integer n, integer tx, integer ty, integer least) = \forall integer i;
      0 <= i < n ==> least <= cross(tx, ty, vx(c, i), vy(c, i));
    lemma left_next: \forall gjk2_collider *c, integer n, tx, ty, m, most; left_most(c, n, tx, ty, m) && m <= most &&
      cross(tx, ty, vx(c, n), vy(c, n)) <= most ==> left_most(c, n + 1, tx, ty, most);
    lemma right_next: \forall gjk2_collider *c, integer n, tx, ty, m, least; right_most(c, n, tx, ty, m) && least <= m &&
      least <= cross(tx, ty, vx(c, n), vy(c, n)) ==> right_most(c, n + 1, tx, ty, least); */
#define LEFT_MOST(c, t, o) left_most(c, c->count, (t)->x, (t)->y, cross((t)->x, (t)->y, (o).x, (o).y))
#define RIGHT_MOST(c, t, o) right_most(c, c->count, (t)->x, (t)->y, cross((t)->x, (t)->y, (o).x, (o).y))

/*@ requires COLLIDER(c) && \valid_read(t) && SHORT(t->x) && SHORT(t->y) && \valid(out);
    requires \separated(out, c) && \separated(out, c->shape) && \separated(out, c->shape->type) && \separated(out, t);
    assigns *out;
    ensures in_disc(out->offset.x, out->offset.y, 0x10000000);
    ensures left != 0 ==> LEFT_MOST(c, t, out->offset);
    ensures left == 0 ==> RIGHT_MOST(c, t, out->offset); */
void gjk2_way_outermost_of(const gjk2_collider *c, const gjk2_long *t, bool left, gjk2_support *out);

#define SIDE_MOST 0x3000000000000000

/*@ requires \valid_read(way) && NUMBERS(way) && OFFSET(o);
    assigns \nothing;
    ensures -SIDE_MOST <= \result <= SIDE_MOST;
    ensures \result == cross(way->t.x, way->t.y, way->delta.x + o.x, way->delta.y + o.y); */
int64_t gjk2_way_side(const gjk2_way *way, gjk2_vec o);

/*@ requires \valid_read(way) && NUMBERS(way) && OFFSET(o) && 0 <= radius <= 0x7fffffff;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> farther(cross(way->t.x, way->t.y, way->delta.x + o.x, way->delta.y + o.y), radius,
      dot(way->t.x, way->t.y, way->t.x, way->t.y)); */
bool gjk2_way_is_beside(const gjk2_way *way, gjk2_vec o, int64_t radius);

#define UNIT_MOST 0x40000004
#define ALONG_MOST 0x4000000000000000

/*@ requires \valid_read(way) && NUMBERS(way) && OFFSET(o) && DIRECTION(n);
    requires -UNIT_MOST <= n.x <= UNIT_MOST && -UNIT_MOST <= n.y <= UNIT_MOST;
    assigns \nothing;
    ensures -ALONG_MOST <= \result <= ALONG_MOST;
    ensures \result == dot(n.x, n.y, way->delta.x + o.x, way->delta.y + o.y); */
int64_t gjk2_way_along(const gjk2_way *way, gjk2_vec n, gjk2_vec o);

/*@ requires \valid_read(way) && NUMBERS(way) && -UNIT_MOST <= n.x <= UNIT_MOST && -UNIT_MOST <= n.y <= UNIT_MOST;
    assigns \nothing;
    ensures -ALONG_MOST <= \result <= ALONG_MOST;
    ensures \result == dot(n.x, n.y, way->t.x, way->t.y); */
int64_t gjk2_way_ahead(const gjk2_way *way, gjk2_vec n);

// The checker.
// A vertex of A - B that the certificate names.
#define SPAN(w, s)                                                           \
  (s->a.vertex < w->a->count && s->b.vertex < w->b->count && OFFSET(s->o) && \
   s->o.x == vx(w->a, s->a.vertex) - vx(w->b, s->b.vertex) && s->o.y == vy(w->a, s->a.vertex) - vy(w->b, s->b.vertex))

/*@ requires WAY(way) && \valid_read(c) && i < 3 && \valid(out) && \separated(out, way) && \separated(out, c);
    requires \separated(out, way->a) && \separated(out, way->a->shape) && \separated(out, way->a->shape->type);
    requires \separated(out, way->b) && \separated(out, way->b->shape) && \separated(out, way->b->shape->type);
    assigns *out;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> SPAN(way, out); */
static bool plane_name_span(const gjk2_way *way, const gjk2_cast_certificate *c, unsigned i, gjk2_span *out);

// The outermost vertices u of A and v of B bound A - B on one side of the way.
/*@ predicate turned_left(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer tx,
        integer ty, integer ux, integer uy, integer wx, integer wy) =
      behind(a, b, x, y, na, nb, -ty, tx, cross(tx, ty, x + ux - wx, y + uy - wy));
    predicate turned_right(gjk2_collider *a, gjk2_collider *b, integer x, integer y, integer na, integer nb, integer tx,
        integer ty, integer ux, integer uy, integer wx, integer wy) =
      behind(a, b, x, y, na, nb, ty, -tx, -cross(tx, ty, x + ux - wx, y + uy - wy));
    lemma turned_left: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, ux, uy, wx, wy;
      left_most(a, na, tx, ty, cross(tx, ty, ux, uy)) && right_most(b, nb, tx, ty, cross(tx, ty, wx, wy)) ==>
      turned_left(a, b, x, y, na, nb, tx, ty, ux, uy, wx, wy);
    lemma turned_right: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, ux, uy, wx, wy;
      right_most(a, na, tx, ty, cross(tx, ty, ux, uy)) && left_most(b, nb, tx, ty, cross(tx, ty, wx, wy)) ==>
      turned_right(a, b, x, y, na, nb, tx, ty, ux, uy, wx, wy);
    lemma passes_left: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, h, r;
      behind(a, b, x, y, na, nb, -ty, tx, h) && h < 0 && farther(h, r, dot(tx, ty, tx, ty)) ==>
      passing(a, b, x, y, na, nb, tx, ty, r);
    lemma passes_right: \forall gjk2_collider *a, *b, integer x, y, na, nb, tx, ty, h, r;
      behind(a, b, x, y, na, nb, ty, -tx, -h) && h > 0 && farther(h, r, dot(tx, ty, tx, ty)) ==>
      passing(a, b, x, y, na, nb, tx, ty, r); */

#define PASSING(w, radius) passing(WAY_FRAME(w), WAY_T(w), radius)

/*@ requires WAY(way) && 0 <= radius <= 0x7fffffff && \valid(side) && \separated(side, way);
    assigns *side;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> PASSING(way, radius); */
static bool plane_leaves_beside(const gjk2_way *way, bool left, int64_t radius, int64_t *side);

/*@ requires WAY(way) && 0 <= radius <= 0x7fffffff && \valid_read(c);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> PASSING(way, radius); */
static bool plane_passes_beside(const gjk2_way *way, const gjk2_cast_certificate *c, int64_t radius);

// A direction that a check takes: its square is at most (2^30 + 4)^2, or it is that of the way, turned round.
/*@ predicate taken(integer x, integer y, integer tx, integer ty) = (x == -tx && y == -ty) || in_disc(x, y, 0x40000004); */
// So at the end of the way, too, no product is large.
/*@ predicate at_least(integer t, integer r, integer s) = -(r * s) <= t;
    lemma discs_least: \forall integer x, y, u, v, r, s; 0 <= r && 0 <= s && in_disc(x, y, r) && in_disc(u, v, s) ==>
      at_least(dot(x, y, u, v), r, s);
    lemma end_disc: \forall integer x, y; -0x80000000 < x < 0x80000000 && -0x80000000 < y < 0x80000000 ==>
      in_disc(x, y, 0xB504F334);
    predicate ends_above(integer dx, integer dy, integer x, integer y, integer tx, integer ty, integer u, integer v,
        integer s, integer t) = -0x4000000000000000 < dot(x, y, dx, dy) + dot(u, v, dx, dy) + dot(s, t, -dx, -dy) -
      dot(dx, dy, tx, ty);
    lemma ends_above: \forall integer dx, dy, x, y, tx, ty, u, v, s, t;
      at_least(dot(dx, dy, x - tx, y - ty), 0x40000004, 0xB504F334) && at_least(dot(dx, dy, u, v), 0x40000004, 0x10000000) &&
      at_least(dot(dx, dy, -s, -t), 0x40000004, 0x10000000) ==> ends_above(dx, dy, x, y, tx, ty, u, v, s, t);
    lemma own_ahead: \forall integer tx, ty; dot(-tx, -ty, tx, ty) <= 0;
    lemma taken_square: \forall integer x, y, tx, ty; taken(x, y, tx, ty) && -0x40000000 < tx < 0x40000000 &&
      -0x40000000 < ty < 0x40000000 ==> dot(x, y, x, y) < 0x4000000000000000; */
#define TAKEN(w, n) (-UNIT_MOST <= n.x <= UNIT_MOST && -UNIT_MOST <= n.y <= UNIT_MOST && taken(n.x, n.y, WAY_T(w)))

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> a.x == b.x && a.y == b.y; */
static inline bool gjk2_equal(gjk2_vec a, gjk2_vec b);

/*@ requires WAY(way) && \valid(most) && \valid(ahead) && \separated(most, ahead) && \separated(most, way) &&
      \separated(ahead, way);
    assigns *most, *ahead;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> TAKEN(way, n) && behind(WAY_FRAME(way), n.x, n.y, *most);
    ensures \result == 1 ==> *ahead == dot(n.x, n.y, way->t.x, way->t.y);
    ensures \result == 1 ==> -ALONG_MOST < *most < ALONG_MOST && -ALONG_MOST <= *ahead <= ALONG_MOST; */
static bool plane_along(const gjk2_way *way, gjk2_vec n, int64_t *most, int64_t *ahead);

/*@ requires -ALONG_MOST < height && dot(n.x, n.y, n.x, n.y) < 0x4000000000000000 && 0 <= radius;
    requires -0x80000000 < n.x && -0x80000000 < n.y;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> clear(n.x, n.y, height, radius); */
static bool plane_is_behind(int64_t height, gjk2_vec n, int64_t radius);

/*@ requires WAY(way) && \valid_read(direction) && 0 <= radius <= 0x7fffffff;
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> PASSING(way, radius); */
static bool plane_stays_behind(const gjk2_way *way, const gjk2_vec *direction, int64_t radius);

// What others write. That they write nothing else is taken as given.
/*@ assigns *out; */
gjk_status gjk2_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache, gjk2_distance_result *out);

/*@ assigns *out; */
gjk_status gjk2_within(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance, gjk2_cache *cache,
                       gjk2_decision *out);

/*@ assigns *out; */
void gjk2_cast_inside(const gjk2_way *way, const gjk2_distance_result *gap, gjk2_cast_result *out);

/*@ assigns *out; */
void gjk2_cast_hit(const gjk2_way *way, const gjk2_contact_place *place, const gjk2_portion *portion,
                   gjk2_cast_result *out);

/*@ assigns *exact; */
gjk_q30 gjk2_ratio(uint64_t num, uint64_t den, bool *exact);

/*@ requires \valid_read(way) && posed(way->a) && posed(way->b) && \valid_read(r);
    assigns \nothing;
    ensures \result == GJK_OK ==> TOGETHER(way->a, way->b, RADIUS(RADII(way->a, way->b) + margin)); */
static gjk_status plane_check_inside(const gjk2_way *way, gjk_q16 margin, const gjk2_cast_result *r);

/*@ requires \valid_read(way) && \valid_read(place) && \valid_read(portion) && \valid_read(r);
    assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool plane_follows(const gjk2_way *way, const gjk2_contact_place *place, const gjk2_portion *portion,
                          const gjk2_cast_result *r);

/*@ requires \valid(p) && p->num <= p->den && 0 < p->den < 0x8000000000000000;
    assigns p->exact;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> 0 <= p->fraction && portion(p->num, p->den, p->fraction); */
static bool plane_is_quotient(gjk2_portion *p);

#define STANDS(w, s) stands(WAY_FRAME(w), s->a.vertex, s->b.vertex, w->delta.x + s->o.x, w->delta.y + s->o.y)
#define ENTERING(w, fraction) entering(WAY_FRAME(w), WAY_T(w), fraction)

/*@ requires WAY(way) && \valid_read(p) && \valid_read(q) && SPAN(way, p) && SPAN(way, q) && \valid_read(r);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> ENTERING(way, r->fraction); */
static bool plane_enters(const gjk2_way *way, const gjk2_span *p, const gjk2_span *q, const gjk2_cast_result *r);

/*@ assigns \nothing;
    ensures \result == 0 || \result == 1; */
static bool plane_rounds(const gjk2_way *way, bool early, bool late, const gjk2_span *p, const gjk2_span *q,
                         int64_t radius, gjk_q16 margin, const gjk2_cast_result *r);

/*@ requires WAY(way) && 0 <= radius <= 0x7fffffff && \valid_read(r);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> r->inside == 0;
    ensures \result == 1 && radius == 0 ==> ENTERING(way, r->fraction); */
static bool plane_check_hit(const gjk2_way *way, bool early, bool late, int64_t radius, gjk_q16 margin,
                            const gjk2_cast_result *r);

/*@ requires WAY(way) && 0 <= radius <= 0x7fffffff && \valid_read(c);
    assigns \nothing;
    ensures \result == 0 || \result == 1;
    ensures \result == 1 ==> PASSING(way, radius); */
static bool plane_check_miss(const gjk2_way *way, int64_t radius, const gjk2_cast_certificate *c);

#define FRAME_OF(a, b) a, b, APART_X(a, b), APART_Y(a, b), a->count, b->count
#define MOVE(a, b, p) MOVE_X(a, b, p), MOVE_Y(a, b, p)

// What a checked cast means for the vertices; hull.v goes on from there.
/*@ requires posed(a) && posed(b) && PATH(path) && SHORT_PATH(a, b, path) && \valid_read(result);
    assigns \nothing;
    ensures \result == GJK_OK ==> 0 <= path->margin;
    ensures miss: \result == GJK_OK && result->hit == 0 ==>
      circles_pass(APART_X(a, b), APART_Y(a, b), MOVE(a, b, path), a->core_radius + b->core_radius + RADII(a, b) + path->margin) ||
      passing(FRAME_OF(a, b), MOVE(a, b, path), RADII(a, b) + path->margin);
    ensures inside: \result == GJK_OK && result->hit != 0 && result->inside != 0 ==>
      TOGETHER(a, b, RADIUS(RADII(a, b) + path->margin));
    ensures enters: \result == GJK_OK && result->hit != 0 && result->inside == 0 && RADII(a, b) + path->margin == 0 ==>
      entering(FRAME_OF(a, b), MOVE(a, b, path), result->fraction); */
gjk_status gjk2_check_cast(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                           const gjk2_cast_result *result);

#endif
