// Random shapes of one kind at random poses, for comparing the library with floating point.
#ifndef RANDOM_SHAPE_H
#define RANDOM_SHAPE_H

#include "case/case.h"
#include "random.h"

#define RANDOM_REACH_MIN 3
#define RANDOM_REACH_MAX (4000 * 65536)

// From 0 to 1.
double random_unit(random_state *random);

// A size from 3 LSB to 4000 units, evenly spread over the orders of magnitude.
gjk_q16 random_reach(random_state *random);

// A shape of the kind that stays within reach of its centre, aspect up to 10,000, some of them flat; a third
// rounded. Hulls have
// 4 to 64 vertices.
void random_shape(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out);

// A rotation: identity, a quarter turn or anything, of a length that is off by as much as is allowed.
gjk_quat random_rotation(random_state *random);

// A vector of the length, to the nearest LSB, in a random direction.
gjk_vec3 random_vector(random_state *random, double length);

#endif
