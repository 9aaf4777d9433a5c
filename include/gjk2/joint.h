// Forward kinematics in the plane: the poses along a chain of joints. It is gjk/joint.h with one way to turn.
#ifndef GJK2_JOINT_H
#define GJK2_JOINT_H

#include "gjk2/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most joints of one chain.
#define GJK2_JOINTS_MAX 1000

// A joint and the frame that it turns. gjk2_joint_init fills it; its contents are the library's.
typedef struct gjk2_joint {
  gjk2_vec offset;      // from the origin of the frame before to the origin of this one, in the frame before
  uint32_t reach;       // at least the length of offset
  gjk2_rotation still;  // the frame's rotation in the frame before, at angle 0
} gjk2_joint;

// Makes a joint. fixed is the pose of the joint's frame in the frame before, or in that of the base, at angle 0.
// Statuses: NULL; ROTATION. joint is written only after OK.
gjk_status gjk2_joint_init(gjk2_joint *joint, const gjk2_pose *fixed);

// The poses of a chain's frames. Each joint has turned by an angle, counterclockwise.
//
// joints    count joints made by gjk2_joint_init, from the base on; at most GJK2_JOINTS_MAX (RANGE).
// base      the pose that the first joint stands on; may be one of out.
// angles    count angles, any, more than a turn included.
// out       count poses, written only after OK. They are units within GJK2_ROTATION_TOLERANCE, as all calls take them.
// Errors    against real arithmetic on base, fixed and angles; tests/check/unit/test_plane_math.c checks them.
//             rotation  each joint adds less than 2^-27 radians, and so does the base
//             position  0.51 LSB per coordinate, and 2^-27 of the sum of k times the length of offset k, counted from 1
// Statuses  NULL; ROTATION (base); RANGE: at some angles a frame of the chain would leave int32.
// Cost      280 instructions a joint on a Cortex-M3; composed one by one it is 750.
gjk_status gjk2_joints_from_angles(const gjk2_joint *joints, unsigned count, const gjk2_pose *base,
                                   const gjk_angle *angles, gjk2_pose *out);

#ifdef __cplusplus
}
#endif

#endif
