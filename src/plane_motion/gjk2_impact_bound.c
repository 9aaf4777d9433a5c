// How far shapes on their motions stay apart, bounded along the normal u at a fraction of the way, in three frames: at rest,
// and turning with A or with B. The best of them counts.
//
// Let P be a shape's pose origin, R bound how far its core reaches from P, and H be how far it reaches along u.
//   spare   However it turns, the core reaches R at most: its share of the room is at most R - H, and at most R phi.
//   lever   Let it turn by phi, and w be u turned by a quarter the other way. Its reach is then that along
//           cos phi u + sin phi w. If tan phi <= T, this is a sum of u and v = u + T w, with no weight below 0.
//           A support function is sublinear, so with the support point p along v the reach is at most
//             H cos phi + (p . w) sin phi.
//           p . w is the lever. As the room shrinks so does T, and p is the touched corner with its true speed.
//   frame   u may turn with a shape whose edge is touched, by w_f h. Then that shape's reach stays, and the other turns by
//           the difference of both angles. Let the origins be D = P_b - P_a apart and move by v, and u' be u turned to
//           the left. They approach by -(u . v + w_f (u' . D)).
//   bend    What these leave out is of second order, at most k h^2 while no angle exceeds a radian:
//             k = w^2 / 2 (|lever| / 3 + max(0, -H)) of each shape, and of the frame
//                 w_f^2 / 2 (|u . D| + |u . v| + |u' . D| / 3) + w_f |u' . v|
//           Of the way tried, at most m, |u . v| counts m times, and lever and u' . D as often as their angle.
// Room = rate h + k h^2 has both h = room / (rate + sqrt(k room)) and h = room / (rate + k room / rate) before it.
#include "../arith/gjk_root.h"
#include "gjk2_impact.h"

// Angles from here on, in radians Q24, take no turning frame.
#define PLANE_FAST (UINT64_C(1) << 30)

// u . (x, y) for a unit vector u, rounded down by less than 16. Pre: components below 2^34 in size.
static int64_t plane_unit_dot(const gjk2_unit *u, int64_t x, int64_t y) {
  const uint64_t most = UINT64_C(1) << 30;
  if (((uint64_t)x + most) >> 31 == 0 && ((uint64_t)y + most) >> 31 == 0) {
    return gjk_sar64(gjk_mac32(gjk_mul32(u->x, (int32_t)x), u->y, (int32_t)y), 30);
  }
  return 4 * (gjk_sar64(u->x * gjk_sar64(x, 2), 30) + gjk_sar64(u->y * gjk_sar64(y, 2), 30));
}

// u . p for a vertex p of the core, from the pose's origin.
static int64_t plane_mover_along(const gjk2_mover *m, const gjk2_unit *u, const gjk2_vec *offset) {
  return plane_unit_dot(u, (int64_t)m->posed.centre.x - m->pose.position.x + offset->x,
                        (int64_t)m->posed.centre.y - m->pose.position.y + offset->y);
}

// How far the core reaches along u, from the pose's origin, rounded down; -R where that is not known. nearest: a vertex
// that is farthest along u, or NULL; then point is, where known is true.
static int64_t plane_mover_height(const gjk2_mover *m, const gjk2_unit *u, const gjk2_support *nearest,
                                  const gjk2_vec *point, bool known) {
  int64_t height = -m->reach;
  if (nearest != NULL) {
    height = plane_mover_along(m, u, &nearest->offset) - 4;
  } else if (known) {
    height = plane_unit_dot(u, (int64_t)point->x - m->pose.position.x, (int64_t)point->y - m->pose.position.y) -
             m->posed.shape->convex_radius - 4;
  }
  return height < -m->reach ? -m->reach : height;
}

// The lever of a shape that turns against u, which leads away from its inside, by up to the angle whose tangent is
// 9/8 tangent, Q30: counterclockwise, or clockwise. Rounded up by less than 32 LSB. nearest: a vertex that is farthest
// along u, or NULL.
static int64_t plane_lever(const gjk2_mover *m, const gjk2_unit *u, bool clockwise, int64_t tangent,
                           const gjk2_support *nearest) {
  const gjk2_collider *c = &m->posed;
  const gjk2_unit w = {clockwise ? -u->y : u->y, clockwise ? u->x : -u->x};
  const int32_t part = (int32_t)(tangent + (tangent >> 3));  // below 2^30
  const gjk2_vec v = {(u->x >> 1) + (int32_t)gjk_sar64(gjk_mul32(w.x, part), 31),
                      (u->y >> 1) + (int32_t)gjk_sar64(gjk_mul32(w.y, part), 31)};
  gjk2_support farthest;
  if (nearest != NULL && c->ordered) {  // few edges lie between both directions
    gjk2_support way;
    gjk2_copy_support(&farthest, nearest);
    for (uint32_t i = 0; i < c->count; i++) {
      c->shape->type->adjacent(c, &farthest, clockwise, &way);
      if (gjk2_dot(way.offset, v) <= 0) {
        break;
      }
      gjk2_follow(&farthest, &way);
    }
  } else {
    c->shape->type->support(c, &v, &farthest);
  }
  return plane_mover_along(m, &w, &farthest.offset) + 16;
}

// What that is for a point, which lies at its origin.
#define PLANE_POINT_LEVER 16

// 2^31 / x, within 2^-14 of itself, for 2^15 <= x < 2^16 by Newton's iteration, with u = x / 2^16 and Y = y / 2^15:
// from the line Y = 48/17 - 32/17 u, within 1/17 of 1 / u, twice Y += Y (1 - u Y).
static uint32_t plane_reciprocal(uint32_t x) {
  uint32_t y = UINT32_C(92521) - (x * UINT32_C(61681) >> 16);
  for (int i = 0; i < 2; i++) {
    const int32_t rest = INT32_C(65536) - (int32_t)(x * y >> 15);  // |rest| < 2^12
    y = (uint32_t)((int32_t)y + gjk_sar32((int32_t)y * rest, 16));
  }
  return y;
}

//   room = 2^(32 - m) top, rate 2^8 = 2^(48 - n) bottom:   2^30 room / (2^8 rate) = top (2^31 / bottom) 2^(n - m - 17)
int64_t gjk2_impact_step(int64_t room, int64_t rate) {
  if (rate <= 0 || room >= gjk_shl64(rate, 8)) {
    return (int64_t)GJK_Q30_ONE + 1;
  }
  const uint64_t part = (uint64_t)room, whole = (uint64_t)rate << 8;
  const unsigned m = gjk_clz64(part), n = gjk_clz64(whole);  // part < whole: n <= m
  // top < 2^32, and the reciprocal is at most 2^16: below 2^31 after the shift
  const uint32_t quotient =
      (uint32_t)(gjk_umul32(gjk_upper32(part, m), plane_reciprocal(gjk_upper32(whole, n) >> 16)) >> 17);
  const int32_t step = m - n < 32 ? (int32_t)(quotient >> (m - n)) : 0;
  return step - (step >> 12) - (step != 0);
}

// What the motion does to the room along u.
typedef struct plane_rates {
  gjk2_unit u, opposite;
  int64_t room;                // LSB Q8
  int64_t closing;             // by which the origins approach, for the whole way, LSB
  int64_t height_a, height_b;  // H of both
  int64_t x, y;                // the change of the way from A's origin to B's
} plane_rates;

// Step 4 without levers. Each shape's share of the room is bounded by its arc and by what it has to spare.
static int64_t plane_step_at_rest(const gjk2_mover *a, const gjk2_mover *b, const plane_rates *r) {
  int64_t best = gjk2_impact_step(r->room, r->closing + a->arc + b->arc);
  for (unsigned capped = 1; capped < 4 && best <= GJK_Q30_ONE; capped++) {
    const bool of_a = (capped & 1u) != 0, of_b = (capped & 2u) != 0;
    const int64_t spare = (of_a ? a->reach - r->height_a + 8 : 0) + (of_b ? b->reach - r->height_b + 8 : 0);
    const int64_t rest = r->room - gjk_shl64(spare, 8);
    if (rest > 0) {
      const int64_t step = gjk2_impact_step(rest, r->closing + (of_a ? 0 : a->arc) + (of_b ? 0 : b->arc));
      best = step > best ? step : best;
    }
  }
  return best;
}

// Signed angle of the whole way, Q24.
static int64_t plane_signed_angle(const gjk2_mover *m) {
  return m->sweep.clockwise ? -(int64_t)m->sweep.angle : (int64_t)m->sweep.angle;
}

// angle lever, LSB, rounded up. The angle is up to 2 units too large. Pre: angle < 2^31 + 3.
static int64_t plane_turn_rate(uint64_t angle, int64_t lever) {
  if (lever >= 0) {
    return gjk2_impact_arc(angle, lever);
  }
  return angle < 3 ? 0 : -(int64_t)(((angle - 2) * (uint64_t)-lever) >> 24);
}

// angle^2 length / 2, rounded up. Pre: angle < 2^31 + 3, length < 2^34.
static uint64_t plane_bend(uint64_t angle, uint64_t length) {
  const uint64_t square = (gjk_umul32((uint32_t)angle, (uint32_t)angle) >> 33) + 1;  // Q15, at most 2^29 + 1
  return ((square * ((length >> 3) + 1)) >> 12) + 1;
}

// length tangent / 3, rounded up. Pre: 0 <= length < 2^34, 0 <= tangent <= 2^29.
static uint64_t plane_third(int64_t length, int64_t tangent) {
  return ((uint64_t)length * (uint64_t)tangent >> 31) + 1;
}

// What a shape that turns by angle against u adds to the rate and, of second order, to the bend. angle: Q24, signed.
static void plane_add_turn(const gjk2_mover *m, const gjk2_unit *u, const gjk2_support *nearest, int64_t angle,
                           int64_t height, int64_t tangent, int64_t *rate, uint64_t *bend) {
  if (angle != 0) {
    const uint64_t size = gjk_magnitude64(angle);
    const int64_t lever = gjk2_impact_is_point(m) ? PLANE_POINT_LEVER : plane_lever(m, u, angle < 0, tangent, nearest);
    *rate += plane_turn_rate(size, lever);
    *bend += plane_bend(size, (uint64_t)(height < 0 ? -height : 0) + plane_third(lever < 0 ? -lever : 0, tangent));
  }
}

// Step 4 with levers, in the frame of the shape that has the touched edge. p, q: the nearest feature, of one vertex twice,
// or NULL.
static int64_t plane_step_turning(const gjk2_impact *s, const gjk2_vertex *p, const gjk2_vertex *q,
                                  const plane_rates *r) {
  const gjk2_mover *a = &s->a, *b = &s->b;
  const int64_t angle_a = plane_signed_angle(a), angle_b = plane_signed_angle(b);
  const uint64_t sum = a->sweep.angle + b->sweep.angle + 2;
  if (sum >= PLANE_FAST) {
    return 0;
  }
  // Try 3/2 of the way that a quarter of both reaches as levers would take, and at most half a radian.
  const int64_t likely = gjk2_impact_step(r->room, (r->closing > 0 ? r->closing : 0) + (a->arc + b->arc) / 4);
  const int64_t more_likely = likely + likely / 2, least = more_likely < s->half ? more_likely : s->half,
                most = least < GJK_Q30_ONE ? least : (int64_t)GJK_Q30_ONE + 1;
  const int64_t tangent = gjk_sar64((int64_t)sum * (most < GJK_Q30_ONE ? most : GJK_Q30_ONE), 24);  // below 2^53, 2^29
  // The frame's angle: that of A where the edge is A's, of B where it is B's. Places are compared: of vertices at one place
  // any may be named.
  int64_t frame = 0;
  if (p != q) {
    frame = !gjk2_equal(p->a.offset, q->a.offset) ? angle_a : 0;
    frame = frame == 0 && !gjk2_equal(p->b.offset, q->b.offset) ? angle_b : frame;
  }
  int64_t rate = r->closing;
  uint64_t bend = 1;
  plane_add_turn(a, &r->u, p != NULL ? &p->a : NULL, angle_a - frame, r->height_a, tangent, &rate, &bend);
  plane_add_turn(b, &r->opposite, p != NULL ? &p->b : NULL, angle_b - frame, r->height_b, tangent, &rate, &bend);
  if (frame != 0) {
    const gjk2_unit left = {-r->u.y, r->u.x};
    const int64_t dx = (int64_t)b->pose.position.x - a->pose.position.x,
                  dy = (int64_t)b->pose.position.y - a->pose.position.y;
    const int64_t along = plane_unit_dot(&r->u, dx, dy), beside = plane_unit_dot(&left, dx, dy);
    const uint64_t size = gjk_magnitude64(frame);
    const int64_t moved = plane_unit_dot(&left, r->x, r->y), closer = frame < 0 ? moved : -moved;
    // |frame| < 2^30, |beside| < 2^32.6:  below 2^63. Products round by less than 16 LSB, angles by an LSB.
    rate += gjk2_impact_arc(size, 16) - gjk_sar64(beside * frame, 24) + (int64_t)(gjk_magnitude64(beside) >> 24) + 2;
    bend += plane_bend(size, (uint64_t)(along > 0 ? along : 0) +
                                 2 * plane_third((int64_t)gjk_magnitude64(r->closing), most) +
                                 plane_third((int64_t)gjk_magnitude64(beside), tangent) + 64) +
            (uint64_t)gjk2_impact_arc(size, (closer > 0 ? closer : 0) + 16);
  }
  const int64_t first = gjk2_impact_step(r->room, rate);  // room / rate
  uint64_t more = UINT64_MAX;
  if (first <= GJK_Q30_ONE && bend >> 32 == 0) {
    more = (bend * (uint64_t)(first + (first >> 11) + 2) >> 30) + 1;  // k room / rate
  }
  if (rate <= 0 || more > (uint64_t)rate) {  // sqrt(k room) is less; room is Q8, and its root Q4
    if (gjk_clz64(bend) + gjk_clz64((uint64_t)r->room) < 65) {
      return 0;
    }
    more = (gjk_isqrt64(bend * (uint64_t)r->room) >> 4) + UINT64_C(1);
  }
  const int64_t step = gjk2_impact_step(r->room, (rate > 0 ? rate : 0) + (int64_t)more);
  return step < most ? step : most;
}

int64_t gjk2_impact_advance(const gjk2_impact *s) {
  const gjk2_distance_result *gap = &s->gap;
  const int64_t distance = gap->lower;
  const gjk2_mover *a = &s->a, *b = &s->b;
  plane_rates r;
  r.room = gjk_shl64(distance - s->setup->margin, 8) - s->error - (distance >> 19);
  if (r.room <= 0) {
    return 0;
  }
  r.u.x = gap->normal.x;
  r.u.y = gap->normal.y;
  r.x = b->sweep.x - a->sweep.x;
  r.y = b->sweep.y - a->sweep.y;
  r.closing = -plane_unit_dot(&r.u, r.x, r.y);
  if ((a->sweep.angle | b->sweep.angle) == 0) {
    return gjk2_impact_step(r.room, r.closing);
  }
  r.opposite.x = -r.u.x;
  r.opposite.y = -r.u.y;
  const gjk2_vertex *p = NULL, *q = NULL;
  if (s->nearest) {
    p = gjk2_search_vertex(&s->search, 0);
    q = gjk2_search_vertex(&s->search, s->search.count - 1u);
  }
  r.height_a = plane_mover_height(a, &r.u, p != NULL ? &p->a : NULL, &gap->point_a, !gap->saturated);
  r.height_b = plane_mover_height(b, &r.opposite, p != NULL ? &p->b : NULL, &gap->point_b, !gap->saturated);
  const int64_t step = plane_step_turning(s, p, q, &r), room = r.room >> 8;
  if (step != 0 && room < a->reach - r.height_a && room < b->reach - r.height_b) {
    return step;
  }
  const int64_t best = plane_step_at_rest(a, b, &r);
  return step > best ? step : best;
}
