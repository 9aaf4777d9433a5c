// Poses along a motion of the plane.
//
// Angles are parts of a turn in units of 2^-64, so that whole turns drop out of themselves. That of an arc is found from
// the rotation between its ends:
//   1. Reduce it to an eighth of a turn: r = lesser / greater component.
//   2. r (pi / 4 + (1 - r) (0.2447 + 0.0663 r)) is the angle within 0.0015.
//   3. Add the sine of what is left, by its cross product with the angle's own sine and cosine. An error e becomes e^3 / 6,
//      0.6 LSB of Q2.30. Rounding of sine, cosine and what is between the ends leaves 2.6 more.
#include "gjk2_sweep.h"

#include "../arith/gjk_sine.h"
#include "../plane/gjk2_rotation.h"
#include "gjk2_way.h"

// What 1 LSB of an angle times 2^-30 is in units of 2^-96 turns: 2^50 / (2 pi).
#define PLANE_TURNS (GJK_HALF_TURNS_HIGH * 8 + (GJK_HALF_TURNS_LOW >> 29))

// 2^34 / (2 pi): a radian Q30 in units of 2^-64 turns.
#define PLANE_RADIAN INT64_C(2734261103)

// 2 pi, Q24.
#define PLANE_TURN UINT32_C(105414357)

#define PLANE_EIGHTH INT32_C(843314857)    // pi / 4, Q30
#define PLANE_BEND INT32_C(262744626)      // 0.2447, Q30
#define PLANE_BEND_MORE INT32_C(71189083)  // 0.0663, Q30

// Step 2. Pre: 0 <= lesser <= greater, 0 < greater.
static uint64_t plane_coarse_turn(uint32_t lesser, uint32_t greater) {
  bool exact;
  const gjk_q30 r = gjk2_ratio(lesser, greater, &exact);
  const int32_t bend = PLANE_BEND + (int32_t)gjk_sar64(gjk_mul32(PLANE_BEND_MORE, r), 30);
  const int32_t slope = PLANE_EIGHTH + (int32_t)gjk_sar64(gjk_mul32(bend, GJK_Q30_ONE - r), 30);
  return (uint64_t)(gjk_sar64(gjk_mul32(r, slope), 30) * PLANE_RADIAN);  // below 2^30 2^32
}

// The angle of c + i s, 0 <= s, from 0 to half a turn. Pre: a unit.
static uint64_t plane_turn_of(gjk_q30 c, gjk_q30 s) {
  const uint64_t quarter = UINT64_C(1) << 62;
  const uint32_t x = gjk_magnitude32(c), y = gjk_magnitude32(s);
  uint64_t turn = y <= x ? plane_coarse_turn(y, x) : quarter - plane_coarse_turn(x, y);
  turn = c < 0 ? 2 * quarter - turn : turn;
  gjk_q30 sine, cosine;  // Step 3
  gjk_sine_cosine(1, turn, &sine, &cosine);
  const int64_t rest = gjk_sar64(gjk_mul32(s, cosine) - gjk_mul32(c, sine) + (INT64_C(1) << 29), 30);
  return turn + (uint64_t)(rest * PLANE_RADIAN);  // |rest| < 2^23
}

// Spins and arcs are the same from here on: an angle's size as a rate.
static void plane_sweep_arc(gjk2_sweep *sweep, const gjk2_rotation *between) {
  const bool clockwise = between->s < 0;
  uint64_t turn = plane_turn_of(between->c, clockwise ? -between->s : between->s);
  if (turn >> 63 != 0 && (turn & ~(UINT64_C(1) << 63)) != 0) {
    turn = turn >> 62 == 3 ? 0 : UINT64_C(1) << 63;  // below 0, or above a half, by an error of the last step
  }
  sweep->clockwise = clockwise;
  sweep->rate_high = turn >> 30;
  sweep->rate_low = (uint32_t)(turn & 0x3FFFFFFFu) << 2;
  sweep->angle = (gjk_umul32((uint32_t)(turn >> 32), PLANE_TURN) >> 32) + 1;
}

static void plane_sweep_spin(gjk2_sweep *sweep, gjk_angle spin) {
  const uint32_t size = gjk_magnitude32(spin);
  const uint64_t low = gjk_umul32(size, (uint32_t)(PLANE_TURNS & UINT32_MAX));
  sweep->clockwise = spin < 0;
  sweep->rate_high = gjk_umul32(size, (uint32_t)(PLANE_TURNS >> 32)) + (low >> 32);
  sweep->rate_low = (uint32_t)(low & UINT32_MAX);
  sweep->angle = (uint64_t)size << 8;
}

gjk_status gjk2_sweep_set(gjk2_sweep *sweep, const gjk2_motion *motion) {
  const gjk2_rotation *from = &motion->from.rotation, *to = &motion->to.rotation;
  if (!gjk2_rotation_deviation(&motion->from.rotation, &sweep->deviation)) {
    return GJK_ERROR_ROTATION;
  }
  sweep->motion = motion;
  sweep->x = (int64_t)motion->to.position.x - motion->from.position.x;
  sweep->y = (int64_t)motion->to.position.y - motion->from.position.y;
  if (motion->spin != 0) {
    plane_sweep_spin(sweep, motion->spin);
    return GJK_OK;
  }
  int64_t deviation;
  if (!gjk2_rotation_deviation(to, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk2_rotation back = {from->c, -from->s};  // as long as from
  gjk2_rotation between;
  gjk2_rotation_product(&back, sweep->deviation, to, deviation, &between);
  if (between.s == 0 && between.c > 0) {
    sweep->rate_high = 0;
    sweep->rate_low = 0;
    sweep->angle = 0;
    sweep->clockwise = false;
  } else {
    plane_sweep_arc(sweep, &between);
  }
  return GJK_OK;
}

static gjk_q16 plane_sweep_at(gjk_q16 from, int64_t way, gjk_q30 fraction) {
  return (gjk_q16)(from + gjk_sar64(way * fraction + (INT64_C(1) << 29), 30));
}

void gjk2_sweep_place(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_vec *out) {
  const gjk2_vec *from = &sweep->motion->from.position;
  out->x = plane_sweep_at(from->x, sweep->x, fraction);
  out->y = plane_sweep_at(from->y, sweep->y, fraction);
}

void gjk2_sweep_pose(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_pose *out) {
  const gjk2_motion *motion = sweep->motion;
  const gjk2_rotation *rotation = &motion->from.rotation;
  gjk2_sweep_place(sweep, fraction, &out->position);
  if (fraction == GJK_Q30_ONE && motion->spin == 0) {
    rotation = &motion->to.rotation;
  } else if (fraction != 0 && sweep->angle != 0) {
    gjk2_rotation turned;
    const uint64_t turn =
        sweep->rate_high * (uint32_t)fraction + (gjk_umul32(sweep->rate_low, (uint32_t)fraction) >> 32);
    gjk_sine_cosine(sweep->clockwise ? -1 : 1, turn, &turned.s, &turned.c);
    int64_t deviation = 0;
    (void)gjk2_rotation_deviation(&turned, &deviation);  // sine and cosine are within an LSB
    gjk2_rotation_product(rotation, sweep->deviation, &turned, deviation, &out->rotation);
    return;
  }
  out->rotation.c = rotation->c;
  out->rotation.s = rotation->s;
}

gjk_status gjk2_motion_pose(const gjk2_motion *motion, gjk_q30 fraction, gjk2_pose *out) {
  gjk2_sweep sweep;
  if (motion == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (fraction < 0 || fraction > GJK_Q30_ONE) {
    return GJK_ERROR_RANGE;
  }
  const gjk_status status = gjk2_sweep_set(&sweep, motion);
  if (status == GJK_OK) {
    gjk2_sweep_pose(&sweep, fraction, out);
  }
  return status;
}
