// Rotations and poses of the plane in integers: make, normalise, compose, invert, apply.
//
// Rotations are unit complex numbers c + i s in Q2.30, angles Q16.16 radians (gjk_angle). A rotation is a unit if c^2 +
// s^2 is within GJK2_ROTATION_TOLERANCE of 1; that test is exact. Every call takes such an r as r / |r|, so the drift
// of an integrator does no harm within the tolerance. Beyond it, a call returns a status.
//
// Errors  are against real arithmetic on the same integer input, for every input, and bound every component.
//         tests/check/unit/test_plane_pose.c checks them.
// Outputs are written only when the result is GJK_OK. An output may be the same object as an input of its type.
// Statuses NULL; ROTATION for a rotation that is not a unit; RANGE where stated.
// Cost    the length of no loop depends on a value.
#ifndef GJK2_POSE_H
#define GJK2_POSE_H

#include "gjk/status.h"
#include "gjk2/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// The accepted deviation of c^2 + s^2 from 1, Q2.30: 2^-16.
#define GJK2_ROTATION_TOLERANCE ((gjk_q30)16384)

// The rotation by any angle, even more than a turn, counterclockwise, within 1 LSB. 0 gives exactly the identity.
gjk_status gjk2_rotation_from_angle(gjk_angle angle, gjk2_rotation *out);

// The unit rotation along r, which is r / |r|, within 0.501 LSB. r has any length but 0 (ROTATION).
gjk_status gjk2_rotation_normalize(const gjk2_rotation *r, gjk2_rotation *out);

// Both rotations, in either order: the product a b, normalised, within 0.501 LSB. So products of units stay units.
gjk_status gjk2_rotation_compose(const gjk2_rotation *a, const gjk2_rotation *b, gjk2_rotation *out);

// The opposite rotation: the conjugate, exact.
gjk_status gjk2_rotation_invert(const gjk2_rotation *r, gjk2_rotation *out);

// The vector v rotated by r, within 0.51 LSB. The identity is exact. RANGE: a component of the result leaves int32.
gjk_status gjk2_rotation_apply(const gjk2_rotation *r, const gjk2_vec *v, gjk2_vec *out);

// The pose b, then a. Its rotation is that of gjk2_rotation_compose, its position that of gjk2_pose_apply.
gjk_status gjk2_pose_compose(const gjk2_pose *a, const gjk2_pose *b, gjk2_pose *out);

// The pose that undoes p. Its rotation is exact, and its position is as accurate as gjk2_rotation_apply.
gjk_status gjk2_pose_invert(const gjk2_pose *p, gjk2_pose *out);

// The world position of point v of p's frame. It is as accurate as gjk2_rotation_apply, because p's position is added
// exactly. RANGE: a component of the sum leaves int32.
gjk_status gjk2_pose_apply(const gjk2_pose *p, const gjk2_vec *v, gjk2_vec *out);

#ifdef __cplusplus
}
#endif

#endif
