// Colliders: a shape at a pose, in RAM.
//
// Posing is the one place where geometry is rounded: rotated vertices and half axes go to the nearest LSB.
// From then on points, segments, triangles, boxes and hulls are integers, and queries treat them exactly.
#ifndef GJK_COLLIDER_H
#define GJK_COLLIDER_H

#include "gjk/format.h"
#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Axis-aligned box, world frame, both corners inclusive.
typedef struct gjk_aabb {
  gjk_vec3 lower, upper;
} gjk_aabb;

// Start from zeroed memory; gjk_collider_init and gjk_collider_pose fill it. Contents are the library's; read
// centre (world centre of the shape's own bounding box) and radius (of a sphere about it that holds the
// shape, rounding included) as you like. Copyable while shape, buffer and contents stay in place.
typedef struct gjk_collider {
  const gjk_shape *shape;
  gjk_vec3 *buffer;       // baked hull: its posed vertices relative to centre; NULL otherwise
  gjk_vec3 position;      // of the pose
  gjk_vec3 centre;        // world
  gjk_vec3 local_centre;  // of the bounding box, shape frame
  gjk_vec3 frame[3];      // half axes, or posed triangle, both relative to centre; or rotation rows, Q2.30
  gjk_q16 core_radius;    // bounds |vertex - centre| after posing
  gjk_q16 radius;         // core_radius plus the shape's rounding
  uint16_t state;         // tells an initialised and a posed collider from other memory
  uint16_t count;         // half axes of a point, segment or box; vertices of a triangle or hull
  uint8_t bits;           // core_radius is below 2^bits
  int8_t fraction[3];     // of an LSB, Q8: from centre to where it is without rounding
} gjk_collider;

// Binds a collider to a shape and checks the shape.
//
// collider  written whole, not yet posed.
// shape     the caller's, must outlive the collider.
// buffer    a hull's room for capacity posed vertices (at least the hull's count): baked, fastest, exact.
//           NULL: lazy, vertices are rotated as they are needed; the answers are the same bits, the scan is
//           of about the same cost, and each vertex used costs a rotation. Other kinds ignore it.
// Statuses  NULL, SIZE, NEGATIVE, EMPTY, CAPACITY, OVERLAP (the buffer with the shape's vertices or with the
//           collider), RANGE (a triangle whose count is not 3; a face of a hull with less than 3 or too many
//           corners, or with one that there isn't).
// Cost      one pass over a hull's vertices.
gjk_status gjk_collider_init(gjk_collider *collider, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity);

// Places the collider.
//
// Statuses  NULL, UNINITIALISED, ROTATION (see gjk/pose.h), RANGE (the centre of the shape's box leaves int32).
// Exact     identity rotation moves without rounding. Otherwise each vertex of a triangle or hull lies within 3/4 LSB of its
//           real place, per component, however far from the shape's origin; a box's or segment's half axes do.
gjk_status gjk_collider_pose(gjk_collider *collider, const gjk_pose *pose);

// Moves a posed collider, keeping its rotation: exact, and no vertex is touched. Statuses as gjk_collider_pose.
gjk_status gjk_collider_move(gjk_collider *collider, const gjk_vec3 *position);

// The box of a posed collider, rounding included: exact for points, segments, triangles, boxes and hulls,
// otherwise at most 2 LSB too large. Sides beyond int32 are cut off there. Statuses: NULL, UNINITIALISED.
gjk_status gjk_collider_aabb(const gjk_collider *collider, gjk_aabb *out);

#ifdef __cplusplus
}
#endif

#endif
