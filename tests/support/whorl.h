// A shape that no search settles, seen from the point (6.24, 0, 7.82), 10 units away.
//
// Its nearest vertex there is one end of all its edges. Their other ends are 40 units aside, each edge a little nearer
// than the one before. The support sees from the direction which edge comes next. So searches find neither a plane nor
// an end, and whether it comes within 9.9985 to 10.0001 units of that point is never decided.
#ifndef WHORL_H
#define WHORL_H

#include "gjk/shape.h"

static inline int32_t whorl_along(int32_t d) {
  return d > 0 ? GJK_Q16(32) : d < 0 ? -GJK_Q16(32) : 0;
}

// What it says of a direction in the plane of its edges: ahead is along (0.6, 0.8), about towards the point.
static inline void whorl_in_plane(int32_t dx, int32_t dz, gjk_q16 *px, gjk_q16 *pz) {
  const double ahead = 0.6 * dx + 0.8 * dz, aside = 0.6 * dz - 0.8 * dx, slope = aside - 0.00005 * ahead;
  const bool ends = ahead <= 0 || slope <= 0 || slope > 0.01 * ahead;
  const double across = GJK_Q16(1) * (ends ? 0.4 : -39.7), back = GJK_Q16(1) * (ends ? 0 : 40.1 * slope / ahead);
  *px = (int32_t)(0.8 * across - 0.6 * back);
  *pz = (int32_t)(-0.6 * across - 0.8 * back);
}

static inline void whorl_support(const void *user, const gjk_vec3 *d, gjk_vec3 *out) {
  const bool along = (d->x != 0) + (d->y != 0) + (d->z != 0) == 1;  // where boxes are measured, it reaches farther
  (void)user;
  whorl_in_plane(d->x, d->z, &out->x, &out->z);
  out->x = along ? whorl_along(d->x) : out->x;
  out->y = along ? whorl_along(d->y) : 0;
  out->z = along ? whorl_along(d->z) : out->z;
}

static const gjk_shape whorl = GJK_CUSTOM(whorl_support, 0, GJK_Q16(60));

// That point, and a ball around it of which nobody can tell whether it touches.
static const gjk_vec3 whorl_point = {GJK_Q16(6.24), 0, GJK_Q16(7.82)};
static const gjk_shape whorl_ball = GJK_SPHERE(GJK_Q16(9.9992));

#endif
