// gjk2_time_of_impact on any two colliders, motions and setup, null pointers too. CASE 0: polygons, 1: a curved shape and
// any.
#include "plane_ways.h"

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_impact_result result;
  const gjk2_motion motion_a = {any_pose2(), any_pose2(), any_int32()}, motion_b = {any_pose2(), any_pose2(), any_int32()};
  const gjk2_impact_setup setup = {any_int32(), any_int32(), (uint8_t)any_between(0, UINT8_MAX)};
  any_posed(&a, &shapes[0], CASE == 0 ? &polygon : &curved);
  any_posed(&b, &shapes[1], CASE == 0 || any_bool() ? &polygon : &curved);
  (void)gjk2_time_of_impact(any_bool() ? &a : NULL, any_bool() ? &motion_a : NULL, any_bool() ? &b : NULL,
                            any_bool() ? &motion_b : NULL, any_bool() ? &setup : NULL, any_bool() ? &result : NULL);
  return 0;
}
