// A shape swept along a way: the convex hull of its place at the start and at the end.
//
// Sweep one shape along its way against the other. The shapes come within a distance on the way exactly if the swept
// shape is within that distance of the other. Queries answer that as for any pair, exactly for polytopes.
#ifndef GJK_SRC_SWEPT_H
#define GJK_SRC_SWEPT_H

#include "../shape/gjk_shape_class.h"
#include "gjk_way.h"

typedef struct gjk_swept {
  gjk_collider still, swept;  // copies near the world's origin: A at the start, and all of B's places against it
  gjk_shape shape;            // the swept one's
  const gjk_collider *b;
  uint16_t count;        // B's vertices
  gjk_vec3 back, ahead;  // from the swept centre to B's at the start, and at the end
} gjk_swept;

// Fills *s, which must then stay where it is. False: the way is too long to be swept, or B has more than 32767 vertices.
//   the way's length and twice both core radii   less than 2^30 - 2^18: 16380 units
// Vertices of the swept shape: those of B at the start, then those at the end.
// Pre: both are polytopes, and spheres of a radius below 2^32 about the centres meet on the way.
bool gjk_swept_set(gjk_swept *s, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

#endif
