// Hulls that have faces: prisms.
#ifndef GENERATE_PRISM_H
#define GENERATE_PRISM_H

#include "case/case.h"

#define GENERATE_SIDES_MAX 8

// Makes shape the prism along z of 3 to GENERATE_SIDES_MAX sides within its size, with its faces: the base
// counterclockwise from above, then the top. Where the size is a few LSB, vertices may coincide.
void generate_prism(unsigned sides, case_shape *shape);

#endif
