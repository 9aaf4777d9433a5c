// Where a feature of the Minkowski difference is nearest: a point on each shape.
#ifndef GJK_SRC_WITNESS_H
#define GJK_SRC_WITNESS_H

#include "iteration.h"

static inline gjk_q16 gjk_saturate(int64_t x, bool *saturated) {
  const gjk_q16 low = gjk_int32(gjk_low32(x));
  if (low != x) {
    *saturated = true;
    return x < 0 ? INT32_MIN : INT32_MAX;
  }
  return low;
}

// The nearest point on the feature, as a point of each core moved by its rounding along normal (A) and against it (B),
// world frame. Sets *saturated when a coordinate was cut off at the ends of Q16.16, and never clears it.
// Pre: 1 <= count <= 3 and the origin's projection onto the feature lies in it.
GJK_OUT_OF_LINE void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a,
                                        gjk_vec3 *point_b, bool *saturated);

#endif
