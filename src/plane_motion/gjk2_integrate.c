// Rotations of the plane integrated by an angular velocity: those of a motion that spins in place.
#include "gjk2/impact.h"
#include "gjk2/math.h"

gjk_status gjk2_rotation_integrate(const gjk2_rotation *rotation, gjk_angle velocity, gjk_q30 time,
                                   gjk2_rotation *out) {
  if (rotation == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_motion motion = {GJK2_POSE_IDENTITY, GJK2_POSE_IDENTITY, velocity};
  motion.from.rotation = *rotation;
  motion.to.rotation = *rotation;  // what a velocity of 0 comes to
  gjk2_pose pose;
  const gjk_status status = gjk2_motion_pose(&motion, time, &pose);
  if (status == GJK_OK) {
    *out = pose.rotation;
  }
  return status;
}
