// Poses along a chain of joints.
//
//   1. A joint's own rotation is still cos + quarter sin, of half the angle: still times the quaternion about the axis.
//   2. The matrix of the frame so far takes offset to the world. The sum of origins keeps 30 bits below the LSB.
//   3. The frame so far times the joint's rotation is the next frame. Its length is not corrected: the errors below are
//      so small that GJK_JOINTS_MAX joints stay within the tolerance, 13 GJK_JOINTS_MAX < GJK_ROTATION_TOLERANCE.
//
// Errors of a joint, in units of 2^-30 of a quaternion's length:
//   still and quarter   1.0 and 2.9 (axis 0.9, still 1.0, product 1.0), cos and sin of them:  3.1
//   cosine and sine     1 each, along two directions across from each other:                  1.5
//   steps 1 and 3       each component 0.5:                                                   1.0 each
//   together                                                                                  < 6.6
// The rotation turns by less than twice that, 2^-26 radians. The base adds 2.0, rounding the matrix 1.5.
#include "gjk_joint_frame.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "../arith/gjk_sine.h"

gjk_status gjk_joint_init(gjk_joint *joint, const gjk_pose *fixed, const gjk_vec3 *axis) {
  if (joint == NULL || fixed == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  gjk_quat direction = {0, 0, 1, 0}, still, quarter;
  if (axis != NULL) {
    direction.x = axis->x;
    direction.y = axis->y;
    direction.z = axis->z;
  }
  if (!gjk_quat_deviation(&fixed->rotation, &deviation) || gjk_quat_normalize(&direction, &direction) != GJK_OK) {
    return GJK_ERROR_ROTATION;
  }
  (void)gjk_quat_normalize(&fixed->rotation, &still);  // both are units
  (void)gjk_quat_compose(&still, &direction, &quarter);
  const gjk_vec3 *v = &fixed->position;
  const uint32_t x = gjk_magnitude32(v->x), y = gjk_magnitude32(v->y), z = gjk_magnitude32(v->z);
  const uint32_t length = gjk_isqrt64(gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z));  // at most 3 2^62
  gjk_set(v, &joint->offset);
  joint->reach = length + (length >> 16) + 2;  // rotations of the chain are off by less than 2^-16
  joint->still = still;
  joint->quarter = quarter;
  return GJK_OK;
}

// Steps 2 and 3 for a joint with this rotation of its own; then its pose.
static void next_frame(gjk_joint_frame *frame, const gjk_joint *joint, const gjk_quat *own, gjk_pose *out) {
  const gjk_vec3 *v = &joint->offset;
  if ((v->x | v->y | v->z) != 0) {
    gjk_vec3 rows[3];
    gjk_joint_rows(&frame->rotation, rows);
    gjk_joint_move(frame, rows, v);
  }
  gjk_joint_turn(frame, own);
  gjk_joint_place(frame, &out->position);
  out->rotation = frame->rotation;
}

// Checks the base and the chain's reach, and sets the frame to the base.
static gjk_status start_chain(const gjk_joint *joints, unsigned count, const gjk_pose *base, gjk_joint_frame *frame) {
  int64_t deviation;
  if (!gjk_quat_deviation(&base->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  if (count > GJK_JOINTS_MAX) {
    return GJK_ERROR_RANGE;
  }
  const gjk_vec3 *p = &base->position;
  const uint32_t x = gjk_magnitude32(p->x), y = gjk_magnitude32(p->y), z = gjk_magnitude32(p->z);
  uint64_t reach = x > y ? (x > z ? x : z) : (y > z ? y : z);
  for (unsigned i = 0; i < count; i++) {
    reach += joints[i].reach;  // below 2^31 + 1000 2^32 at the end
  }
  if (reach > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  gjk_joint_start(frame, base);
  return GJK_OK;
}

gjk_status gjk_joints_from_angles(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                  const gjk_angle *angles, gjk_pose *out) {
  gjk_joint_frame frame;
  if (joints == NULL || base == NULL || angles == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = start_chain(joints, count, base, &frame);
  for (unsigned i = 0; status == GJK_OK && i < count; i++) {
    gjk_q30 sine, cosine;
    gjk_sine_cosine(angles[i], gjk_half_turns(gjk_magnitude32(angles[i])), &sine, &cosine);
    const gjk_quat own = gjk_joint_own(&joints[i], sine, cosine);
    next_frame(&frame, &joints[i], &own, &out[i]);
  }
  return status;
}

gjk_status gjk_joints_from_rotations(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                     const gjk_quat *rotations, gjk_pose *out) {
  gjk_joint_frame frame;
  if (joints == NULL || base == NULL || rotations == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = start_chain(joints, count, base, &frame);
  for (unsigned i = 0; status == GJK_OK && i < count; i++) {
    int64_t deviation;
    status = gjk_quat_deviation(&rotations[i], &deviation) ? GJK_OK : GJK_ERROR_ROTATION;
  }
  for (unsigned i = 0; status == GJK_OK && i < count; i++) {
    gjk_quat own;
    (void)gjk_quat_compose(&joints[i].still, &rotations[i], &own);  // both are units
    next_frame(&frame, &joints[i], &own, &out[i]);
  }
  return status;
}
