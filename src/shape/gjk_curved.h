// Common ground of the kinds without vertices: cylinder, cone, ellipsoid and a user's own shape.
//
// Their supports are computed in the shape's frame with two more bits than a coordinate has, rotated, and rounded once:
// a support point lies within 1 LSB of the surface, along each axis, and is farthest to within that.
#ifndef GJK_SRC_CURVED_H
#define GJK_SRC_CURVED_H

#include "gjk_shape_class.h"

// A point of the shape's frame, 2^-2 LSB; components at most 2^30.
typedef struct gjk_fine_point {
  int32_t x, y, z;
} gjk_fine_point;

#define GJK_FINE_BITS 2

// Keeps the rotation for the supports.
void gjk_curved_pose(gjk_collider *collider, const gjk_vec3 rows[3]);

// d in the shape's frame, scaled so that rotating it loses nothing that matters. Not zero; at most 2^31 long.
gjk_vec3 gjk_curved_direction(const gjk_collider *collider, const gjk_vec3 *d);

// Reports a support point.
void gjk_curved_support(const gjk_collider *collider, const gjk_fine_point *point, gjk_support *out);

// Is the gain less than a fifth of an LSB, or late in a search less than one? Supports are rounded to an LSB, so a search by
// such steps could go on for long. With supports as they are, the gain is also how far the feature's distance is from a
// proven bound. So distances stay within 2 LSB. |d| <= 3 2^29, |to - from| < 2^31; -3 <= shift <= 29.
bool gjk_curved_stalls(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late);

// size / 2^30 along u, in fine units. Pre: size at most 2^28.
int32_t gjk_fine(gjk_q16 size, gjk_q30 u);

// size * u in fine units, per component, where u is the unit vector along d. Pre: d != 0, components at most 2^62; size at
// most 2^28.
gjk_fine_point gjk_fine_stretch(const gjk_vec3 *size, const gjk_long3 *d);

#endif
