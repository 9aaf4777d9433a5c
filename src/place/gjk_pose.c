// Quaternions and poses: normalise, compose, invert, apply.
#include "gjk/pose.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"

// |p|^2 - 1, Q60, from 0 to 5 too small, for p in Q60. Pre: |p|^2 is within 2^-28 of 1.
static int64_t excess_q60(const uint64_t p[4]) {
  // p = 2^30 h + l, 0 <= l < 2^30, per component:  p^2 / 2^60 = h^2 + 2 h l / 2^30 + (less than 1)
  //   |h| <= 2^30 + 8, length:  squares < 2^61, products < 2^62
  uint64_t squares = 0, products = 0;
  for (int i = 0; i < 4; i++) {
    const uint32_t h = (uint32_t)(p[i] >> 30), l = (uint32_t)(p[i] & 0x3FFFFFFFu);
    squares += gjk_umul32(h, h);
    products += gjk_umul32(h, l);
  }
  return gjk_int64(squares + (products >> 29) - (UINT64_C(1) << 60));
}

gjk_status gjk_quat_normalize(const gjk_quat *q, gjk_quat *out) {
  if (q == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const int32_t component[4] = {q->x, q->y, q->z, q->w};
  uint32_t bits = 0;
  for (int i = 0; i < 4; i++) {
    bits |= gjk_magnitude32(component[i]);
  }
  if (bits == 0) {
    return GJK_ERROR_ROTATION;
  }
  const unsigned up = gjk_clz32(bits);
  // A quarter of |q 2^up|^2. One component >= 2^31, all < 2^32:  2^60 <= quarter < 2^64
  uint64_t quarter = 0;
  for (int i = 0; i < 4; i++) {
    const uint32_t size = gjk_magnitude32(component[i]) << up;
    quarter += gjk_umul32(size, size) >> 2;
  }
  //@ assert quarter >= UINT64_C(1) << 60;
  const unsigned zeros = gjk_clz64(quarter) & ~1u;  // 0 or 2
  // root = 2^46 sqrt(2^32) / sqrt(quarter 2^zeros) = 2^(63 - zeros / 2) / |q 2^up|, relative error <= 2^-29.4
  const uint32_t root = gjk_reciprocal_root((uint32_t)((quarter << zeros) >> 32));
  const unsigned down = 3 - zeros / 2;
  uint64_t p[4];
  for (int i = 0; i < 4; i++) {
    p[i] = gjk_umul32(gjk_magnitude32(component[i]) << up, root) >> down;
  }
  // p is a unit in Q60 but for the error of root. Correct it: 1 - 1 / sqrt(1 + e) = e / 2 - ..., Q46, below 2^18.
  const int64_t off = excess_q60(p);
  //@ assert off >= -(INT64_C(1) << 33) && off <= INT64_C(1) << 33;
  const int32_t excess = (int32_t)gjk_sar64(off, 15);
  int32_t unit[4];
  for (int i = 0; i < 4; i++) {
    const gjk_q30 size = gjk_corrected_q30((int64_t)p[i], excess);
    unit[i] = component[i] < 0 ? -size : size;
  }
  out->x = unit[0];
  out->y = unit[1];
  out->z = unit[2];
  out->w = unit[3];
  return GJK_OK;
}

gjk_status gjk_quat_compose(const gjk_quat *a, const gjk_quat *b, gjk_quat *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t off_a, off_b;
  if (!gjk_quat_deviation(a, &off_a) || !gjk_quat_deviation(b, &off_b)) {
    return GJK_ERROR_ROTATION;
  }
  gjk_quat_multiply(a, off_a, b, off_b, out);
  return GJK_OK;
}

gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out) {
  if (q == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  if (!gjk_quat_deviation(q, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  // No component of a unit is INT32_MIN, so all can be negated.
  const gjk_quat conjugate = {-q->x, -q->y, -q->z, q->w};
  *out = conjugate;
  return GJK_OK;
}

// *out = v. GJK_ERROR_RANGE, and *out not set, when a component leaves int32.
static gjk_status store_point(const int64_t v[3], gjk_vec3 *out) {
  for (int i = 0; i < 3; i++) {
    if (v[i] < INT32_MIN || v[i] > INT32_MAX) {
      return GJK_ERROR_RANGE;
    }
  }
  out->x = (gjk_q16)v[0];
  out->y = (gjk_q16)v[1];
  out->z = (gjk_q16)v[2];
  return GJK_OK;
}

// *out = position + v rotated by q. GJK_ERROR_ROTATION or GJK_ERROR_RANGE: *out is not set.
static gjk_status place_point(const gjk_quat *q, const gjk_vec3 *v, const gjk_vec3 *position, gjk_vec3 *out) {
  gjk_vec3 rows[3];
  int64_t p[3];
  if (!gjk_rotation_from_quat(q, rows)) {
    return GJK_ERROR_ROTATION;
  }
  gjk_rotate_wide(rows, v, p);  // |p| <= 2^32
  p[0] += position->x;
  p[1] += position->y;
  p[2] += position->z;
  return store_point(p, out);
}

gjk_status gjk_quat_apply(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 *out) {
  const gjk_vec3 origin = {0, 0, 0};
  if (q == NULL || v == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return place_point(q, v, &origin, out);
}

gjk_status gjk_pose_apply(const gjk_pose *p, const gjk_vec3 *v, gjk_vec3 *out) {
  if (p == NULL || v == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return place_point(&p->rotation, v, &p->position, out);
}

gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  if (!gjk_quat_deviation(&b->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk_status status = place_point(&a->rotation, &b->position, &a->position, &out->position);
  return status == GJK_OK ? gjk_quat_compose(&a->rotation, &b->rotation, &out->rotation) : status;
}

gjk_status gjk_pose_invert(const gjk_pose *p, gjk_pose *out) {
  if (p == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_vec3 rows[3];
  int64_t back[3];
  if (!gjk_rotation_from_quat(&p->rotation, rows)) {
    return GJK_ERROR_ROTATION;
  }
  // The rows of the inverse matrix are the columns of the matrix.
  const gjk_vec3 inverse[3] = {
      {rows[0].x, rows[1].x, rows[2].x}, {rows[0].y, rows[1].y, rows[2].y}, {rows[0].z, rows[1].z, rows[2].z}};
  gjk_rotate_wide(inverse, &p->position, back);
  for (int i = 0; i < 3; i++) {
    back[i] = -back[i];
  }
  const gjk_status status = store_point(back, &out->position);
  return status == GJK_OK ? gjk_quat_invert(&p->rotation, &out->rotation) : status;
}
