// gjk2_motion_pose and gjk2_rotation_integrate on any motion, rotation and velocity at any fraction, null pointers too.
#include "plane_any.h"

int main(void) {
  const gjk2_motion motion = {any_pose2(), any_pose2(), any_int32()};
  const gjk2_rotation rotation = any_rotation();
  gjk2_pose pose;
  gjk2_rotation turned;
  (void)gjk2_motion_pose(any_bool() ? &motion : NULL, any_int32(), any_bool() ? &pose : NULL);
  (void)gjk2_rotation_integrate(any_bool() ? &rotation : NULL, any_int32(), any_int32(), any_bool() ? &turned : NULL);
  return 0;
}
