// Polygons cut by planes.
#ifndef GJK_SRC_CLIP_H
#define GJK_SRC_CLIP_H

#include "gjk/shape.h"
#include "vector.h"

// Each plane adds one corner at most.
#define GJK_CLIP_MAX (2 * GJK_FACE_CORNERS_MAX)

typedef struct gjk_clip_corner {
  gjk_vec3 v;
  uint16_t id;    // what made it: an original corner, or an edge and a plane
  uint8_t label;  // of the edge that starts here
} gjk_clip_corner;

// A point, two ends of an edge, or the corners of a polygon.
typedef struct gjk_clip {
  gjk_clip_corner corner[GJK_CLIP_MAX];
  unsigned count;
} gjk_clip;

// Keeps what lies behind the plane across d through point, or on it. plane: its number, below 16, for the ids.
// Pre: coordinates at most 3 2^28 in size, |d| <= sqrt(3) 2^30.
void gjk_clip_behind(gjk_clip *clip, const gjk_vec3 *point, const gjk_vec3 *d, unsigned plane);

#endif
