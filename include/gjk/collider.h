// Colliders: a shape at a pose, in RAM.
//
// Posing is the only place where the geometry of polytopes is rounded: rotated vertices and half axes go to the
// nearest LSB. From then on points, segments, triangles, boxes and hulls are integers, and queries treat them exactly.
#ifndef GJK_COLLIDER_H
#define GJK_COLLIDER_H

#include "gjk/format.h"
#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Axis-aligned bounding box (AABB), world frame, both corners inclusive.
typedef struct gjk_aabb {
  gjk_vec3 lower, upper;  // the corners with the least and the largest coordinates
} gjk_aabb;

// Start from zeroed memory; gjk_collider_init and gjk_collider_pose fill it. You may read two fields, centre and
// radius; the rest is the library's. centre is where the middle of the core's own bounding box lies in the world. A
// sphere of radius about centre holds the shape, convex radius included. Copies of a collider share shape and buffer.
typedef struct gjk_collider {
  const gjk_shape *shape;  // the shape given to gjk_collider_init
  gjk_vec3 *buffer;        // baked hull: its posed vertices relative to centre; NULL otherwise
  gjk_vec3 position;       // position of the pose
  gjk_vec3 centre;         // world frame
  gjk_vec3 local_centre;   // centre of the bounding box, shape frame
  gjk_vec3 frame[3];       // half axes or posed triangle, relative to centre; or rotation rows, Q2.30, also of a baked
                           // hull with a table
  gjk_q16 core_radius;     // bounds |vertex - centre| after posing
  gjk_q16 radius;          // core_radius plus the shape's convex radius
  uint16_t state;          // tells an initialised and a posed collider from other memory
  uint16_t count;          // number of half axes of a point, segment or box; of vertices of a triangle or hull
  uint8_t bits;            // core_radius is below 2^bits
  int8_t fraction[3];      // the unrounded centre minus centre, in LSB, Q8
} gjk_collider;

// Binds a collider to a shape and checks the shape.
//
// collider  written as a whole, not yet posed.
// shape     the caller's, must outlive the collider.
// buffer    for a hull: room for capacity posed vertices, at least as many as the hull has. The hull is then baked,
//           which is fastest. NULL: lazy, vertices are rotated on demand. The answers are the same bits. A scan costs
//           about the same, but each vertex that is used costs a rotation. Other kinds of shapes ignore the buffer.
// Statuses  NULL, SIZE, NEGATIVE, EMPTY, CAPACITY. OVERLAP: the buffer overlaps the shape's vertices or the collider.
//           RANGE: a triangle's count is not 3, or a table's level, ends or numbers are not as in gjk/shape.h. Also
//           RANGE: a face has fewer than 3 or more than GJK_FACE_CORNERS_MAX corners, or one that is no vertex.
//           UNSUPPORTED: the build leaves out this kind of shape (see port/README.md).
// Cost      one pass over a hull's vertices, faces and table.
gjk_status gjk_collider_init(gjk_collider *collider, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity);

// Places the collider.
//
// Statuses  NULL, UNINITIALISED, ROTATION (see gjk/pose.h), RANGE (the centre of the shape's box leaves int32).
// Exact     The identity rotation rounds nothing. Otherwise each vertex of a triangle or hull is within 3/4 LSB of its
//           real place, per component, however far from the shape's origin. So is each half axis of a box or segment.
gjk_status gjk_collider_pose(gjk_collider *collider, const gjk_pose *pose);

// Moves a posed collider without turning it. This is exact and touches no vertex. Statuses as in gjk_collider_pose.
gjk_status gjk_collider_move(gjk_collider *collider, const gjk_vec3 *position);

// The AABB of a posed collider, convex radius included. It is exact for points, segments, triangles, boxes and hulls,
// and at most 2 LSB too large for others. Coordinates beyond int32 are saturated. Statuses: NULL, UNINITIALISED.
gjk_status gjk_collider_aabb(const gjk_collider *collider, gjk_aabb *out);

#ifdef __cplusplus
}
#endif

#endif
