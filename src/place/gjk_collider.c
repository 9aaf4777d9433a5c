// Binding a shape to a collider, and placing it.
#include "gjk/collider.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "../shape/gjk_shape_class.h"

// How much farther from the centre posing may put a vertex. Errors per component:
//   a vertex of a triangle or hull    < 0.75, and of the rounded centre 0.51: together < 1.26
//   a corner of three half axes       < 3 / 2, and 0.22 for the matrix: together < 1.72
// The distance grows by less than 1.72 sqrt(3) < 3.
#define POSE_SLACK 3

// Do [p, p + p_bytes) and [q, q + q_bytes) share a byte?
static bool regions_overlap(const void *p, size_t p_bytes, const void *q, size_t q_bytes) {
  uintptr_t a = (uintptr_t)p, b = (uintptr_t)q;
  return a < b ? b - a < p_bytes : a - b < q_bytes;
}

static gjk_status check_buffer(const gjk_collider *c, const gjk_shape *shape, const gjk_vec3 *buffer,
                               uint16_t capacity) {
  const size_t bytes = shape->count * sizeof *buffer;
  if (capacity < shape->count) {
    return GJK_ERROR_CAPACITY;
  }
  return regions_overlap(buffer, bytes, shape->vertices, bytes) || regions_overlap(buffer, bytes, c, sizeof *c)
             ? GJK_ERROR_OVERLAP
             : GJK_OK;
}

gjk_status gjk_collider_init(gjk_collider *c, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity) {
  if (c == NULL || shape == NULL || shape->type == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_shape_class *type = shape->type;
  gjk_extent extent;
  if (!gjk_is_known(type)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_status status = shape->convex_radius < 0 ? GJK_ERROR_NEGATIVE : type->measure(shape, &extent);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t room = (int64_t)GJK_RADIUS_MAX - shape->convex_radius;
  if (room < 0 || extent.squared > (uint64_t)(room * room)) {
    return GJK_ERROR_SIZE;
  }
  if (GJK_SHAPES >= GJK_SHAPES_POLYTOPES && type->buffered && buffer != NULL) {
    status = check_buffer(c, shape, buffer, capacity);
    if (status != GJK_OK) {
      return status;
    }
  }
  const uint32_t reach = GJK_SHAPES <= GJK_SHAPES_POINTS ? 0 : gjk_isqrt64(extent.squared);
  //@ assert reach <= GJK_RADIUS_MAX;
  c->shape = shape;
  c->buffer = gjk_is_buffered(type) ? buffer : NULL;
  c->local_centre = extent.centre;
  c->core_radius = (gjk_q16)reach + 1 + POSE_SLACK;
  c->radius = c->core_radius + shape->convex_radius;
  c->bits = (uint8_t)(32 - gjk_clz32((uint32_t)c->core_radius));
  c->count = gjk_is_buffered(type) ? shape->count : type->count;
  c->state = GJK_STATE_INITIALISED;
  return GJK_OK;
}

// The rest of gjk_collider_pose where the shape has its centre at the local origin, as points, segments and boxes have: then
// nothing of the position is rounded.
static gjk_status pose_at_origin(gjk_collider *c, const gjk_pose *pose) {
  gjk_vec3 rows[3];
#if GJK_SHAPES <= GJK_SHAPES_POINTS
  int64_t deviation;
  const bool turned = gjk_quat_deviation(&pose->rotation, &deviation);
#elif GJK_SHAPES == GJK_SHAPES_ROUND
  const bool turned = gjk_rotation_of_z(&pose->rotation, rows);
#else
  const bool turned = gjk_rotation_from_quat(&pose->rotation, rows);
#endif
  if (!turned) {
    return GJK_ERROR_ROTATION;
  }
  c->centre = c->position = pose->position;
  c->fraction[0] = c->fraction[1] = c->fraction[2] = 0;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND) {
    c->shape->type->pose(c, rows);
  }
  c->state = GJK_STATE_POSED;
  return GJK_OK;
}

static bool fits(int64_t x) {
  return x >= INT32_MIN && x <= INT32_MAX;
}

// Rounds a coordinate of the rotated centre from Q30 to LSB. *fraction, Q8: what the rounding has left.
static int64_t round_centre(int64_t rotated, int8_t *fraction) {
  const int64_t whole = gjk_sar64(rotated + (INT64_C(1) << 29), 30);
  *fraction = (int8_t)gjk_sar64(rotated - gjk_shl64(whole, 30), 22);  // -2^29 <= rest < 2^29:  -2^7 <= *fraction < 2^7
  return whole;
}

gjk_status gjk_collider_pose(gjk_collider *c, const gjk_pose *pose) {
  if (c == NULL || pose == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_INITIALISED && c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  // not reached: GJK_SMALL is a constant
  if (GJK_SHAPES <= GJK_SHAPES_BOXES ||
      (!GJK_SMALL && (c->local_centre.x | c->local_centre.y | c->local_centre.z) == 0)) {
    return pose_at_origin(c, pose);
  }
  gjk_vec3 rows[3];
  int64_t centre[3];
  int8_t fraction[3];
  if (!gjk_rotation_with_point(&pose->rotation, &c->local_centre, rows, centre)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk_vec3 *position = &pose->position;
  const int64_t x = round_centre(centre[0], &fraction[0]) + position->x;
  const int64_t y = round_centre(centre[1], &fraction[1]) + position->y;
  const int64_t z = round_centre(centre[2], &fraction[2]) + position->z;
  if (!fits(x) || !fits(y) || !fits(z)) {
    return GJK_ERROR_RANGE;
  }
  c->centre.x = (int32_t)x;
  c->centre.y = (int32_t)y;
  c->centre.z = (int32_t)z;
  c->position = *position;
  for (int i = 0; i < 3; i++) {
    c->fraction[i] = fraction[i];
  }
  c->shape->type->pose(c, rows);
  c->state = GJK_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk_collider_move(gjk_collider *c, const gjk_vec3 *position) {
  if (c == NULL || position == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  const int64_t x = (int64_t)c->centre.x - c->position.x + position->x;
  const int64_t y = (int64_t)c->centre.y - c->position.y + position->y;
  const int64_t z = (int64_t)c->centre.z - c->position.z + position->z;
  if (!fits(x) || !fits(y) || !fits(z)) {
    return GJK_ERROR_RANGE;
  }
  c->centre.x = (int32_t)x;
  c->centre.y = (int32_t)y;
  c->centre.z = (int32_t)z;
  c->position = *position;
  return GJK_OK;
}
