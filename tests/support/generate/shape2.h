// Random shapes and poses of the plane.
#ifndef GENERATE_SHAPE2_H
#define GENERATE_SHAPE2_H

#include "generate2.h"

// Largest reach of a core: that of any polygon within it keeps GJK2_RADIUS_MAX.
#define GENERATE2_REACH_MAX (GJK2_RADIUS_MAX / 4 * 3)

// A number from 0 to below 1.
double generate2_unit(random_state *random);

// A size from 3 LSB to GENERATE2_REACH_MAX; every order of magnitude is equally likely.
gjk_q16 generate2_reach(random_state *random);

// A vector of about that length in a random direction, rounded to LSB.
gjk2_vec generate2_vector(random_state *random, double length);

// None, a quarter turn, almost a quarter turn, or any.
gjk2_rotation generate2_rotation(random_state *random);

// A point, segment, triangle, box or polygon.
case2_kind generate2_kind(random_state *random);

// Makes a shape of the kind within reach of its origin. A polygon has 1 to GENERATE2_VERTICES_MAX points: in order or
// in none, some repeated, some in a line or inside.
void generate2_shape(random_state *random, case2_kind kind, gjk_q16 reach, case2_shape *out);

// The same, 10,000 times longer than thick.
void generate2_sliver(random_state *random, case2_kind kind, gjk_q16 reach, case2_shape *out);

// Adds points that change nothing: repeated ones and some within edges and inside; then shuffles all, or reverses them.
void generate2_disorder(random_state *random, case2_shape *polygon);

// Gives a polygon its corners alone, counterclockwise.
void generate2_order(case2_shape *polygon);

// Turns both shapes and puts B's origin at factor times both reaches from A's, anywhere in the world.
void generate2_apart(random_state *random, double factor, case2_pair *pair);

// Moves B to the given gap from A, as nearly as integer coordinates allow.
void generate2_near(random_state *random, gjk_q16 gap, case2_pair *pair);

// Moves both by the same way towards a random corner of the world, as far as int32_t lets their bounding boxes go.
void generate2_outermost(random_state *random, case2_pair *pair);

#endif
