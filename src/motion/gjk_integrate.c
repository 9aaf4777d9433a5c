// Rotations integrated by an angular velocity: those of a motion that spins in place.
#include "gjk/impact.h"
#include "gjk/math.h"

gjk_status gjk_quat_integrate(const gjk_quat *rotation, const gjk_vec3 *velocity, gjk_q30 time, gjk_quat *out) {
  if (rotation == NULL || velocity == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_motion motion = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {velocity->x, velocity->y, velocity->z}};
  motion.from.rotation = *rotation;
  motion.to.rotation = *rotation;  // what a velocity of 0 comes to
  gjk_pose pose;
  const gjk_status status = gjk_motion_pose(&motion, time, &pose);
  if (status == GJK_OK) {
    *out = pose.rotation;
  }
  return status;
}
