// The same as whorl.h in the plane, with x and y for x and z.
#ifndef WHORL2_H
#define WHORL2_H

#include "gjk2/shape.h"
#include "whorl.h"

static inline void whorl2_support(const void *user, const gjk2_vec *d, gjk2_vec *out) {
  const bool along = (d->x != 0) + (d->y != 0) == 1;
  (void)user;
  whorl_in_plane(d->x, d->y, &out->x, &out->y);
  out->x = along ? whorl_along(d->x) : out->x;
  out->y = along ? whorl_along(d->y) : out->y;
}

static const gjk2_shape whorl2 = GJK2_CUSTOM(whorl2_support, 0, GJK_Q16(60));

#endif
