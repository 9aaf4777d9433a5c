// The time of impact in the plane: conservative advancement with bounds along one direction.
//
//   1. Pose both shapes at the fraction, and measure their distance.
//   2. Stop if it is less than margin + tolerance: a hit.
//   3. The room is what it exceeds the margin by, less all that rounding may have added to it.
//   4. Bound by how much of the room each fraction of the way takes along the normal u, in three frames: at rest, and turning
//      with A or with B. No contact comes before the room is used up in the best of them.
//   5. Advance so far. If that is beyond the end, there is no impact.
//
// Step 4. Let P be a shape's pose origin, R bound how far its core reaches from P, and H be how far it reaches along u.
//   spare   However it turns, the core reaches R at most: its share of the room is at most R - H, and at most R phi.
//   lever   Let it turn by phi, and w be u turned by a quarter the other way. Its reach is then that along
//           cos phi u + sin phi w, which is a sum of u and v = u + T w with weights that are not below 0, if
//           tan phi <= T. A support function is sublinear, so with the support point p along v the reach is at most
//             H cos phi + (p . w) sin phi.
//           p . w is the lever. As the room shrinks so does T, and p is the touched corner with its true speed.
//   frame   u may turn with a shape whose edge is touched, by w_f h. Then that shape's reach stays, the other turns by the
//           difference of both angles, and the origins, D = P_b - P_a apart and moving by v, approach by
//           -(u . v + w_f (u' . D)), u' for u turned to the left.
//   bend    What these leave out is of second order, at most k h^2 while no angle exceeds a radian:
//             k = w^2 / 2 (|lever| / 3 + max(0, -H)) of each shape, and of the frame
//                 w_f^2 / 2 (|u . D| + |u . v| + |u' . D| / 3) + w_f |u' . v|
//           Of the way tried, at most m, |u . v| counts m times, and lever and u' . D as often as their angle.
// Room = rate h + k h^2 has both h = room / (rate + sqrt(k room)) and h = room / (rate + k room / rate) before it.
//
// Each step uses the room up to its bound, like Newton's iteration from below.
#include "gjk2/impact.h"

#include "../arith/gjk_root.h"
#include "../plane/gjk2_class.h"
#include "gjk2/distance.h"
#include "gjk2_sweep.h"
#include "gjk2_way.h"

// What may lie between the motion and what is measured of it, LSB Q8, beside the rotation's error and that of the normal:
//   vertices and half axes    3/4 sqrt(2) of each shape
//   positions                 1/2 sqrt(2) of each shape
//   the distance              1/2; of curved shapes 2 and each support point within 1 per component, instead of vertices
#define PLANE_IMPACT_ERROR 1040
#define PLANE_IMPACT_CURVED 384

// Angles from here on, in radians Q24, take no turning frame.
#define PLANE_FAST (UINT64_C(1) << 30)

typedef struct plane_mover {
  gjk2_sweep sweep;
  gjk2_pose pose;
  gjk2_collider posed;
  int64_t reach;  // R
} plane_mover;

typedef struct plane_impact {
  plane_mover a, b;
  const gjk2_impact_setup *setup;
  gjk2_distance_result gap;
  bool open;      // the gap is but bounded, and not along its normal
  int64_t error;  // LSB Q8
} plane_impact;

// The core's reach from the pose's origin, LSB.
static int64_t plane_reach_from(const gjk2_collider *c) {
  const int64_t x = gjk_magnitude32(c->local_centre.x), y = gjk_magnitude32(c->local_centre.y);
  if ((x | y) == 0) {
    return c->core_radius;
  }
  const gjk2_vec *v = c->shape->vertices;
  uint64_t most = 0;
  for (uint32_t i = 0; v != NULL && i < c->count; i++) {
    const uint64_t squared = (uint64_t)gjk_mul32(v[i].x, v[i].x) + (uint64_t)gjk_mul32(v[i].y, v[i].y);  // <= 2^63
    most = squared > most ? squared : most;
  }
  return (int64_t)gjk_isqrt64(most) + 1;
}

static gjk_status plane_mover_set(plane_mover *m, const gjk2_collider *c, const gjk2_motion *motion) {
  const gjk_status status = gjk2_sweep_set(&m->sweep, motion);
  if (status != GJK_OK) {
    return status;
  }
  m->posed.shape = c->shape;
  m->posed.buffer = NULL;
  gjk2_copy(&m->posed.local_centre, &c->local_centre);
  m->posed.core_radius = c->core_radius;
  m->posed.radius = c->radius;
  m->posed.count = c->count;
  m->posed.ordered = c->ordered;
  m->posed.state = GJK2_STATE_INITIALISED;
  m->reach = plane_reach_from(c);
  return GJK_OK;
}

static gjk_status plane_mover_pose(plane_mover *m, gjk_q30 fraction) {
  gjk2_sweep_pose(&m->sweep, fraction, &m->pose);
  return gjk2_collider_pose(&m->posed, &m->pose);
}

// Step 1. Statuses: OK, RANGE, ROTATION.
static gjk_status plane_impact_measure(plane_impact *s, gjk_q30 fraction) {
  gjk_status status = plane_mover_pose(&s->a, fraction);
  status = status == GJK_OK ? plane_mover_pose(&s->b, fraction) : status;
  if (status == GJK_OK) {
    s->open = gjk2_distance(&s->a.posed, &s->b.posed, NULL, &s->gap) != GJK_OK;
  }
  return status;
}

// u . (x, y) for a unit vector u, rounded down by less than 16. Pre: components below 2^34 in size.
static int64_t plane_unit_dot(const gjk2_unit *u, int64_t x, int64_t y) {
  return 4 * (gjk_sar64(u->x * gjk_sar64(x, 2), 30) + gjk_sar64(u->y * gjk_sar64(y, 2), 30));
}

// How far the core reaches along u, from the pose's origin, rounded down; -R where the point is not known.
static int64_t plane_mover_height(const plane_mover *m, const gjk2_unit *u, const gjk2_vec *point, bool known) {
  const int64_t x = (int64_t)point->x - m->pose.position.x, y = (int64_t)point->y - m->pose.position.y;
  const int64_t height = known ? plane_unit_dot(u, x, y) - m->posed.shape->convex_radius - 4 : -m->reach;
  return height < -m->reach ? -m->reach : height;
}

// The lever of a shape that turns against u, which leads away from its inside, by up to the angle whose tangent is
// 9/8 tangent, Q30: counterclockwise, or clockwise. Rounded up by less than 32 LSB.
static int64_t plane_lever(const plane_mover *m, const gjk2_unit *u, bool clockwise, int64_t tangent) {
  const gjk2_unit w = {clockwise ? -u->y : u->y, clockwise ? u->x : -u->x};
  const int32_t part = (int32_t)(tangent + (tangent >> 3));  // below 2^30
  const gjk2_vec v = {(u->x >> 1) + (int32_t)gjk_sar64(gjk_mul32(w.x, part), 31),
                      (u->y >> 1) + (int32_t)gjk_sar64(gjk_mul32(w.y, part), 31)};
  gjk2_support farthest;
  m->posed.shape->type->support(&m->posed, &v, &farthest);
  return plane_unit_dot(&w, (int64_t)m->posed.centre.x - m->pose.position.x + farthest.offset.x,
                        (int64_t)m->posed.centre.y - m->pose.position.y + farthest.offset.y) +
         16;
}

// angle length, rounded up, LSB. Pre: angle at most 2^40, length at most 2^32.
static int64_t plane_arc(uint64_t angle, int64_t length) {
  if (angle >> 30 == 0) {
    return (int64_t)((angle * (uint64_t)length) >> 24) + 1;
  }
  return (int64_t)((((angle >> 8) + 1) * (uint64_t)length) >> 16) + 1;
}

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

// room / rate as a fraction of the way, at most 2^-12 of itself too small; beyond the end: more than GJK_Q30_ONE.
// room: Q8, above 0; rate: LSB for the whole way, below 2^54.
//   room = 2^(32 - m) top, rate 2^8 = 2^(48 - n) bottom:   2^30 room / (2^8 rate) = top (2^31 / bottom) 2^(n - m - 17)
static int64_t plane_step(int64_t room, int64_t rate) {
  if (rate <= 0 || room >= gjk_shl64(rate, 8)) {
    return (int64_t)GJK_Q30_ONE + 1;
  }
  const uint64_t part = (uint64_t)room, whole = (uint64_t)rate << 8;
  const unsigned m = gjk_clz64(part), n = gjk_clz64(whole);  // part < whole: n <= m
  const uint64_t product = gjk_umul32((uint32_t)((part << m) >> 32), plane_reciprocal((uint32_t)((whole << n) >> 48)));
  const unsigned down = 17 + m - n;
  const int64_t step = down < 64 ? (int64_t)(product >> down) : 0;
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
static int64_t plane_step_at_rest(const plane_mover *a, const plane_mover *b, const plane_rates *r) {
  const int64_t arc_a = a->sweep.angle != 0 ? plane_arc(a->sweep.angle, a->reach) : 0;
  const int64_t arc_b = b->sweep.angle != 0 ? plane_arc(b->sweep.angle, b->reach) : 0;
  int64_t best = plane_step(r->room, r->closing + arc_a + arc_b);
  for (unsigned capped = 1; capped < 4 && best <= GJK_Q30_ONE; capped++) {
    const bool of_a = (capped & 1u) != 0, of_b = (capped & 2u) != 0;
    const int64_t spare = (of_a ? a->reach - r->height_a + 8 : 0) + (of_b ? b->reach - r->height_b + 8 : 0);
    const int64_t rest = r->room - gjk_shl64(spare, 8);
    if (rest > 0) {
      const int64_t step = plane_step(rest, r->closing + (of_a ? 0 : arc_a) + (of_b ? 0 : arc_b));
      best = step > best ? step : best;
    }
  }
  return best;
}

// Signed angle of the whole way, Q24.
static int64_t plane_signed_angle(const plane_mover *m) {
  return m->sweep.clockwise ? -(int64_t)m->sweep.angle : (int64_t)m->sweep.angle;
}

// angle lever, LSB, rounded up. The angle is up to 2 units too large. Pre: angle < 2^31 + 3.
static int64_t plane_turn_rate(uint64_t angle, int64_t lever) {
  if (lever >= 0) {
    return plane_arc(angle, lever);
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
static void plane_add_turn(const plane_mover *m, const gjk2_unit *u, int64_t angle, int64_t height, int64_t tangent,
                           int64_t *rate, uint64_t *bend) {
  if (angle != 0) {
    const uint64_t size = gjk_magnitude64(angle);
    const int64_t lever = plane_lever(m, u, angle < 0, tangent);
    *rate += plane_turn_rate(size, lever);
    *bend += plane_bend(size, (uint64_t)(height < 0 ? -height : 0) + plane_third(lever < 0 ? -lever : 0, tangent));
  }
}

// Step 4 with levers, in the frame of the shape that has the touched edge.
static int64_t plane_step_turning(const plane_mover *a, const plane_mover *b, const gjk2_certificate *c,
                                  const plane_rates *r) {
  const int64_t angle_a = plane_signed_angle(a), angle_b = plane_signed_angle(b);
  const uint64_t sum = a->sweep.angle + b->sweep.angle + 2;
  if (sum >= PLANE_FAST) {
    return 0;
  }
  // Try twice the way that a quarter of both reaches as levers would take, and at most half a radian.
  const int64_t likely = (r->closing > 0 ? r->closing : 0) + plane_arc(a->sweep.angle, a->reach) / 4 +
                         plane_arc(b->sweep.angle, b->reach) / 4;
  const int64_t half = plane_step(INT64_C(1) << 23, (int64_t)(sum >> 8) + 1), twice = 2 * plane_step(r->room, likely);
  const int64_t least = twice < half ? twice : half, most = least < GJK_Q30_ONE ? least : (int64_t)GJK_Q30_ONE + 1;
  const int64_t tangent = gjk_sar64((int64_t)sum * (most < GJK_Q30_ONE ? most : GJK_Q30_ONE), 24);  // below 2^53, 2^29
  // The frame's angle: that of A where the edge is A's, of B where it is B's.
  const bool edge = c->proof == GJK2_PROOF_NEAREST && c->count == 2;
  const int64_t frame = edge && c->a[0] != c->a[1] && angle_a != 0   ? angle_a
                        : edge && c->b[0] != c->b[1] && angle_b != 0 ? angle_b
                                                                     : 0;
  int64_t rate = r->closing;
  uint64_t bend = 1;
  plane_add_turn(a, &r->u, angle_a - frame, r->height_a, tangent, &rate, &bend);
  plane_add_turn(b, &r->opposite, angle_b - frame, r->height_b, tangent, &rate, &bend);
  if (frame != 0) {
    const gjk2_unit left = {-r->u.y, r->u.x};
    const int64_t dx = (int64_t)b->pose.position.x - a->pose.position.x,
                  dy = (int64_t)b->pose.position.y - a->pose.position.y;
    const int64_t along = plane_unit_dot(&r->u, dx, dy), beside = plane_unit_dot(&left, dx, dy);
    const uint64_t size = gjk_magnitude64(frame);
    const int64_t moved = plane_unit_dot(&left, r->x, r->y), closer = frame < 0 ? moved : -moved;
    // |frame| < 2^30, |beside| < 2^32.6:  below 2^63. Products round by less than 16 LSB, angles by an LSB.
    rate += plane_arc(size, 16) - gjk_sar64(beside * frame, 24) + (int64_t)(gjk_magnitude64(beside) >> 24) + 2;
    bend += plane_bend(size, (uint64_t)(along > 0 ? along : 0) +
                                 2 * plane_third((int64_t)gjk_magnitude64(r->closing), most) +
                                 plane_third((int64_t)gjk_magnitude64(beside), tangent) + 64) +
            (uint64_t)plane_arc(size, (closer > 0 ? closer : 0) + 16);
  }
  if (gjk_clz64(bend) + gjk_clz64((uint64_t)r->room) < 65) {
    return 0;
  }
  // sqrt(room bend) in LSB: room is Q8, and its root Q4.
  const int64_t root = (int64_t)(gjk_isqrt64(bend * (uint64_t)r->room) >> 4) + 1;
  int64_t more = root;
  if (root < rate) {  // k room / rate = root (root / rate)
    const int64_t part = plane_step(gjk_shl64(root, 8), rate);
    more = gjk_sar64(root * (part + (part >> 11) + 2), 30) + 1;  // root < 2^36, part <= 2^30
  }
  const int64_t step = plane_step(r->room, (rate > 0 ? rate : 0) + more);
  return step < most ? step : most;
}

// Steps 3 and 4: for how much more of the way the shapes are proven apart; 0: not at all.
static int64_t plane_impact_advance(const plane_impact *s) {
  const gjk2_distance_result *gap = &s->gap;
  const int64_t distance = gap->lower;
  const plane_mover *a = &s->a, *b = &s->b;
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
    return plane_step(r.room, r.closing);
  }
  r.opposite.x = -r.u.x;
  r.opposite.y = -r.u.y;
  r.height_a = plane_mover_height(a, &r.u, &gap->point_a, !gap->saturated);
  r.height_b = plane_mover_height(b, &r.opposite, &gap->point_b, !gap->saturated);
  const int64_t step = plane_step_turning(a, b, &gap->certificate, &r), room = r.room >> 8;
  if (step != 0 && room < a->reach - r.height_a && room < b->reach - r.height_b) {
    return step;
  }
  const int64_t best = plane_step_at_rest(a, b, &r);
  return step > best ? step : best;
}

// Is the gap at most the margin?
static bool plane_is_at_margin(const plane_impact *s) {
  const gjk_q16 margin = s->setup->margin;
  return s->gap.intersecting || (margin > 0 && s->gap.lower <= margin);
}

static void plane_impact_report(const plane_impact *s, gjk_q30 lower, gjk_q30 upper, gjk2_impact_result *out) {
  out->hit = true;
  out->overlap = upper == 0 && plane_is_at_margin(s);
  out->lower = lower;
  out->upper = upper;
  out->distance = s->gap.distance;
  if (!s->gap.intersecting) {
    gjk2_copy(&out->point_a, &s->gap.point_a);
    gjk2_copy(&out->point_b, &s->gap.point_b);
    out->normal.x = s->gap.normal.x;
    out->normal.y = s->gap.normal.y;
  }
}

static void plane_impact_end(const plane_impact *s, gjk_q30 lower, uint32_t iterations, gjk2_impact_result *out) {
  gjk2_sweep_pose(&s->a.sweep, lower, &out->pose_a);
  gjk2_sweep_pose(&s->b.sweep, lower, &out->pose_b);
  out->iterations = (uint8_t)iterations;
}

static void plane_impact_none(gjk_q30 lower, gjk2_impact_result *out) {
  out->hit = false;
  out->overlap = false;
  out->lower = lower;
  out->upper = GJK_Q30_ONE;
}

// Steps 1 to 5. Pre: the motions are set.
static gjk_status plane_impact_run(plane_impact *s, gjk2_impact_result *out) {
  const uint32_t most = s->setup->iterations != 0 ? s->setup->iterations : GJK_ITERATIONS_MAX;
  gjk_q30 lower = 0, at = 0;
  gjk_status result = GJK_ERROR_ITERATION_LIMIT;
  uint32_t i = 0;
  while (i < most) {
    const gjk_status status = plane_impact_measure(s, at);
    if (status != GJK_OK) {
      return status;
    }
    i++;
    if (s->gap.intersecting || s->gap.upper < (int64_t)s->setup->margin + s->setup->tolerance) {  // Step 2
      lower = plane_is_at_margin(s) ? lower : at;
      plane_impact_report(s, lower, at, out);
      plane_impact_end(s, lower, i, out);
      return GJK_OK;
    }
    lower = s->open && s->gap.lower <= s->setup->margin ? lower : at;
    if (s->open) {
      break;
    }
    const int64_t step = at == GJK_Q30_ONE ? 1 : plane_impact_advance(s);
    if (step > GJK_Q30_ONE - at) {  // Step 5
      lower = GJK_Q30_ONE;
      result = GJK_OK;
      break;
    }
    if (step == 0) {
      break;
    }
    at += (gjk_q30)step;
  }
  plane_impact_none(lower, out);
  plane_impact_end(s, lower, i, out);
  return result;
}

static bool plane_is_known(const gjk2_collider *c) {
  return c->state == GJK2_STATE_INITIALISED || c->state == GJK2_STATE_POSED;
}

static gjk_status plane_impact_check(const gjk2_collider *a, const gjk2_collider *b, const gjk2_impact_setup *setup) {
  if (!plane_is_known(a) || !plane_is_known(b)) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return setup->tolerance < GJK2_IMPACT_TOLERANCE_MIN ? GJK_ERROR_RANGE : GJK_OK;
}

gjk_status gjk2_time_of_impact(const gjk2_collider *a, const gjk2_motion *motion_a, const gjk2_collider *b,
                               const gjk2_motion *motion_b, const gjk2_impact_setup *setup, gjk2_impact_result *out) {
  plane_impact s;
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = plane_impact_check(a, b, setup);
  status = status == GJK_OK ? plane_mover_set(&s.a, a, motion_a) : status;
  status = status == GJK_OK ? plane_mover_set(&s.b, b, motion_b) : status;
  if (status != GJK_OK) {
    return status;
  }
  s.setup = setup;
  s.error = PLANE_IMPACT_ERROR + ((s.a.reach + s.b.reach) * 11 >> 23) +
            ((int64_t)(a->core_radius + b->core_radius) * 3 >> 23);
  s.error += gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape) ? PLANE_IMPACT_CURVED : 0;
  return plane_impact_run(&s, out);
}
