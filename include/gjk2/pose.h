// Rotations and poses of the plane in integers: make, normalise, compose, invert, apply.
//
// Rotations are unit complex numbers c + i s in Q2.30, angles Q16.16 radians (gjk_angle). A rotation counts as a unit
// while c^2 + s^2 is within GJK2_ROTATION_TOLERANCE of 1, exactly. Every call takes such an r for r / |r|, so an
// integrator's drift does no harm within the tolerance. A status reports what is beyond it.
//
// Errors  against real arithmetic on the same integer input, the largest of any component, for every input;
//         tests/check/unit/test_plane_pose.c holds them.
// Outputs written only when the result is GJK_OK; an output may be the same object as an input of its type.
// Statuses NULL; ROTATION for a rotation that is not a unit; RANGE where said.
// Cost    no loop depends on a value.
#ifndef GJK2_POSE_H
#define GJK2_POSE_H

#include "gjk/status.h"
#include "gjk2/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// Accepted deviation of c^2 + s^2 from 1, Q2.30: 2^-16.
#define GJK2_ROTATION_TOLERANCE ((gjk_q30)16384)

// Rotation by an angle, counterclockwise. angle: any, more than a turn included; 0 gives exactly the identity. out:
// within 1 LSB.
gjk_status gjk2_rotation_from_angle(gjk_angle angle, gjk2_rotation *out);

// The rotation with the cosine and sine of r, which has any length but 0 (ROTATION): r / |r|. Within 0.501 LSB.
gjk_status gjk2_rotation_normalize(const gjk2_rotation *r, gjk2_rotation *out);

// Both rotations, in either order: the product a b, normalised. Within 0.501 LSB, so the product of unit rotations
// stays one.
gjk_status gjk2_rotation_compose(const gjk2_rotation *a, const gjk2_rotation *b, gjk2_rotation *out);

// The opposite rotation: the conjugate, exact.
gjk_status gjk2_rotation_invert(const gjk2_rotation *r, gjk2_rotation *out);

// v rotated by r. Within 0.51 LSB; the identity is exact. RANGE when a component
// of the result leaves int32.
gjk_status gjk2_rotation_apply(const gjk2_rotation *r, const gjk2_vec *v, gjk2_vec *out);

// First b, then a. The rotation is that of gjk2_rotation_compose, the position that of gjk2_pose_apply.
gjk_status gjk2_pose_compose(const gjk2_pose *a, const gjk2_pose *b, gjk2_pose *out);

// The pose that undoes p. Its rotation is exact, its position as accurate as gjk2_rotation_apply.
gjk_status gjk2_pose_invert(const gjk2_pose *p, gjk2_pose *out);

// The world position of point v of p's frame: as accurate as gjk2_rotation_apply, since p's position is added exactly.
// RANGE when a component of the sum leaves int32.
gjk_status gjk2_pose_apply(const gjk2_pose *p, const gjk2_vec *v, gjk2_vec *out);

#ifdef __cplusplus
}
#endif

#endif
