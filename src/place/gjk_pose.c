// Quaternions and poses: normalise, compose, invert, apply.
#include "gjk/pose.h"

#include "../arith/gjk_rotation.h"

gjk_status gjk_quat_normalize(const gjk_quat *q, gjk_quat *out) {
  if (q == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const int32_t component[4] = {q->x, q->y, q->z, q->w};
  gjk_q30 unit[4];
  if (!gjk_normalize(component, 4, unit)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk_quat normal = {unit[0], unit[1], unit[2], unit[3]};
  *out = normal;
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
