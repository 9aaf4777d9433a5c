// Forward kinematics: the poses along a chain of joints, such as an arm or a leg.
//
// A chain costs less than a third of the same joints computed by gjk_quat_from_axis_angle and gjk_pose_compose. Its
// errors are smaller, because positions are rounded once, and the error of each joint is stated. A branch is a chain of
// its own, whose base is the pose of the joint before. Joints that turn by angles and joints that turn by rotations are
// separate chains, too.
//
//     gjk_joint arm[2];
//     gjk_joint_init(&arm[0], &shoulder, NULL);  // once; may then be a constant
//     gjk_joint_init(&arm[1], &elbow, &across);
//     gjk_joints_from_angles(arm, 2, &base, angles, poses);
#ifndef GJK_JOINT_H
#define GJK_JOINT_H

#include "gjk/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most joints of one chain.
#define GJK_JOINTS_MAX 1000

// A joint and the frame that it turns. gjk_joint_init fills it; its contents are the library's.
typedef struct gjk_joint {
  gjk_vec3 offset;   // from the origin of the frame before to the origin of this one, in the frame before
  uint32_t reach;    // at least the length of offset
  gjk_quat still;    // the frame's rotation in the frame before, at angle 0
  gjk_quat quarter;  // still times the axis: the same, half a turn later
} gjk_joint;

// Makes a joint.
//
// fixed     pose of the joint's frame in the frame before, or in the base's frame, at angle 0.
// axis      axis through the frame's origin, in that frame, of any length but 0 (ROTATION). NULL: z.
// Statuses  NULL; ROTATION. joint is written only after OK.
gjk_status gjk_joint_init(gjk_joint *joint, const gjk_pose *fixed, const gjk_vec3 *axis);

// The poses of a chain's frames. Each joint has turned by an angle about its axis, by the right-hand rule.
//
// joints    count joints made by gjk_joint_init, from the base on; at most GJK_JOINTS_MAX (RANGE).
// base      the pose that the first joint stands on; may be one of out.
// angles    count angles, any, more than a turn included.
// out       count poses, written only after OK. They are units within GJK_ROTATION_TOLERANCE, as all calls take them.
// Errors    against real arithmetic on base, fixed, axis and angles; tests/check/unit/test_joint.c checks them.
//             rotation  each joint adds less than 2^-26 radians, and so does the base
//             position  0.51 LSB per coordinate, and 2^-26 of the sum of k times the length of offset k, counted from
//                       1. So it is within 1 LSB while that sum is below 500 units, as for 10 joints of 9 units
// Statuses  NULL; ROTATION (base); RANGE: at some angles a frame of the chain would leave int32.
// Cost      600 instructions a joint on a Cortex-M3; composed one by one it is 2,100 (src/README.md has the command).
gjk_status gjk_joints_from_angles(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                  const gjk_angle *angles, gjk_pose *out);

// The same for ball joints: each turns by a rotation in its own frame, whatever its axis. ROTATION also for rotations.
gjk_status gjk_joints_from_rotations(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                     const gjk_quat *rotations, gjk_pose *out);

#ifdef __cplusplus
}
#endif

#endif
