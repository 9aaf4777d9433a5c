// The frame of a pair; the bounds are in gjk_frame.h.
#include "gjk_frame.h"

// Is v / 2^n, floored, longer than r? Exact for r < 2^31. For larger r single components alone are compared, so a "no" may be
// wrong. Pre: components of v at most 2^32 in size, 0 <= r < 2^33.
static bool longer_than(const gjk_long3 *v, unsigned n, int64_t r) {
  const uint64_t x = gjk_magnitude64(gjk_sar64(v->x, n)), y = gjk_magnitude64(gjk_sar64(v->y, n)),
                 z = gjk_magnitude64(gjk_sar64(v->z, n));
  const uint64_t limit = (uint64_t)r;
  if (x > limit || y > limit || z > limit) {
    return true;
  }
  if (limit >> 31 != 0) {
    return false;
  }
  return gjk_umul32((uint32_t)x, (uint32_t)x) + gjk_umul32((uint32_t)y, (uint32_t)y) +
             gjk_umul32((uint32_t)z, (uint32_t)z) >  // each square < 2^62:  their sum < 2^64
         gjk_umul32((uint32_t)limit, (uint32_t)limit);
}

// The largest shift <= 0 that leaves delta 2^shift at most 2^30 long.
static int far_shift(const gjk_long3 *delta) {
  unsigned n = 0;
  while (n < 3 && longer_than(delta, n, INT64_C(1) << 30)) {
    n++;
  }
  return -(int)n;
}

// A component of a vector in a far frame, rounded to the nearest integer. In line it costs Cortex-M0 100 bytes.
GJK_OUT_OF_LINE static int32_t far_component(int64_t difference, int shift) {
  const unsigned n = (unsigned)-shift;
  //@ assert n <= 3;
  const int64_t rounded = gjk_sar64(difference + ((INT64_C(1) << n) >> 1), n);
  //@ assert rounded >= -(INT32_C(3) << 29) && rounded <= INT32_C(3) << 29;
  return (int32_t)rounded;
}

void gjk_frame_move_far(const gjk_iteration *it, gjk_vec3 *v) {
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  v->x = far_component((int64_t)a->x - b->x + v->x, it->shift);
  v->y = far_component((int64_t)a->y - b->y + v->y, it->shift);
  v->z = far_component((int64_t)a->z - b->z + v->z, it->shift);
}

bool gjk_frame_set_far(gjk_iteration *it, bool spheres, int64_t radius) {
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  const gjk_long3 delta = {(int64_t)a->x - b->x, (int64_t)a->y - b->y, (int64_t)a->z - b->z};  // each at most 2^32
  if (spheres && longer_than(&delta, 0, it->a->core_radius + it->b->core_radius + radius)) {
    return false;
  }
  it->shift = (int8_t)far_shift(&delta);
  it->delta.x = far_component(delta.x, it->shift);
  it->delta.y = far_component(delta.y, it->shift);
  it->delta.z = far_component(delta.z, it->shift);
  // |w| < 2^31 - 1, so that a larger radius settles the question like this one.
  const int64_t framed = gjk_sar64(radius, (unsigned)-it->shift);
  it->radius = framed < INT32_MAX ? (int32_t)framed : INT32_MAX;
  return true;
}

#if GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_ROUND
void gjk_frame_set_near(gjk_iteration *it, const gjk_vec3 *delta, int64_t radius) {
  gjk_frame_fill(it, delta, radius);
}
#endif
