// Makes prisms: hulls that have faces.
#ifndef GENERATE_PRISM_H
#define GENERATE_PRISM_H

#include "case/case.h"

#define GENERATE_SIDES_MAX 8

// Makes shape a prism along z with 3 to GENERATE_SIDES_MAX sides, within the box of shape->size, with its faces. The
// vertices of the base come first, counterclockwise from above, then those of the top. They may coincide if the size is
// a few LSB.
void generate_prism(unsigned sides, case_shape *shape);

#endif
