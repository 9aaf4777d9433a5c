// Vectors of the plane for users, and rotations that aim.
#include "gjk2/math.h"

#include "../arith/gjk_root.h"
#include "gjk2_rotation.h"

gjk2_vec gjk2_vec_add(const gjk2_vec *a, const gjk2_vec *b) {
  const gjk2_vec sum = {gjk_saturate((int64_t)a->x + b->x), gjk_saturate((int64_t)a->y + b->y)};
  return sum;
}

gjk2_vec gjk2_vec_subtract(const gjk2_vec *a, const gjk2_vec *b) {
  const gjk2_vec difference = {gjk_saturate((int64_t)a->x - b->x), gjk_saturate((int64_t)a->y - b->y)};
  return difference;
}

gjk2_vec gjk2_vec_scale(const gjk2_vec *a, gjk_q16 s) {
  const gjk2_vec product = {gjk_q16_multiply(a->x, s), gjk_q16_multiply(a->y, s)};
  return product;
}

// Each product is from 2^31 - 2^62 to 2^62.
int64_t gjk2_vec_dot(const gjk2_vec *a, const gjk2_vec *b) {
  return gjk_saturated_sum(gjk_mul32(a->x, b->x), gjk_mul32(a->y, b->y));
}

int64_t gjk2_vec_cross(const gjk2_vec *a, const gjk2_vec *b) {
  return gjk_saturated_sum(gjk_mul32(a->x, b->y), -gjk_mul32(a->y, b->x));
}

// |v|^2. It is at most 2^63.
static uint64_t plane_squared(const gjk2_vec *v) {
  const uint32_t x = gjk_magnitude32(v->x), y = gjk_magnitude32(v->y);
  return gjk_umul32(x, x) + gjk_umul32(y, y);
}

uint32_t gjk2_vec_length(const gjk2_vec *a) {
  return gjk_nearest_root(plane_squared(a));
}

gjk_status gjk2_vec_normalize(const gjk2_vec *a, gjk2_unit *out) {
  if (a == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_rotation unit = {a->x, a->y};
  const gjk_status status = gjk2_rotation_normalize(&unit, &unit);
  if (status == GJK_OK) {
    out->x = unit.c;
    out->y = unit.s;
  }
  return status;
}

// Errors, in LSB of Q30: both units 0.71 each, and rounding here 0.71.
gjk_status gjk2_rotation_between(const gjk2_vec *from, const gjk2_vec *to, gjk2_rotation *out) {
  if (from == NULL || to == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_unit u, v;
  if (gjk2_vec_normalize(from, &u) != GJK_OK || gjk2_vec_normalize(to, &v) != GJK_OK) {
    return GJK_ERROR_ROTATION;
  }
  out->c = gjk2_to_q30(gjk_mac32(gjk_mul32(u.x, v.x), u.y, v.y));  // at most 2^60 + 2^31
  out->s = gjk2_to_q30(gjk_mac32(gjk_mul32(u.x, v.y), -u.y, v.x));
  return GJK_OK;
}

gjk_angle gjk2_vec_angle(const gjk2_vec *a, const gjk2_vec *b) {
  gjk2_rotation turn = {GJK_Q30_ONE, 0};
  (void)gjk2_rotation_between(a, b, &turn);
  return gjk_atan2(turn.s, turn.c);
}

gjk_status gjk2_pose_between(const gjk2_vec *p, const gjk2_vec *q, gjk2_pose *out, gjk_q16 *half_length) {
  if (p == NULL || q == NULL || out == NULL || half_length == NULL) {
    return GJK_ERROR_NULL;
  }
  const int64_t x = (int64_t)q->x - p->x, y = (int64_t)q->y - p->y;
  // Where the way is longer than int32 its half is taken: 1 of 2^31.
  const unsigned down = x != gjk_saturate(x) || y != gjk_saturate(y) ? 1 : 0;
  const gjk2_vec way = {(int32_t)gjk_sar64(x, down), (int32_t)gjk_sar64(y, down)};
  const uint64_t squared = plane_squared(&way);
  // Half of a root from 2 k to 2 k + 1 is nearest to k, of one from 2 k + 1 to 2 k + 2 to k + 1.
  const uint32_t half = down != 0 ? gjk_nearest_root(squared) : (gjk_isqrt64(squared) + 1) / 2;
  if (half > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  const gjk2_rotation direction = {way.x, way.y}, still = {GJK_Q30_ONE, 0};
  const int64_t middle_x = gjk_sar64((int64_t)p->x + q->x, 1), middle_y = gjk_sar64((int64_t)p->y + q->y, 1);
  if (gjk2_rotation_normalize(&direction, &out->rotation) != GJK_OK) {
    out->rotation = still;
  }
  out->position.x = (gjk_q16)middle_x;
  out->position.y = (gjk_q16)middle_y;
  *half_length = (gjk_q16)half;
  return GJK_OK;
}
