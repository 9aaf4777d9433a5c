// Number formats, vectors and limits of the plane.
//
// Lengths, angles, statuses and versions are those of gjk/format.h, gjk/status.h and gjk/version.h. Nothing else of
// space is needed.
#ifndef GJK2_FORMAT_H
#define GJK2_FORMAT_H

#include "gjk/format.h"

// Position, offset or half extents, Q16.16.
typedef struct gjk2_vec {
  gjk_q16 x, y;  // coordinates
} gjk2_vec;

// Unit vector, Q2.30.
typedef struct gjk2_unit {
  gjk_q30 x, y;  // components, from -GJK_Q30_ONE to GJK_Q30_ONE
} gjk2_unit;

// Rotation as the unit complex number c + i s, Q2.30: cosine and sine of an angle, counterclockwise from x to y.
// The identity is {GJK_Q30_ONE, 0}.
typedef struct gjk2_rotation {
  gjk_q30 c, s;  // cosine and sine of the angle
} gjk2_rotation;

// The pose of a shape, which is first rotated about its own origin and then moved by position.
typedef struct gjk2_pose {
  gjk2_vec position;       // of the origin of its frame
  gjk2_rotation rotation;  // a unit, see gjk2/pose.h
} gjk2_pose;

// The pose at the origin, not rotated.
#define GJK2_POSE_IDENTITY \
  {                        \
    {0, 0}, {              \
      GJK_Q30_ONE, 0       \
    }                      \
  }

// The largest radius of a shape about the centre of its core's bounding box, convex radius included: 4095 units.
#define GJK2_RADIUS_MAX GJK_RADIUS_MAX

// The most vertices of one polygon.
#define GJK2_POLYGON_VERTICES_MAX 65535

// The most iterations of gjk2_intersect, gjk2_within, gjk2_distance and their _until forms on polygons of n and m
// vertices, with or without a convex radius. src/plane/gjk2_search.h proves this bound. A box has 4 vertices, a
// triangle 3, a segment or capsule 2, a point or circle 1.
#define GJK2_ITERATIONS_OF(n, m) (3 + (n) + (m))

// An ellipse or custom shape has no vertices to count. The ceiling on the iterations of a query with one is
// GJK_ITERATIONS_MAX of gjk/format.h. Its comment applies here too.

#endif
