// Fixed-point numbers for programs that use the library, in space and in the plane: products, quotients, roots, angles.
//
// Every input has a defined result: a value beyond the range of its type becomes the end of that range. Errors are
// against real arithmetic on the same integers. tests/check/unit/test_numbers.c checks them; `make numbers` tries every
// input of the functions of one number.
#ifndef GJK_NUMBER_H
#define GJK_NUMBER_H

#include "gjk/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// The product a b and the quotient a / b, Q16.16, to the nearest; halves go away from zero. a / 0 is the end of the
// range with a's sign, and 0 / 0 is 0. A division is a loop of 31 steps, without the core's divider.
gjk_q16 gjk_q16_multiply(gjk_q16 a, gjk_q16 b);
gjk_q16 gjk_q16_divide(gjk_q16 a, gjk_q16 b);

// The square root, Q16.16, to the nearest; 0 for a negative number.
gjk_q16 gjk_q16_sqrt(gjk_q16 x);

// Sine and cosine of any angle, each within 0.83 LSB of Q2.30.
void gjk_sine_and_cosine(gjk_angle angle, gjk_q30 *sine, gjk_q30 *cosine);

// The angle of the point (x, y), from -pi to pi: within 0.501 LSB. 0 for the origin, pi for y = 0 and x < 0.
gjk_angle gjk_atan2(gjk_q16 y, gjk_q16 x);

#ifdef __cplusplus
}
#endif

#endif
