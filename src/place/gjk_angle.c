// Quaternions from angles; sine and cosine are those of ../arith/gjk_sine.h, of half an angle.
#include "../arith/gjk_sine.h"
#include "gjk/pose.h"

// Sine and cosine of half the angle, Q30, each within 1 LSB of the real one.
static void half_angle(gjk_angle angle, gjk_q30 *sine, gjk_q30 *cosine) {
  gjk_sine_cosine(angle, gjk_half_turns(gjk_magnitude32(angle)), sine, cosine);
}

// a b to the nearest Q30. Pre: |a|, |b| <= 2^30.
static gjk_q30 multiply(gjk_q30 a, gjk_q30 b) {
  return (gjk_q30)gjk_sar64(gjk_mul32(a, b) + (INT64_C(1) << 29), 30);
}

gjk_status gjk_quat_from_axis_angle(const gjk_vec3 *axis, gjk_angle angle, gjk_quat *out) {
  if (axis == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_quat direction = {axis->x, axis->y, axis->z, 0};
  gjk_quat unit;
  if (gjk_quat_normalize(&direction, &unit) != GJK_OK) {
    return GJK_ERROR_ROTATION;
  }
  gjk_q30 sine;
  half_angle(angle, &sine, &out->w);
  out->x = multiply(unit.x, sine);
  out->y = multiply(unit.y, sine);
  out->z = multiply(unit.z, sine);
  return GJK_OK;
}

// ab c + de f to the nearest Q30. Pre: each is at most 2^30 in size.
static gjk_q30 sum_of_q30_products(gjk_q30 ab, gjk_q30 c, gjk_q30 de, gjk_q30 f) {
  return (gjk_q30)gjk_sar64(gjk_mul32(ab, c) + gjk_mul32(de, f) + (INT64_C(1) << 29), 30);
}

gjk_status gjk_quat_from_euler(gjk_angle x, gjk_angle y, gjk_angle z, gjk_quat *out) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_q30 sx, cx, sy, cy, sz, cz;
  half_angle(x, &sx, &cx);
  half_angle(y, &sy, &cy);
  half_angle(z, &sz, &cz);
  // The quaternion product of the rotations about z, y and x, which turns about x first.
  const gjk_q30 cc = multiply(cy, cz), ss = multiply(sy, sz), sc = multiply(sy, cz), cs = multiply(cy, sz);
  out->x = sum_of_q30_products(cc, sx, -ss, cx);
  out->y = sum_of_q30_products(sc, cx, cs, sx);
  out->z = sum_of_q30_products(cs, cx, -sc, sx);
  out->w = sum_of_q30_products(cc, cx, ss, sx);
  return GJK_OK;
}
