// The witness points: where a feature of A - B is nearest to the origin, as a point on each shape.
#ifndef GJK_SRC_WITNESS_H
#define GJK_SRC_WITNESS_H

#include "gjk_iteration.h"

// The nearest point of the feature as a point of each core, moved by the convex radius along the normal (A) and against
// it (B). World frame. Sets *saturated when a coordinate does not fit Q16.16 and is saturated; never clears it.
// Pre: 1 <= count <= 3, and the origin's projection onto the feature lies in it.
void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a, gjk_vec3 *point_b,
                        bool *saturated);

#endif
