// A collider at a pose, or not turned at a place. Its types are those of space, or of the plane where macros name them so.
#ifndef PLACED_H
#define PLACED_H

#include <string.h>

#include "check.h"

static inline gjk_collider posed(const gjk_shape *shape, const gjk_pose *pose) {
  gjk_collider c;
  memset(&c, 0, sizeof c);
  CHECK(gjk_collider_init(&c, shape, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&c, pose) == GJK_OK);
  return c;
}

static inline gjk_collider placed(const gjk_shape *shape, gjk_vec3 at) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = at;
  return posed(shape, &pose);
}

// The same by the place's coordinates.
#define placed_at(shape, ...) placed(shape, (gjk_vec3){__VA_ARGS__})

#endif
