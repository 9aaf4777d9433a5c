// Rotations and poses in integers: make, normalise, compose, invert, apply.
//
// Quaternions are Q2.30, angles Q16.16 radians (gjk_angle). A quaternion counts as a unit while its squared length is
// within GJK_ROTATION_TOLERANCE of 1, exactly. Every call takes such a q for q / |q|, so an integrator's drift does no
// harm within the tolerance. A status reports what is beyond it.
//
// Errors  against real arithmetic on the same integer input, the largest of any component, for every input;
//         tests/check/unit/test_pose.c holds them.
// Outputs written only when the result is GJK_OK; an output may be the same object as an input of its type.
// Statuses NULL; ROTATION for a quaternion that is not a unit; RANGE where said.
// Cost    no loop depends on a value.
#ifndef GJK_POSE_H
#define GJK_POSE_H

#include "gjk/format.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Accepted deviation of |q|^2 from 1, Q2.30: 2^-16.
#define GJK_ROTATION_TOLERANCE ((gjk_q30)16384)

// Rotation by an angle about an axis, by the right-hand rule. axis: of any length but 0 (ROTATION). angle: any, more
// than a turn included; 0 gives exactly the identity. out: within 2 LSB.
gjk_status gjk_quat_from_axis_angle(const gjk_vec3 *axis, gjk_angle angle, gjk_quat *out);

// Rotation about fixed x, then fixed y, then fixed z (roll, pitch, yaw). out: within 3 LSB.
gjk_status gjk_quat_from_euler(gjk_angle x, gjk_angle y, gjk_angle z, gjk_quat *out);

// The unit quaternion along q, which has any length but 0 (ROTATION). Within 0.501 LSB.
gjk_status gjk_quat_normalize(const gjk_quat *q, gjk_quat *out);

// First b, then a: the product a b, normalised. Within 0.501 LSB, so the product of unit quaternions stays one.
gjk_status gjk_quat_compose(const gjk_quat *a, const gjk_quat *b, gjk_quat *out);

// The opposite rotation: the conjugate, exact.
gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out);

// v rotated by q. Within 1 LSB for |v| up to 8192 units, 4 LSB for any v; the identity is exact. RANGE when a
// component of the result leaves int32.
gjk_status gjk_quat_apply(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 *out);

// First b, then a. The rotation is that of gjk_quat_compose, the position that of gjk_pose_apply.
gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out);

// The pose that undoes p. Its rotation is exact, its position as accurate as gjk_quat_apply.
gjk_status gjk_pose_invert(const gjk_pose *p, gjk_pose *out);

// The world position of point v of p's frame: as accurate as gjk_quat_apply, since p's position is added exactly.
// RANGE when a component of the sum leaves int32.
gjk_status gjk_pose_apply(const gjk_pose *p, const gjk_vec3 *v, gjk_vec3 *out);

#ifdef __cplusplus
}
#endif

#endif
