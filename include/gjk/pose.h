// Rotations and poses in integers: make, normalise, compose, invert, apply.
//
// Quaternions are Q2.30, angles Q16.16 radians (gjk_angle). A quaternion is a unit if its squared length is within
// GJK_ROTATION_TOLERANCE of 1; that test is exact. Every call takes such a q as q / |q|, so the drift of an integrator
// does no harm within the tolerance. Beyond it, a call returns a status.
//
// Errors  are against real arithmetic on the same integer input, for every input, and bound every component.
//         tests/check/unit/test_pose.c checks them.
// Outputs are written only when the result is GJK_OK. An output may be the same object as an input of its type.
// Statuses NULL; ROTATION for a quaternion that is not a unit; RANGE where stated.
// Cost    the length of no loop depends on a value.
#ifndef GJK_POSE_H
#define GJK_POSE_H

#include "gjk/format.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// The accepted deviation of |q|^2 from 1, Q2.30: 2^-16.
#define GJK_ROTATION_TOLERANCE ((gjk_q30)16384)

// The rotation by an angle about an axis, by the right-hand rule, within 2 LSB. axis has any length but 0 (ROTATION).
// angle may exceed a turn; 0 gives exactly the identity.
gjk_status gjk_quat_from_axis_angle(const gjk_vec3 *axis, gjk_angle angle, gjk_quat *out);

// The rotation about fixed x, then fixed y, then fixed z (roll, pitch, yaw), within 3 LSB.
gjk_status gjk_quat_from_euler(gjk_angle x, gjk_angle y, gjk_angle z, gjk_quat *out);

// The unit quaternion along q, within 0.501 LSB. q has any length but 0 (ROTATION).
gjk_status gjk_quat_normalize(const gjk_quat *q, gjk_quat *out);

// The rotation by b, then a: the product a b, normalised, within 0.501 LSB. So products of unit quaternions stay units.
gjk_status gjk_quat_compose(const gjk_quat *a, const gjk_quat *b, gjk_quat *out);

// The opposite rotation: the conjugate, exact.
gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out);

// The vector v rotated by q, within 1 LSB for |v| up to 8192 units and within 4 LSB for any v. The identity is exact.
// RANGE: a component of the result leaves int32.
gjk_status gjk_quat_apply(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 *out);

// The pose b, then a. Its rotation is that of gjk_quat_compose, its position that of gjk_pose_apply.
gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out);

// The pose that undoes p. Its rotation is exact, and its position is as accurate as gjk_quat_apply.
gjk_status gjk_pose_invert(const gjk_pose *p, gjk_pose *out);

// The world position of point v of p's frame. It is as accurate as gjk_quat_apply, because p's position is added
// exactly. RANGE: a component of the sum leaves int32.
gjk_status gjk_pose_apply(const gjk_pose *p, const gjk_vec3 *v, gjk_vec3 *out);

#ifdef __cplusplus
}
#endif

#endif
