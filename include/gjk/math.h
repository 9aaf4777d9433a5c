// Vectors for programs that use the library, and rotations that aim, with the numbers of gjk/number.h.
//
// Every input has a defined result: a value beyond the range of its type becomes the end of that range. Errors are
// against real arithmetic on the same integers; tests/check/unit/test_math.c checks them.
#ifndef GJK_MATH_H
#define GJK_MATH_H

#include "gjk/number.h"
#include "gjk/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

// a + b, a - b, and a times the number s, each component to the nearest.
gjk_vec3 gjk_vec3_add(const gjk_vec3 *a, const gjk_vec3 *b);
gjk_vec3 gjk_vec3_subtract(const gjk_vec3 *a, const gjk_vec3 *b);
gjk_vec3 gjk_vec3_scale(const gjk_vec3 *a, gjk_q16 s);

// a . b, Q32.32, exact unless it leaves int64.
int64_t gjk_vec3_dot(const gjk_vec3 *a, const gjk_vec3 *b);

// a x b, Q16.16, each component to the nearest, ties up.
gjk_vec3 gjk_vec3_cross(const gjk_vec3 *a, const gjk_vec3 *b);

// |a|, Q16.16, to the nearest; always fits.
uint32_t gjk_vec3_length(const gjk_vec3 *a);

// a / |a|, Q2.30, within 0.501 LSB. Statuses: NULL; ROTATION (a is zero). Errors leave out as it was.
gjk_status gjk_vec3_normalize(const gjk_vec3 *a, gjk_unit3 *out);

// The angle between two directions, from 0 to pi, within 0.501 LSB. If either is zero, the angle is 0.
gjk_angle gjk_vec3_angle(const gjk_vec3 *a, const gjk_vec3 *b);

// The shortest rotation that takes the direction of from to that of to, within 12 LSB of Q2.30. For opposite directions
// it is half a turn. Its axis is perpendicular to from, near the coordinate axis along which from points least.
// Statuses: NULL; ROTATION (a zero vector). Errors leave out as it was.
//
// gjk_quat_from_euler(0, elevation, azimuth, out) makes a rotation from two angles, first elevation, then azimuth.
gjk_status gjk_quat_between(const gjk_vec3 *from, const gjk_vec3 *to, gjk_quat *out);

// The orientation after turning about the axis of velocity for a time. |velocity| is in radians per unit of time,
// Q16.16. time is in that unit, Q2.30 from 0 to 1. The result is as accurate as gjk_motion_pose of gjk/impact.h. The
// angle is not rounded, so small steps do not drift. Statuses: NULL; ROTATION; RANGE (time), and out is as it was.
gjk_status gjk_quat_integrate(const gjk_quat *rotation, const gjk_vec3 *velocity, gjk_q30 time, gjk_quat *out);

// The pose and half length of a segment or capsule from p to q; it lies along local z. The half length is rounded to
// the nearest; above 16384 units it is within 1.5 LSB. Up to a half length of 4095 units, the ends are within 2 LSB of
// p and q. Equal points give half length 0 and the identity. Statuses: NULL; RANGE: the half length leaves int32.
// Errors leave outputs as they were.
gjk_status gjk_pose_between(const gjk_vec3 *p, const gjk_vec3 *q, gjk_pose *out, gjk_q16 *half_length);

#ifdef __cplusplus
}
#endif

#endif
