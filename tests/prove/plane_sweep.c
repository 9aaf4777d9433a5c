// gjk2_motion_pose on any motion at any fraction, null pointers too.
#include "plane_any.h"

int main(void) {
  const gjk2_motion motion = {any_pose2(), any_pose2(), any_int32()};
  gjk2_pose pose;
  (void)gjk2_motion_pose(any_bool() ? &motion : NULL, any_int32(), any_bool() ? &pose : NULL);
  return 0;
}
