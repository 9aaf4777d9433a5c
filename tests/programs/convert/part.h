// Convex parts: hulls of integer points, with the planes of their facets.
#ifndef PART_H
#define PART_H

#include "solid.h"

// Coordinates are counted from the solid's origin. Faces turn counterclockwise, as gjk_hull_faces has them.
typedef struct part {
  int32_t (*point)[3];
  unsigned points;
  uint16_t *corner, *end;
  unsigned faces;
  solid_plane *plane;  // one a face
  int32_t low[3], high[3];
  solid_wide volume6;
} part;

// The hull of points. False: they lie in a plane, or there are more than 65535, or its faces have more corners than that.
bool part_build(part *p, int32_t (*point)[3], size_t points);

void part_free(part *p);

// Is a point in it?
bool part_has(const part *p, const int32_t x[3]);

#endif
