// Lengths and angles in fixed point of 80 fraction bits, Q80, by integers of 256 bits.
#ifndef GJK_SRC_BIG_ANGLE_H
#define GJK_SRC_BIG_ANGLE_H

#include "gjk_big.h"

#define GJK_BIG_FRACTION 80

// pi 2^96, rounded down.
extern const gjk_big gjk_big_pi_q96;

// x = floor(sqrt(x)). Pre: 0 <= x < 2^254.
void gjk_big_root(gjk_big *x);

// x = sqrt(x) in Q80, rounded down, by less than 2^-80 and less than 2^-64 where x >= 2^94. Pre: 0 <= x < 2^126.
void gjk_big_length(gjk_big *x);

// *out = the angle of (x, y), from 0 to pi, in Q80, within 2^-79 and rounded down where it is not exact.
// Pre: y >= 0, and not both are 0; both are below 2^250 in size.
void gjk_big_angle(const gjk_big *x, const gjk_big *y, gjk_big *out);

#endif
