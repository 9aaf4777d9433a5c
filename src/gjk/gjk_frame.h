// The frame of a pair: the integers that a query computes on.
//
// A vertex w of A - B stands in the frame as 2^shift w. The reach R bounds |w| in LSB:
//   R = |x| + |y| + |z| + core_radius_a + core_radius_b, where (x, y, z) = centre_a - centre_b.
// The shift makes w as large as int32_t allows, so that the filters on high words settle nearly every sign.
//
//   frame                       shift       w in the frame                    |w|, length   |edge|, length
//   R < 2^30                    0 to 29     exact: 2^shift R < 2^30           < 2^30        < 2^31
//   |centre_a - centre_b|
//     <= 2^30 <= R              0           exact                             <= 3 2^29     <= 2^30
//     > 2^30, far               -3 to -1    rounded to the nearest integer,   <= 3 2^29     <= 2^30
//                                           centres at most 2^30 apart
//
// In a far frame the gap is above 2^29 LSB, and the rounding moves it by at most 2^-28 of itself.
#ifndef GJK_SRC_FRAME_H
#define GJK_SRC_FRAME_H

#include "gjk_iteration.h"

// The same as gjk_frame_set. Pre: a component of centre_a - centre_b is at least 2^29 - 3 in size, so that shift <= 0.
bool gjk_frame_set_far(gjk_iteration *it, bool spheres, int64_t radius);

// Sets shift, delta and radius for cores of the pair it->a, it->b that are moved to where their centres are delta apart.
// Pre: |delta| <= 2^30, its norm and the core radii together below 2^31. In a build for size one copy, in gjk_frame.c.
#if GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_ROUND
void gjk_frame_set_near(gjk_iteration *it, const gjk_vec3 *delta, int64_t radius);
#else
#define gjk_frame_set_near gjk_frame_fill
#endif
static inline void gjk_frame_fill(gjk_iteration *it, const gjk_vec3 *delta, int64_t radius) {
  // Not 0, since core radii have slack.
  const int32_t reach = (int32_t)(gjk_norm1(*delta) + (uint32_t)(it->a->core_radius + it->b->core_radius));
  const unsigned zeros = gjk_clz32((uint32_t)reach), shift = zeros < 2 ? 0 : zeros - 2;
  it->shift = (int8_t)shift;
  it->delta.x = gjk_shl32(delta->x, shift);
  it->delta.y = gjk_shl32(delta->y, shift);
  it->delta.z = gjk_shl32(delta->z, shift);
  // A radius of at least the reach answers as the reach does, which is below 2^31 in the frame as well.
  it->radius = gjk_shl32(radius < reach ? (int32_t)radius : reach, shift);
}

// Sets shift, delta and radius for the pair it->a, it->b. radius: in LSB, from 0; below 2^32 with both core radii.
// False: the bounding spheres are more than radius apart (asked only where spheres is set); then nothing is set.
static inline bool gjk_frame_set(gjk_iteration *it, bool spheres, int64_t radius) {
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  // A quarter of centre_a - centre_b: each component below 2^30, and off by less than 1.
  const int32_t x = gjk_sar32(a->x, 2) - gjk_sar32(b->x, 2);
  const int32_t y = gjk_sar32(a->y, 2) - gjk_sar32(b->y, 2);
  const int32_t z = gjk_sar32(a->z, 2) - gjk_sar32(b->z, 2);
  // Bit 27 or a higher one differs from the sign: that component is not from -2^27 to below 2^27.
  const uint32_t bits =
      (uint32_t)(x ^ gjk_sar32(x, 31)) | (uint32_t)(y ^ gjk_sar32(y, 31)) | (uint32_t)(z ^ gjk_sar32(z, 31));
  if (bits >> 27 != 0) {
    return gjk_frame_set_far(it, spheres, radius);
  }
  const gjk_vec3 delta = gjk_sub(*a, *b);  // components at most 2^29 + 3 in size: |delta| < 2^30
  //@ assert delta.x >= -(INT32_C(1) << 29) - 3 && delta.x <= (INT32_C(1) << 29) - 1;
  //@ assert delta.y >= -(INT32_C(1) << 29) - 3 && delta.y <= (INT32_C(1) << 29) - 1;
  //@ assert delta.z >= -(INT32_C(1) << 29) - 3 && delta.z <= (INT32_C(1) << 29) - 1;
  const int32_t cores = it->a->core_radius + it->b->core_radius;  // below 2^29 - 2^16
  const int64_t limit = cores + radius;                           // from 2^31 on the spheres are not apart
  if (spheres && limit <= INT32_MAX && gjk_dot(&delta, &delta) > gjk_mul32((int32_t)limit, (int32_t)limit)) {
    return false;
  }
  gjk_frame_set_near(it, &delta, radius);
  return true;
}

// Makes *v a vertex of A - B in the frame. Before, *v is the offset of A's vertex less that of B's vertex, in LSB.
// Pre: shift < 0.
void gjk_frame_move_far(const gjk_iteration *it, gjk_vec3 *v);

// Sets *w to a vertex of A - B in the frame. offset: that of A's vertex less that of B's vertex, in LSB.
static inline void gjk_frame_move(const gjk_iteration *it, gjk_vec3 offset, gjk_vec3 *w) {
  if (it->shift < 0) {
    *w = offset;
    gjk_frame_move_far(it, w);
    return;
  }
  const unsigned shift = (unsigned)it->shift;
  w->x = it->delta.x + gjk_shl32(offset.x, shift);
  w->y = it->delta.y + gjk_shl32(offset.y, shift);
  w->z = it->delta.z + gjk_shl32(offset.z, shift);
  //@ assert w->x >= -(INT32_C(3) << 29) && w->x <= INT32_C(3) << 29;
  //@ assert w->y >= -(INT32_C(3) << 29) && w->y <= INT32_C(3) << 29;
  //@ assert w->z >= -(INT32_C(3) << 29) && w->z <= INT32_C(3) << 29;
}

#endif
