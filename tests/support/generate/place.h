// Places the shapes of a pair.
#ifndef GENERATE_PLACE_H
#define GENERATE_PLACE_H

#include "case/case.h"
#include "random.h"

// Rotates both shapes and puts them anywhere, with their centres factor times the sum of their radii apart.
void generate_apart(random_state *random, double factor, case_pair *pair);

// Moves B along the line of the nearest points until it is gap LSB from A, as nearly as integer coordinates allow.
void generate_near(random_state *random, gjk_q16 gap, case_pair *pair);

// Moves both by the same way towards a random corner of the world, as far as int32_t lets their centres go.
void generate_outermost(random_state *random, case_pair *pair);

// Makes a shape the hull of its vertices as posed, at the identity rotation.
void generate_bake(case_shape *shape);

#endif
