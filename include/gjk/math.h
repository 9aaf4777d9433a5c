// Vectors for programs that use the library, and rotations that aim; with the numbers of gjk/number.h.
//
// Nothing here is undefined for any input: what leaves the range of its type becomes the end of that range. Errors are
// against real arithmetic on the same integers; tests/check/unit/test_math.c holds them.
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

// a . b, Q32.32; exact unless it leaves int64.
int64_t gjk_vec3_dot(const gjk_vec3 *a, const gjk_vec3 *b);

// a x b, Q16.16, each component to the nearest, halves up.
gjk_vec3 gjk_vec3_cross(const gjk_vec3 *a, const gjk_vec3 *b);

// |a|, Q16.16, to the nearest; always fits.
uint32_t gjk_vec3_length(const gjk_vec3 *a);

// a / |a|, Q2.30, within 0.501 LSB. Statuses: NULL; ROTATION for a zero vector, out is then as it was.
gjk_status gjk_vec3_normalize(const gjk_vec3 *a, gjk_unit3 *out);

// The angle between two directions, from 0 to pi: within 0.501 LSB. 0 where one is zero.
gjk_angle gjk_vec3_angle(const gjk_vec3 *a, const gjk_vec3 *b);

// The shortest rotation that takes the direction of from to that of to, within 12 LSB of Q2.30. Of opposite directions
// it is half a turn about an axis across that is near the coordinate axis that from points along least.
// Statuses: NULL; ROTATION for a zero vector, out is then as it was.
//
// A rotation from two angles, elevation and then azimuth, is gjk_quat_from_euler(0, elevation, azimuth, out).
gjk_status gjk_quat_between(const gjk_vec3 *from, const gjk_vec3 *to, gjk_quat *out);

// The orientation after turning about the axis of velocity for a time. |velocity| is in radians per unit of time,
// Q16.16. time is in that unit, Q2.30 from 0 to 1. As accurate as gjk_motion_pose of gjk/impact.h: the angle is not
// rounded, so small steps do not drift. Statuses: NULL; ROTATION; RANGE (time). out is written only after OK.
gjk_status gjk_quat_integrate(const gjk_quat *rotation, const gjk_vec3 *velocity, gjk_q30 time, gjk_quat *out);

// The pose and half length of a segment or capsule from p to q; it lies along z. The half length is rounded to the nearest,
// and within 1.5 LSB above 16384 units. The ends are within 2 LSB of p and q up to a half length of 4095 units. Equal points:
// half length 0 and the identity. Statuses: NULL; RANGE: the half length leaves int32. Outputs are then as they were.
gjk_status gjk_pose_between(const gjk_vec3 *p, const gjk_vec3 *q, gjk_pose *out, gjk_q16 *half_length);

#ifdef __cplusplus
}
#endif

#endif
