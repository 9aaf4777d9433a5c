// Binding a shape of the plane to a collider, and placing it.
#include "gjk2/collider.h"

#include "../arith/gjk_root.h"
#include "gjk2_class.h"
#include "gjk2_rotation.h"

// How much farther from the centre posing may put a vertex. Errors per component:
//   a vertex of a triangle or polygon  < 0.75, and of the rounded centre 0.51: together < 1.26
//   a corner of two half axes          < 2 / 2, and 0.22 for the rotation: together < 1.22
// The distance grows by less than 1.26 sqrt(2) < 2.
#define PLANE_POSE_SLACK 2

// Do [p, p + p_bytes) and [q, q + q_bytes) share a byte?
static bool plane_regions_overlap(const void *p, size_t p_bytes, const void *q, size_t q_bytes) {
  uintptr_t a = (uintptr_t)p, b = (uintptr_t)q;
  return a < b ? b - a < p_bytes : a - b < q_bytes;
}

static gjk_status plane_check_buffer(const gjk2_collider *c, const gjk2_shape *shape, const gjk2_vec *buffer,
                                     uint16_t capacity) {
  const size_t bytes = shape->count * sizeof *buffer;
  if (capacity < shape->count) {
    return GJK_ERROR_CAPACITY;
  }
  return plane_regions_overlap(buffer, bytes, shape->vertices, bytes) ||
                 plane_regions_overlap(buffer, bytes, c, sizeof *c)
             ? GJK_ERROR_OVERLAP
             : GJK_OK;
}

gjk_status gjk2_collider_init(gjk2_collider *c, const gjk2_shape *shape, gjk2_vec *buffer, uint16_t capacity) {
  if (c == NULL || shape == NULL || shape->type == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk2_shape_class *type = shape->type;
  gjk2_extent extent;
  if (!gjk2_is_known(type)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_status status = shape->convex_radius < 0 ? GJK_ERROR_NEGATIVE : type->measure(shape, &extent);
  if (status != GJK_OK) {
    return status;
  }
  const int64_t room = (int64_t)GJK2_RADIUS_MAX - shape->convex_radius;
  if (room < 0 || extent.squared > (uint64_t)(room * room)) {
    return GJK_ERROR_SIZE;
  }
  if (GJK_SHAPES >= GJK_SHAPES_POLYTOPES && type->buffered && buffer != NULL) {
    status = plane_check_buffer(c, shape, buffer, capacity);
    if (status != GJK_OK) {
      return status;
    }
  }
  c->shape = shape;
  c->buffer = gjk2_is_buffered(type) ? buffer : NULL;
  c->local_centre = extent.centre;
  const uint32_t reach = GJK_SHAPES <= GJK_SHAPES_POINTS ? 0 : gjk_isqrt64(extent.squared);
  //@ assert reach <= GJK2_RADIUS_MAX;
  c->core_radius = (gjk_q16)reach + 1 + PLANE_POSE_SLACK;
  //@ assert shape->convex_radius <= GJK2_RADIUS_MAX;
  c->radius = c->core_radius + shape->convex_radius;
  c->count = gjk2_is_buffered(type) ? shape->count : type->count;
  c->ordered = extent.ordered;
  c->state = GJK2_STATE_INITIALISED;
  return GJK_OK;
}

// The rest of gjk2_collider_pose of a point.
static gjk_status plane_pose_alone(gjk2_collider *c, const gjk2_pose *pose) {
  int64_t deviation;
  if (!gjk2_rotation_deviation(&pose->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  c->centre = c->position = pose->position;
  c->fraction[0] = c->fraction[1] = 0;
  c->frame[0] = c->frame[1] = c->local_centre;  // 0
  c->state = GJK2_STATE_POSED;
  return GJK_OK;
}

static bool plane_fits(int64_t x) {
  return x >= INT32_MIN && x <= INT32_MAX;
}

// Rounds a coordinate of the rotated centre from Q30 to LSB. *fraction, Q8: what the rounding has left.
static int64_t plane_round_centre(int64_t rotated, int8_t *fraction) {
  const int64_t whole = gjk_sar64(rotated + (INT64_C(1) << 29), 30);
  *fraction = (int8_t)gjk_sar64(rotated - gjk_shl64(whole, 30), 22);  // -2^29 <= rest < 2^29:  -2^7 <= *fraction < 2^7
  return whole;
}

gjk_status gjk2_collider_pose(gjk2_collider *c, const gjk2_pose *pose) {
  if (c == NULL || pose == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK2_STATE_INITIALISED && c->state != GJK2_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return plane_pose_alone(c, pose);
  }
  gjk2_vec rotation;
  int64_t centre[2];
  int8_t fraction[2];
  if (!gjk2_rotation_with_point(&pose->rotation, &c->local_centre, &rotation, centre)) {
    return GJK_ERROR_ROTATION;
  }
  const int64_t x = plane_round_centre(centre[0], &fraction[0]) + pose->position.x;
  const int64_t y = plane_round_centre(centre[1], &fraction[1]) + pose->position.y;
  if (!plane_fits(x) || !plane_fits(y)) {
    return GJK_ERROR_RANGE;
  }
  c->centre.x = (int32_t)x;
  c->centre.y = (int32_t)y;
  c->position = pose->position;
  c->fraction[0] = fraction[0];
  c->fraction[1] = fraction[1];
  c->shape->type->pose(c, &rotation);
  c->state = GJK2_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk2_collider_move(gjk2_collider *c, const gjk2_vec *position) {
  if (c == NULL || position == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK2_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  const int64_t x = (int64_t)c->centre.x - c->position.x + position->x;
  const int64_t y = (int64_t)c->centre.y - c->position.y + position->y;
  if (!plane_fits(x) || !plane_fits(y)) {
    return GJK_ERROR_RANGE;
  }
  c->centre.x = (int32_t)x;
  c->centre.y = (int32_t)y;
  c->position = *position;
  return GJK_OK;
}
