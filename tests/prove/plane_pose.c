// Every function of gjk2/pose.h, on any input at all.
#include "plane_any.h"

int main(void) {
  const gjk2_vec v = any_position2();
  const gjk2_rotation p = any_rotation(), q = any_rotation();
  const gjk2_pose a = any_pose2(), b = any_pose2();
  gjk2_vec moved;
  gjk2_rotation rotation;
  gjk2_pose pose;
  (void)gjk2_rotation_from_angle(any_int32(), any_bool() ? &rotation : NULL);
  (void)gjk2_rotation_normalize(any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk2_rotation_compose(any_bool() ? &p : NULL, any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk2_rotation_invert(any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk2_rotation_apply(any_bool() ? &q : NULL, any_bool() ? &v : NULL, any_bool() ? &moved : NULL);
  (void)gjk2_pose_compose(any_bool() ? &a : NULL, any_bool() ? &b : NULL, any_bool() ? &pose : NULL);
  (void)gjk2_pose_invert(any_bool() ? &a : NULL, any_bool() ? &pose : NULL);
  (void)gjk2_pose_apply(any_bool() ? &a : NULL, any_bool() ? &v : NULL, any_bool() ? &moved : NULL);
  return 0;
}
