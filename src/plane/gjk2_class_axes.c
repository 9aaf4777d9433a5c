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

static inline void pose_axes(gjk2_collider *c, const gjk2_vec *rotation, gjk_q16 half_x, gjk_q16 half_y) {
  static const int8_t none[2] = {0, 0};
  const gjk2_vec x = {half_x, 0}, y = {0, half_y};
  c->frame[0] = gjk2_rotate_onto(rotation, x, none);
  c->frame[1] = gjk2_rotate_onto(rotation, y, none);
  // Rounding may turn the axes of a box of a few LSB over, or into one line.
  c->ordered = gjk2_cross(c->frame[0], c->frame[1]) > 0;
}

static void pose_plane_box(gjk2_collider *c, const gjk2_vec *rotation) {
  pose_axes(c, rotation, c->shape->size.x, c->shape->size.y);
}

// A segment has no size.y and a point no size, whatever the fields hold.
static void pose_plane_segment(gjk2_collider *c, const gjk2_vec *rotation) {
  pose_axes(c, rotation, c->shape->size.x, 0);
}

static void pose_plane_point(gjk2_collider *c, const gjk2_vec *rotation) {
  if (GJK_SHAPES >= GJK_SHAPES_ROUND) {
    pose_axes(c, rotation, 0, 0);
  }
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
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    offset->x = offset->y = 0;
    return true;
  }
  // A segment has bit 0 alone, and its frame[1] is 0. A point has neither.
  offset->x = ((number & 1u) != 0 ? x.x : -x.x) + ((number & 2u) != 0 ? y.x : -y.x);
  offset->y = ((number & 1u) != 0 ? x.y : -x.y) + ((number & 2u) != 0 ? y.y : -y.y);
  return true;
}

// Counterclockwise the corners are 3, 2, 0, 1. So ones with two equal signs change that of x next, the others that of y.
static void adjacent_axes(const gjk2_collider *c, const gjk2_support *from, bool following, gjk2_support *way) {
  const unsigned number = from->vertex, differ = (number ^ number >> 1) & 1u, axis = differ ^ (following ? 0u : 1u);
  const unsigned other = number ^ (1u << axis);
  gjk2_vec edge = {2 * c->frame[axis].x, 2 * c->frame[axis].y};  // half axes are below 2^28 long
  if (other < number) {
    edge = gjk2_negate(edge);
  }
  gjk2_copy(&way->offset, &edge);
  way->vertex = (uint16_t)other;
}

#if GJK_SHAPES <= GJK_SHAPES_POINTS
#define ADJACENT_ENDS NULL
#elif GJK_SMALL || !GJK_64_BIT
#define ADJACENT_ENDS adjacent_axes
#else
#define ADJACENT_ENDS adjacent_ends

// Of a segment the way to the other end, of a point none.
static void adjacent_ends(const gjk2_collider *c, const gjk2_support *from, bool following, gjk2_support *way) {
  (void)following;
  way->offset.x = -2 * from->offset.x;
  way->offset.y = -2 * from->offset.y;
  way->vertex = (uint16_t)(c->count - 1u - from->vertex);
}
#endif

#define PLANE_AXES_CLASS(pose_axes, support_axes, adjacent_of, touch_of, vertices)                              \
  {                                                                                                             \
    .measure = measure_plane_axes, .pose = (pose_axes), .support = (support_axes), .vertex = vertex_plane_axes, \
    .adjacent = (adjacent_of), .depth = NULL, .touch = (touch_of), .ground = NULL, .buffered = false,           \
    .count = (vertices),                                                                                        \
  }

const gjk2_shape_class gjk2_class_point =
    PLANE_AXES_CLASS(pose_plane_point, support_point, ADJACENT_ENDS, GJK2_TOUCH_AXES, 1);
const gjk2_shape_class gjk2_class_segment =
    PLANE_AXES_CLASS(pose_plane_segment, support_segment, ADJACENT_ENDS, GJK2_TOUCH_AXES, 2);
const gjk2_shape_class gjk2_class_box = PLANE_AXES_CLASS(pose_plane_box, support_box, adjacent_axes, NULL, 4);
