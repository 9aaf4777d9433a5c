// Hulls that have faces: prisms.
#ifndef GENERATE_PRISM_H
#define GENERATE_PRISM_H

#include "../case/case.h"

#define GENERATE_SIDES_MAX 8

// Room for a prism's faces; faces points into the rest.
typedef struct generate_faces {
  uint16_t corner[6 * GENERATE_SIDES_MAX], end[GENERATE_SIDES_MAX + 2];
  gjk_hull_faces faces;
} generate_faces;

// Makes shape the prism along z of 3 to GENERATE_SIDES_MAX sides within its size: the base counterclockwise from above,
// then the top. Where the size is a few LSB, vertices may coincide.
void generate_prism(unsigned sides, case_shape *shape, generate_faces *out);

#endif
