// Every function of gjk/pose.h, on any input at all.
#include "any.h"

int main(void) {
  const gjk_vec3 v = any_position();
  const gjk_quat p = any_quat(), q = any_quat();
  const gjk_pose a = any_pose(), b = any_pose();
  gjk_vec3 moved;
  gjk_quat rotation;
  gjk_pose pose;
  (void)gjk_quat_from_axis_angle(any_bool() ? &v : NULL, any_int32(), any_bool() ? &rotation : NULL);
  (void)gjk_quat_from_euler(any_int32(), any_int32(), any_int32(), any_bool() ? &rotation : NULL);
  (void)gjk_quat_normalize(any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk_quat_compose(any_bool() ? &p : NULL, any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk_quat_invert(any_bool() ? &q : NULL, any_bool() ? &rotation : NULL);
  (void)gjk_quat_apply(any_bool() ? &q : NULL, any_bool() ? &v : NULL, any_bool() ? &moved : NULL);
  (void)gjk_pose_compose(any_bool() ? &a : NULL, any_bool() ? &b : NULL, any_bool() ? &pose : NULL);
  (void)gjk_pose_invert(any_bool() ? &a : NULL, any_bool() ? &pose : NULL);
  (void)gjk_pose_apply(any_bool() ? &a : NULL, any_bool() ? &v : NULL, any_bool() ? &moved : NULL);
  return 0;
}
