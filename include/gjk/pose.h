// Rotations and poses in integers: make, normalise, compose, invert, apply.
//
// Quaternions are Q2.30, angles Q16.16 radians. A quaternion counts as a unit while its squared length lies
// within 2^-16 of 1 (GJK_ROTATION_TOLERANCE); other calls renormalise inside that tolerance, so drift of an
// integrator does no harm until it is reported. Errors below are against real arithmetic on the same integer
// input, the largest of any component; tests/unit/test_pose.c holds them.
#ifndef GJK_POSE_H
#define GJK_POSE_H

#include "gjk/format.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Accepted deviation of |q|^2 from 1, Q2.30.
#define GJK_ROTATION_TOLERANCE ((gjk_q30)16384)

// Rotation by an angle about an axis. axis: any vector but zero, in any scale; out: within 2 LSB.
gjk_status gjk_quat_from_axis_angle(const gjk_vec3 *axis, gjk_q16 angle, gjk_quat *out);

// Rotation about fixed x, then fixed y, then fixed z (roll, pitch, yaw). out: within 4 LSB.
gjk_status gjk_quat_from_euler(gjk_q16 x, gjk_q16 y, gjk_q16 z, gjk_quat *out);

// The unit quaternion along q, any length but 0. q and out may be the same. Within 2 LSB.
gjk_status gjk_quat_normalize(const gjk_quat *q, gjk_quat *out);

// First b, then a (the product a b), normalised. Any of the three may be the same. Within 3 LSB.
gjk_status gjk_quat_compose(const gjk_quat *a, const gjk_quat *b, gjk_quat *out);

// The opposite rotation: the conjugate, exact.
gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out);

// v rotated by q; v and out may be the same. |v| at most 32767 units. Within 1 LSB for |v| up to 4095 units,
// 8 LSB beyond. GJK_ERROR_RANGE when a component leaves int32.
gjk_status gjk_quat_apply(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 *out);

// First b, then a. GJK_ERROR_RANGE when the position leaves int32.
gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out);

// The pose that undoes p.
gjk_status gjk_pose_invert(const gjk_pose *p, gjk_pose *out);

// The world position of point v of p's frame; v and out may be the same. As gjk_quat_apply, plus the position.
gjk_status gjk_pose_apply(const gjk_pose *p, const gjk_vec3 *v, gjk_vec3 *out);

#ifdef __cplusplus
}
#endif

#endif
