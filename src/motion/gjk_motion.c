// Poses on the way of a motion.
//
//   1. The axis, and half of the angle over the whole way, in units of 2^-48 turns: of a spin by its length, of an arc
//      from the quaternion to from^-1.
//   2. At a fraction f: f times half of the angle; its sine and cosine make the quaternion of what is turned by then.
//   3. The rotation is that quaternion times from. The position is rounded to the nearest LSB.
#include "gjk_motion.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "../arith/gjk_sine.h"

// 2^64 2 / pi.
#define TWO_OVER_PI_HIGH UINT32_C(0xA2F9836E)
#define TWO_OVER_PI_LOW UINT32_C(0x4E44152A)

// 2^34 / (2 pi): an angle in Q30 times this is a part of a turn in units of 2^-64, to 2^-32 of itself.
#define TURNS_PER_RADIAN UINT32_C(2734261102)

// pi / 4, sqrt(1/2) and 1/6 in Q30.
#define EIGHTH_Q30 INT32_C(843314857)
#define DIAGONAL_Q30 INT32_C(759250125)
#define SIXTH_Q30 INT32_C(178956971)

// a b to the nearest Q30. Pre: the result fits.
static int32_t times_q30(int32_t a, int32_t b) {
  return (int32_t)gjk_sar64(gjk_mul32(a, b) + (INT64_C(1) << 29), 30);
}

// floor(a b / 2^64), at most 2 too small.
static uint64_t high_product(uint64_t a, uint32_t b_high, uint32_t b_low) {
  const uint32_t a_high = (uint32_t)(a >> 32), a_low = (uint32_t)(a & UINT32_MAX);
  return gjk_umul32(a_high, b_high) + gjk_umulh32(a_high, b_low) + gjk_umulh32(a_low, b_high);
}

// Step 1 of a spin: |spin| / (4 pi).
static uint64_t half_turns_of_spin(const gjk_vec3 *spin) {
  const uint32_t x = gjk_magnitude32(spin->x), y = gjk_magnitude32(spin->y), z = gjk_magnitude32(spin->z);
  const unsigned zeros = gjk_clz32(x | y | z), up = zeros > 0 ? zeros - 1 : 0;
  const uint32_t sx = x << up, sy = y << up, sz = z << up;  // each at most 2^31, one at least 2^30
  const uint64_t squared = gjk_umul32(sx, sx) + gjk_umul32(sy, sy) + gjk_umul32(sz, sz);  // 2^60 to 3 2^62
  const uint32_t root = gjk_isqrt64(squared);
  // sqrt(squared) = root + rest / (2 root) less at most 1/2 (rest / (2 root))^2 / root < 2^-31
  const uint64_t rest = squared - gjk_umul32(root, root);  // at most 2 root < 2^33
  const unsigned k = gjk_clz32(root);                      // 0 or 1
  const uint32_t reciprocal_root = gjk_reciprocal_root(root << k);
  // 2^62 / (root 2^k) within 2^-28 of itself, below 2^32
  const uint32_t reciprocal = (uint32_t)(gjk_umul32(reciprocal_root, reciprocal_root) >> 30);
  // 2^32 rest / (2 root) = rest 2^31 2^k reciprocal / 2^62
  const uint64_t fraction = gjk_umul32((uint32_t)(rest >> 2), reciprocal) >> (29 - k);
  // The length of spin in units of 2^-(48 + up) radians, below 2^64, to 2^-58 of itself.
  const uint64_t length = ((uint64_t)root << 32) + (fraction <= UINT32_MAX ? fraction : UINT32_MAX);
  return high_product(length, TWO_OVER_PI_HIGH, TWO_OVER_PI_LOW) >> (3 + up);
}

// x + x^3 / 6, the arc sine of a small x, Q30. Pre: |x| <= 2^30.
static int32_t arc_sine(int32_t x) {
  return x + times_q30(times_q30(times_q30(x, x), x), SIXTH_Q30);
}

// Step 1 of an arc: the angle with this sine and cosine, from 0 to a quarter of a turn. A first guess is within 0.02
// of it, a step of Newton's within 2^-31 of what sine and cosine say.
static uint64_t half_turns_of_arc(gjk_q30 sine, gjk_q30 cosine) {
  const int32_t guess = EIGHTH_Q30 + arc_sine(times_q30(sine - cosine, DIAGONAL_Q30));  // 0.019 to 1.552
  const uint64_t turns = gjk_umul32((uint32_t)guess, TURNS_PER_RADIAN);
  gjk_q30 s, c;
  gjk_sine_cosine(1, turns, &s, &c);
  const int64_t off = gjk_mul32(sine, c) - gjk_mul32(cosine, s);  // sine of the rest, Q60
  const int32_t rest = arc_sine((int32_t)gjk_sar64(off + (INT64_C(1) << 29), 30));
  const uint64_t size = gjk_umul32(gjk_magnitude32(rest), TURNS_PER_RADIAN);
  if (rest < 0 && size > turns) {
    return 0;
  }
  return (rest < 0 ? turns - size : turns + size) >> 16;
}

// Pre: out->deviation is set.
static gjk_status start_arc(const gjk_motion *motion, gjk_turning *out) {
  const gjk_quat *from = &motion->from.rotation, *to = &motion->to.rotation;
  int64_t deviation;
  if (!gjk_quat_deviation(to, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk_quat back = {-from->x, -from->y, -from->z, from->w};  // as long as from
  gjk_quat arc;
  gjk_quat_multiply(to, deviation, &back, out->deviation, &arc);
  if (arc.w < 0) {  // the shorter way round
    arc.x = -arc.x;
    arc.y = -arc.y;
    arc.z = -arc.z;
    arc.w = -arc.w;
  }
  const uint64_t squared = (uint64_t)gjk_mul32(arc.x, arc.x) + (uint64_t)gjk_mul32(arc.y, arc.y) +
                           (uint64_t)gjk_mul32(arc.z, arc.z);  // below 2^60 + 2^32
  const uint32_t sine = gjk_nearest_root(squared);
  const gjk_vec3 direction = {arc.x, arc.y, arc.z};
  if (!gjk_axis_normalize(&direction, &out->axis)) {
    out->half_turns = 0;
    return GJK_OK;
  }
  out->half_turns = half_turns_of_arc((gjk_q30)sine, arc.w);
  return GJK_OK;
}

static bool motion_spins(const gjk_motion *motion) {
  return (motion->spin.x | motion->spin.y | motion->spin.z) != 0;
}

gjk_status gjk_turning_start(const gjk_motion *motion, gjk_turning *out) {
  const gjk_unit3 none = {0, 0, 0};
  out->axis = none;
  if (!gjk_quat_deviation(&motion->from.rotation, &out->deviation)) {
    return GJK_ERROR_ROTATION;
  }
  if (!motion_spins(motion)) {
    return start_arc(motion, out);
  }
  (void)gjk_axis_normalize(&motion->spin, &out->axis);  // it is not zero
  out->half_turns = half_turns_of_spin(&motion->spin);
  return GJK_OK;
}

// Step 3: a coordinate.  |to - from| < 2^32, fraction <= 2^30:  the product is below 2^62
static gjk_q16 coordinate_at(gjk_q16 from, gjk_q16 to, gjk_q30 fraction) {
  const int64_t way = (int64_t)to - from;
  return (gjk_q16)(from + gjk_sar64(way * fraction + (INT64_C(1) << 29), 30));
}

void gjk_turning_pose(const gjk_motion *motion, const gjk_turning *turning, gjk_q30 fraction, gjk_pose *out) {
  const gjk_vec3 *from = &motion->from.position, *to = &motion->to.position;
  out->position.x = coordinate_at(from->x, to->x, fraction);
  out->position.y = coordinate_at(from->y, to->y, fraction);
  out->position.z = coordinate_at(from->z, to->z, fraction);
  out->rotation = motion->from.rotation;
  if (fraction == GJK_Q30_ONE && !motion_spins(motion)) {
    out->rotation = motion->to.rotation;
  } else if (fraction > 0 && turning->half_turns != 0) {
    gjk_q30 sine;
    gjk_quat turned;
    int64_t deviation = 0;
    gjk_sine_cosine(1, gjk_turning_after(turning, fraction), &sine, &turned.w);
    turned.x = times_q30(turning->axis.x, sine);
    turned.y = times_q30(turning->axis.y, sine);
    turned.z = times_q30(turning->axis.z, sine);
    (void)gjk_quat_deviation(&turned, &deviation);  // it is a unit
    gjk_quat_multiply(&turned, deviation, &motion->from.rotation, turning->deviation, &out->rotation);
  }
}

// x / 2^30 to the nearest integer. Pre: that fits.
static int32_t round_q60(int64_t x) {
  return (int32_t)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

void gjk_turning_split(const gjk_turning *turning, const gjk_unit3 *v, gjk_turned *out) {
  const gjk_vec3 axis = {turning->axis.x, turning->axis.y, turning->axis.z}, at = {v->x, v->y, v->z};
  const int32_t along = round_q60(gjk_dot(&axis, &at));  // |along| < 2^30 + 2^5
  gjk_long3 across;
  gjk_cross(&axis, &at, &across);
  out->along.x = times_q30(axis.x, along);
  out->along.y = times_q30(axis.y, along);
  out->along.z = times_q30(axis.z, along);
  out->off = gjk_sub(at, out->along);
  out->across.x = round_q60(across.x);
  out->across.y = round_q60(across.y);
  out->across.z = round_q60(across.z);
}

// v = along + cos off + sin across, each at most 2^30 + 2^6 in size.
void gjk_turning_join(const gjk_turning *turning, gjk_q30 part, bool back, const gjk_turned *split, gjk_unit3 *v) {
  gjk_q30 sine, cosine;
  gjk_sine_cosine(back ? -1 : 1, 2 * gjk_turning_after(turning, part), &sine, &cosine);
  const gjk_vec3 *along = &split->along, *off = &split->off, *across = &split->across;
  v->x = along->x + round_q60(gjk_mac32(gjk_mul32(cosine, off->x), sine, across->x));
  v->y = along->y + round_q60(gjk_mac32(gjk_mul32(cosine, off->y), sine, across->y));
  v->z = along->z + round_q60(gjk_mac32(gjk_mul32(cosine, off->z), sine, across->z));
}

gjk_status gjk_motion_pose(const gjk_motion *motion, gjk_q30 fraction, gjk_pose *out) {
  if (motion == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (fraction < 0 || fraction > GJK_Q30_ONE) {
    return GJK_ERROR_RANGE;
  }
  gjk_turning turning;
  const gjk_status status = gjk_turning_start(motion, &turning);
  if (status == GJK_OK) {
    gjk_turning_pose(motion, &turning, fraction, out);
  }
  return status;
}
