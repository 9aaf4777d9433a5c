// Forward kinematics: the poses along a chain of joints, such as an arm or a leg.
//
// A chain costs less than a third of what its joints cost by gjk_quat_from_axis_angle and gjk_pose_compose. Its errors
// are smaller, because positions are rounded once, and what a joint adds is stated. A joint that forks begins a chain
// of its own, whose base is the pose of the joint before. So does one that turns otherwise than those before.
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

// Most joints of one chain.
#define GJK_JOINTS_MAX 1000

// A joint and the frame that it turns. gjk_joint_init fills it; its contents are the library's.
typedef struct gjk_joint {
  gjk_vec3 offset;   // from the origin of the frame before to this one's, in the frame before
  uint32_t reach;    // no less than the length of offset
  gjk_quat still;    // the frame's rotation in the one before, at angle 0
  gjk_quat quarter;  // still times the axis: that half a turn later
} gjk_joint;

// Makes a joint.
//
// fixed     the pose of the joint's frame in the frame before, or in that of the base, at angle 0.
// axis      what the frame turns about, in itself, through its origin: of any length but 0 (ROTATION). NULL: z.
// Statuses  NULL; ROTATION. joint is written only after OK.
gjk_status gjk_joint_init(gjk_joint *joint, const gjk_pose *fixed, const gjk_vec3 *axis);

// The poses of a chain's frames, each after its joint has turned by an angle about its axis, by the right-hand rule.
//
// joints    count of them, from the base on, at most GJK_JOINTS_MAX (RANGE); those that gjk_joint_init has made.
// base      what the first joint stands on; may be one of out.
// angles    count of them, any, more than a turn included.
// out       count poses, written only after OK: units within GJK_ROTATION_TOLERANCE, as all calls take them.
// Errors    against real arithmetic on base, fixed, axis and angles; tests/check/unit/test_joint.c holds them.
//             rotation  each joint adds less than 2^-26 radians, and the base as much
//             position  0.51 LSB per coordinate, and 2^-26 of the sum of k times the k-th offset's length, from 1. So it is
//                       within 1 LSB where that sum is below 500 units: 10 joints of 9 units
// Statuses  NULL; ROTATION (base); RANGE: at some angles a frame of the chain would leave int32.
// Cost      600 instructions a joint on a Cortex-M3, 2,100 if composed one by one (src/README.md has the command).
gjk_status gjk_joints_from_angles(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                  const gjk_angle *angles, gjk_pose *out);

// The same for ball joints: each turns by a rotation in its own frame, whatever its axis. Statuses: ROTATION also of a
// rotation that is not a unit.
gjk_status gjk_joints_from_rotations(const gjk_joint *joints, unsigned count, const gjk_pose *base,
                                     const gjk_quat *rotations, gjk_pose *out);

#ifdef __cplusplus
}
#endif

#endif
