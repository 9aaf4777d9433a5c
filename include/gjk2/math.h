// Vectors of the plane for programs that use the library, and rotations that aim, with the numbers of gjk/number.h.
//
// Every input has a defined result: a value beyond the range of its type becomes the end of that range. Errors are
// against real arithmetic on the same integers; tests/check/unit/test_plane_math.c checks them. gjk2_rotation_apply of
// gjk2/pose.h rotates a vector. The angle of a vector v from x is gjk_atan2(v.y, v.x).
#ifndef GJK2_MATH_H
#define GJK2_MATH_H

#include "gjk/number.h"
#include "gjk2/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

// a + b, a - b, and a times the number s, each component to the nearest.
gjk2_vec gjk2_vec_add(const gjk2_vec *a, const gjk2_vec *b);
gjk2_vec gjk2_vec_subtract(const gjk2_vec *a, const gjk2_vec *b);
gjk2_vec gjk2_vec_scale(const gjk2_vec *a, gjk_q16 s);

// a . b and a x b, Q32.32, exact unless they leave int64. a x b is positive if b lies to the left of a.
int64_t gjk2_vec_dot(const gjk2_vec *a, const gjk2_vec *b);
int64_t gjk2_vec_cross(const gjk2_vec *a, const gjk2_vec *b);

// |a|, Q16.16, to the nearest; always fits.
uint32_t gjk2_vec_length(const gjk2_vec *a);

// a / |a|, Q2.30, within 0.501 LSB. Statuses: NULL; ROTATION (a is zero). Errors leave out as it was.
gjk_status gjk2_vec_normalize(const gjk2_vec *a, gjk2_unit *out);

// The angle from a to b, counterclockwise, from -pi to pi, within 0.501 LSB. If either is zero, the angle is 0.
gjk_angle gjk2_vec_angle(const gjk2_vec *a, const gjk2_vec *b);

// The rotation that takes the direction of from to that of to, within 2.5 LSB of Q2.30.
// Statuses: NULL; ROTATION (a zero vector). Errors leave out as it was.
gjk_status gjk2_rotation_between(const gjk2_vec *from, const gjk2_vec *to, gjk2_rotation *out);

// The rotation after turning at a velocity for a time. velocity is in radians per unit of time, Q16.16. time is in that
// unit, Q2.30 from 0 to 1. The result is as accurate as gjk2_motion_pose of gjk2/impact.h. The angle is not rounded, so
// small steps do not drift. Statuses: NULL; ROTATION; RANGE (time), and out is as it was.
gjk_status gjk2_rotation_integrate(const gjk2_rotation *rotation, gjk_angle velocity, gjk_q30 time, gjk2_rotation *out);

// The pose and half length of a segment or capsule from p to q; it lies along local x. The half length is rounded to
// the nearest; above 16384 units it is within 1.5 LSB. Up to a half length of 4095 units, the ends are within 1.5 LSB
// of p and q. Equal points give half length 0 and the identity. Statuses: NULL; RANGE: the half length leaves int32.
// Errors leave outputs as they were.
gjk_status gjk2_pose_between(const gjk2_vec *p, const gjk2_vec *q, gjk2_pose *out, gjk_q16 *half_length);

#ifdef __cplusplus
}
#endif

#endif
