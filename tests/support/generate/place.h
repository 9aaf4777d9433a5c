// Where the second shape of a pair stands.
#ifndef GENERATE_PLACE_H
#define GENERATE_PLACE_H

#include "case/case.h"
#include "random.h"

// Rotates both and puts them somewhere, the centres factor times the sum of the radii apart.
void generate_apart(random_state *random, double factor, case_pair *pair);

// Moves B, apart or not, along the nearest vector until the gap is about gap LSB, as exactly as the lattice allows.
void generate_near(random_state *random, gjk_q16 gap, case_pair *pair);

// Moves both alike as far as int32 centres allow, towards a random corner of the world.
void generate_outermost(random_state *random, case_pair *pair);

// Turns a shape into a hull with the same integer vertices, at the identity rotation.
void generate_bake(case_shape *shape);

#endif
