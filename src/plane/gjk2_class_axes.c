// Point, segment and box: a centre and half axes.
#include "gjk2_class.h"
#include "gjk2_rotation.h"

static gjk_status measure_plane_axes(const gjk2_shape *shape, gjk2_extent *out) {
  const gjk2_vec *size = &shape->size;
  const gjk2_vec origin = {0, 0};
  if (size->x < 0 || size->y < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  out->centre = origin;
  out->squared = (uint64_t)gjk_mul32(size->x, size->x) + (uint64_t)gjk_mul32(size->y, size->y);
  out->ordered = false;
  return GJK_OK;
}

static void pose_axes(gjk2_collider *c, const gjk2_vec *rotation) {
  static const int8_t none[2] = {0, 0};
  const gjk2_vec x = {c->shape->size.x, 0}, y = {0, c->shape->size.y};
  c->frame[0] = gjk2_rotate_onto(rotation, x, none);
  c->frame[1] = gjk2_rotate_onto(rotation, y, none);
  // Rounding may turn the axes of a box of a few LSB over, or into one line.
  c->ordered = gjk2_cross(c->frame[0], c->frame[1]) > 0;
}

static void support_point(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  (void)c;
  (void)d;
  out->offset.x = 0;
  out->offset.y = 0;
  out->vertex = 0;
}

static void support_segment(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec axis = c->frame[0];
  const bool plus = gjk2_dot(axis, *d) >= 0;
  out->offset = plus ? axis : gjk2_negate(axis);
  out->vertex = plus ? 1 : 0;
}

static void support_box(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec x = c->frame[0], y = c->frame[1];
  const bool plus_x = gjk2_dot(x, *d) >= 0, plus_y = gjk2_dot(y, *d) >= 0;
  out->offset.x = (plus_x ? x.x : -x.x) + (plus_y ? y.x : -y.x);
  out->offset.y = (plus_x ? x.y : -x.y) + (plus_y ? y.y : -y.y);
  out->vertex = (uint16_t)((plus_x ? 1u : 0u) | (plus_y ? 2u : 0u));
}

// Bit 0 and 1 of a number: the signs of the half axes, of which frame[1] is 0 but for a box.
static bool vertex_plane_axes(const gjk2_collider *c, uint16_t number, gjk2_vec *offset) {
  const gjk2_vec x = c->frame[0], y = c->frame[1];
  if (number >= c->count) {
    return false;
  }
  // A segment has bit 0 alone, and its frame[1] is 0. A point has neither.
  offset->x = ((number & 1u) != 0 ? x.x : -x.x) + ((number & 2u) != 0 ? y.x : -y.x);
  offset->y = ((number & 1u) != 0 ? x.y : -x.y) + ((number & 2u) != 0 ? y.y : -y.y);
  return true;
}

// Counterclockwise: 3, 2, 0, 1.
static void adjacent_axes(const gjk2_collider *c, uint16_t number, bool following, gjk2_support *out) {
  static const uint8_t after[4] = {1, 3, 0, 2}, before[4] = {2, 0, 3, 1};
  out->vertex = following ? after[number & 3u] : before[number & 3u];
  (void)vertex_plane_axes(c, out->vertex, &out->offset);
}

const gjk2_shape_class gjk2_class_point = {
    .measure = measure_plane_axes,
    .pose = pose_axes,
    .support = support_point,
    .vertex = vertex_plane_axes,
    .adjacent = adjacent_axes,
    .depth = NULL,
    .buffered = false,
    .count = 1,
};

const gjk2_shape_class gjk2_class_segment = {
    .measure = measure_plane_axes,
    .pose = pose_axes,
    .support = support_segment,
    .vertex = vertex_plane_axes,
    .adjacent = adjacent_axes,
    .depth = NULL,
    .buffered = false,
    .count = 2,
};

const gjk2_shape_class gjk2_class_box = {
    .measure = measure_plane_axes,
    .pose = pose_axes,
    .support = support_box,
    .vertex = vertex_plane_axes,
    .adjacent = adjacent_axes,
    .depth = NULL,
    .buffered = false,
    .count = 4,
};
