// A collider at a place, not turned. Its types are those of space, or of the plane where macros name them so.
#ifndef PLACED_H
#define PLACED_H

#include <string.h>

#include "check.h"

static inline gjk_collider placed(const gjk_shape *shape, gjk_vec3 at) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider c;
  memset(&c, 0, sizeof c);
  pose.position = at;
  CHECK(gjk_collider_init(&c, shape, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&c, &pose) == GJK_OK);
  return c;
}

#endif
