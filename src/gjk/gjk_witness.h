// Where a feature of the Minkowski difference is nearest: a point on each shape.
#ifndef GJK_SRC_WITNESS_H
#define GJK_SRC_WITNESS_H

#include "gjk_iteration.h"

// The nearest point on the feature, as a point of each core moved by its rounding along normal (A) and against it (B),
// world frame. Sets *saturated when a coordinate was cut off at the ends of Q16.16, and never clears it.
// Pre: 1 <= count <= 3 and the origin's projection onto the feature lies in it.
void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a,
                                        gjk_vec3 *point_b, bool *saturated);

#endif
