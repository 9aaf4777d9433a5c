// Numbers for programs that use the library: fixed-point arithmetic, vectors, angles, and rotations that aim.
//
// Nothing here is undefined for any input: what leaves the range of its type becomes the end of that range. Errors are
// against real arithmetic on the same integers; tests/check/unit/test_math.c holds them.
#ifndef GJK_MATH_H
#define GJK_MATH_H

#include "gjk/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

// a b and a / b, Q16.16, to the nearest; halves go away from zero. a / 0 is the end of the range on a's side, 0 / 0 is 0.
// A division is a loop of 31 steps, without the core's divider.
gjk_q16 gjk_q16_multiply(gjk_q16 a, gjk_q16 b);
gjk_q16 gjk_q16_divide(gjk_q16 a, gjk_q16 b);

// The square root, Q16.16, to the nearest; of a negative number 0.
gjk_q16 gjk_q16_sqrt(gjk_q16 x);

// Sine and cosine of any angle, each within 1 LSB of Q2.30.
void gjk_sine_and_cosine(gjk_angle angle, gjk_q30 *sine, gjk_q30 *cosine);

// The angle of the point (x, y), from -pi to pi: within 0.501 LSB. 0 for the origin, pi for y = 0 and x < 0.
gjk_angle gjk_atan2(gjk_q16 y, gjk_q16 x);

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

// The shortest rotation that takes the direction of from to that of to, within 12 LSB of Q2.30. Of opposite directions
// it is half a turn about an axis across that is near the coordinate axis that from points along least.
// Statuses: NULL; ROTATION for a zero vector, out is then as it was.
gjk_status gjk_quat_between(const gjk_vec3 *from, const gjk_vec3 *to, gjk_quat *out);

// The orientation after turning about the axis of velocity for a time. |velocity| is in radians per unit of time, Q16.16;
// time is of that unit, Q2.30 from 0 to 1. As accurate as gjk_motion_pose of gjk/impact.h: the angle is not rounded, so
// small steps do not drift. Statuses: NULL; ROTATION; RANGE (time). out is written only after OK.
gjk_status gjk_quat_integrate(const gjk_quat *rotation, const gjk_vec3 *velocity, gjk_q30 time, gjk_quat *out);

// The pose and half length of a segment or capsule, which lies along z, from p to q. The half length is within 1.5 LSB, the
// ends are within 2 LSB of p and q up to a half length of 4095 units. Equal points: half length 0 and the identity.
// Statuses: NULL; RANGE: the half length leaves int32. Outputs are then as they were.
gjk_status gjk_pose_between(const gjk_vec3 *p, const gjk_vec3 *q, gjk_pose *out, gjk_q16 *half_length);

#ifdef __cplusplus
}
#endif

#endif
