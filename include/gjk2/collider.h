// Colliders of the plane: a shape at a pose, in RAM.
//
// Posing is the only place where the geometry of polygons is rounded: rotated vertices and half axes go to the nearest
// LSB. From then on points, segments, triangles, boxes and polygons are integers. Queries treat them exactly, as the
// convex hull of those integers. Rounding may change which vertices of a polygon of a few LSB are corners.
#ifndef GJK2_COLLIDER_H
#define GJK2_COLLIDER_H

#include "gjk/status.h"
#include "gjk2/format.h"
#include "gjk2/shape.h"

#ifdef __cplusplus
extern "C" {
#endif

// Axis-aligned bounding box (AABB), world frame, both corners inclusive.
typedef struct gjk2_aabb {
  gjk2_vec lower, upper;  // the corners with the least and the largest coordinates
} gjk2_aabb;

// Start from zeroed memory; gjk2_collider_init and gjk2_collider_pose fill it. You may read two fields, centre and
// radius; the rest is the library's. centre is where the middle of the core's own bounding box lies in the world. A
// circle of radius about centre holds the shape, convex radius included. Copies of a collider share shape and buffer.
typedef struct gjk2_collider {
  const gjk2_shape *shape;  // the shape given to gjk2_collider_init
  gjk2_vec *buffer;         // baked polygon: its posed vertices relative to centre; NULL otherwise
  gjk2_vec position;        // position of the pose
  gjk2_vec centre;          // world frame
  gjk2_vec local_centre;    // centre of the bounding box, shape frame
  gjk2_vec frame[3];        // half axes or posed triangle, both relative to centre; or the rotation, Q2.30
  gjk_q16 core_radius;      // bounds |vertex - centre| after posing
  gjk_q16 radius;           // core_radius plus the shape's convex radius
  uint16_t state;           // tells an initialised and a posed collider from other memory
  uint16_t count;           // number of vertices; 0 for an ellipse or custom shape
  int8_t fraction[2];       // the unrounded centre minus centre, in LSB, Q8
  bool ordered;             // the vertices are corners in counterclockwise order at every pose
} gjk2_collider;

// Binds a collider to a shape and checks the shape.
//
// collider  written as a whole, not yet posed.
// shape     the caller's, must outlive the collider.
// buffer    for a polygon: room for capacity posed vertices, at least as many as the polygon has. The polygon is then
//           baked, which is fastest. NULL: lazy, vertices are rotated on demand. The answers are the same bits. Other
//           kinds of shapes ignore the buffer.
// Statuses  NULL, SIZE, NEGATIVE, EMPTY, CAPACITY. OVERLAP: the buffer overlaps the shape's vertices or the collider.
//           RANGE: a triangle's count is not 3. UNSUPPORTED: the build leaves out this kind of shape
//           (see port/README.md).
// Cost      one pass over a polygon's vertices.
gjk_status gjk2_collider_init(gjk2_collider *collider, const gjk2_shape *shape, gjk2_vec *buffer, uint16_t capacity);

// Places the collider.
//
// Statuses  NULL, UNINITIALISED, ROTATION (see gjk2/pose.h), RANGE (the centre of the shape's box leaves int32).
// Exact     The identity rotation rounds nothing. Otherwise each vertex of a triangle or polygon is within 3/4 LSB of
//           its real place, per component, however far from the shape's origin. So is each half axis of a box or
//           segment.
gjk_status gjk2_collider_pose(gjk2_collider *collider, const gjk2_pose *pose);

// Moves a posed collider without turning it. This is exact and touches no vertex. Statuses as in gjk2_collider_pose.
gjk_status gjk2_collider_move(gjk2_collider *collider, const gjk2_vec *position);

// The AABB of a posed collider, convex radius included. It is exact for points, segments, triangles, boxes and
// polygons, and at most 2 LSB too large for others. Coordinates beyond int32 are saturated. Statuses: NULL,
// UNINITIALISED.
gjk_status gjk2_collider_aabb(const gjk2_collider *collider, gjk2_aabb *out);

#ifdef __cplusplus
}
#endif

#endif
