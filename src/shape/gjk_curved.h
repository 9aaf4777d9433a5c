// What the kinds without vertices share: cylinder, cone, ellipsoid and a user's own shape.
//
// Their support points are computed in the shape's frame with two more bits than a coordinate has, rotated, and rounded
// once. Along each axis a support point lies within 1 LSB of the surface, and it is the farthest to within 1 LSB.
#ifndef GJK_SRC_CURVED_H
#define GJK_SRC_CURVED_H

#include "gjk_shape_class.h"

// A point of the shape's frame in fine units, 2^-GJK_FINE_BITS LSB each. Components are at most 2^30 in size.
typedef struct gjk_fine_point {
  int32_t x, y, z;
} gjk_fine_point;

#define GJK_FINE_BITS 2

// Keeps the rotation in frame, for the support functions.
void gjk_curved_pose(gjk_collider *collider, const gjk_vec3 rows[3]);

// d in the shape's frame. d is scaled up before it is rotated, so that its rounding turns it by less than 2^-28. The
// result is not zero, and at most 2^31 long.
gjk_vec3 gjk_curved_direction(const gjk_collider *collider, const gjk_vec3 *d);

// Reports a support point, rotated into the world and rounded to LSB.
void gjk_curved_support(const gjk_collider *collider, const gjk_fine_point *point, gjk_support *out);

// Is the gain of an iteration, d . (to - from) / |d|, too small to go on for? That is, at most
//   |d|_1 / |d| / 8 LSB,  from 1/8 to 0.22 LSB by direction
//   |d|_1 / |d| / 2 LSB,  from 1/2 to 0.87 LSB, where late: the search is long
// In a far frame, shift < 0, the frame's units stand for LSB.
//
// Support points are rounded to LSB, so a search by smaller gains could go on for long. The gain is also how far the
// feature's distance lies from a proven bound, up to the errors of support points, so distances stay within 2 LSB.
// Pre: |d| <= 3 2^29, |to - from| < 2^31; -3 <= shift <= 29.
bool gjk_curved_stalls(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late);

// size u in fine units, to the nearest. Pre: size at most 2^28, |u| <= 2^30 + 1.
int32_t gjk_fine(gjk_q16 size, gjk_q30 u);

// size * u per component, in fine units, with u for the unit vector along d. Pre: d != 0, its components are at most
// 2^62 in size; size is at most 2^28.
gjk_fine_point gjk_fine_stretch(const gjk_vec3 *size, const gjk_long3 *d);

// The table of a kind of shape without vertices.
#define GJK_CURVED_CLASS(measure_shape, support_shape, kind_of_shape)                                                \
  {                                                                                                                  \
    .measure = (measure_shape), .pose = gjk_curved_pose, .support = (support_shape), .refine = NULL, .vertex = NULL, \
    .stalls = gjk_curved_stalls, .close = NULL, .concave = NULL, .buffered = false, .count = 0,                      \
    .kind = (kind_of_shape),                                                                                         \
  }

#endif
