// Makes random shapes of a kind at random poses, for tests that compare the library with floating point.
#ifndef RANDOM_SHAPE_H
#define RANDOM_SHAPE_H

#include "case/case.h"
#include "random.h"

#define RANDOM_REACH_MIN 3
#define RANDOM_REACH_MAX (4000 * 65536)

// A number from 0 to 1.
double random_unit(random_state *random);

// A size from RANDOM_REACH_MIN to RANDOM_REACH_MAX LSB, 4000 units; every order of magnitude is equally likely.
gjk_q16 random_reach(random_state *random);

// Makes a shape of the kind that stays within reach of its centre: up to 10,000 times longer than thick, some flat, a
// third with a convex radius. A hull has 4 to 64 vertices.
void random_shape(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out);

// The identity, a quarter turn or any rotation. The length of the quaternion is off by up to what poses allow.
gjk_quat random_rotation(random_state *random);

// A vector of that length in a random direction, rounded to LSB.
gjk_vec3 random_vector(random_state *random, double length);

#endif
