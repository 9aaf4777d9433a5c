// What the kinds without vertices share: ellipse and a user's own shape.
//
// Their support points are computed in the shape's frame with two more bits than a coordinate has, rotated, and rounded
// once. Along each axis a support point lies within 1 LSB of the surface, and it is the farthest to within 1 LSB.
#ifndef GJK2_SRC_CURVED_H
#define GJK2_SRC_CURVED_H

#include "gjk2_class.h"

#define GJK2_FINE_BITS 2

// Keeps the rotation in frame, for the support functions.
void gjk2_curved_pose(gjk2_collider *collider, const gjk2_vec *rotation);

// d in the shape's frame, scaled up before it is rotated, so that its rounding turns it by less than 2^-28. The result
// is not zero, and at most 2^31 long.
gjk2_vec gjk2_curved_direction(const gjk2_collider *collider, gjk2_vec d);

// Reports a support point in fine units, 2^-GJK2_FINE_BITS LSB each, rotated into the world and rounded to LSB.
// Pre: components are at most 2^30 in size.
void gjk2_curved_support(const gjk2_collider *collider, gjk2_vec point, gjk2_support *out);

// size * u per component, in fine units, with u for the unit vector along (x, y). Pre: that is not 0, its components
// are at most 2^62 in size; size is at most 2^28.
gjk2_vec gjk2_fine_stretch(gjk2_vec size, int64_t x, int64_t y);

// The table of a kind of shape without vertices. It takes gjk2_curved_depth.h, too.
#define GJK2_CURVED_CLASS(measure_shape, support_shape)                                                         \
  {                                                                                                             \
    .measure = (measure_shape), .pose = gjk2_curved_pose, .support = (support_shape), .vertex = NULL,           \
    .adjacent = NULL, .depth = gjk2_curved_depth, .touch = NULL, .ground = NULL, .buffered = false, .count = 0, \
  }

#endif
