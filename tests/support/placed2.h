// The same as placed.h in the plane, under names of its own.
#ifndef PLACED2_H
#define PLACED2_H

#include <string.h>

#include "check.h"
#include "gjk2/collider.h"

static inline gjk2_collider posed2(const gjk2_shape *shape, const gjk2_pose *pose) {
  gjk2_collider c;
  memset(&c, 0, sizeof c);
  CHECK(gjk2_collider_init(&c, shape, NULL, 0) == GJK_OK);
  CHECK(gjk2_collider_pose(&c, pose) == GJK_OK);
  return c;
}

static inline gjk2_collider placed2(const gjk2_shape *shape, gjk_q16 x, gjk_q16 y) {
  const gjk2_pose pose = {{x, y}, {GJK_Q30_ONE, 0}};
  return posed2(shape, &pose);
}

#endif
