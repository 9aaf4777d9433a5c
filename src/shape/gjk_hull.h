// What hulls with and without a table share: the slacks of rounding, how a vertex is posed, and the class's functions.
#ifndef GJK_SRC_HULL_H
#define GJK_SRC_HULL_H

#include "../arith/gjk_rotation.h"
#include "gjk_shape_class.h"

// How far behind along a rounded direction the vertex may be that is farthest along the exact one. Each component of
// the rounded direction is off by less than 1. With u for the difference of two vertices:
//   its product is off by less than |u.x| + |u.y| + |u.z| <= sqrt(3) 2 core_radius < 4 core_radius
static inline int64_t gjk_hull_rounding_slack(const gjk_collider *c) {
  return 4 * (int64_t)c->core_radius;
}

// The vertex's offset from the rounded centre. It is rounded once, with the fraction of an LSB that the centre's
// rounding has left. Errors per component:
//   rounding the result       <= 1/2
//   rounding the matrix       <= 2^-31 (|x| + |y| + |z|) < 0.22
//   truncating the fraction   <  2^-8
//   the centre's own error    <  2^-9
//   together                  <  3/4 LSB
static inline gjk_vec3 gjk_hull_pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 local = gjk_sub(*v, c->local_centre);  // gjk_collider_init:  |local| <= GJK_RADIUS_MAX
  return gjk_rotate_onto(rows, &local, c->fraction);
}

// *local = d in the shape's frame. Returns how far behind along *local a vertex may be that is farther along d
// when posed. With u for the difference of two vertices:
//   rounding *local, 1/2 per component               |u.x| / 2 + |u.y| / 2 + |u.z| / 2 <= sqrt(3) core_radius
//   rounding both posed vertices, 1/2 per component  |d.x| + |d.y| + |d.z| < 2^32
static inline int64_t gjk_hull_local_direction(const gjk_collider *c, const gjk_vec3 *d, gjk_vec3 *local) {
  *local = gjk_rotate_back(c->frame, d);
  return 2 * (int64_t)c->core_radius + gjk_norm1(*d) + 8;
}

// Functions of gjk_class_hull that both classes have.
gjk_status gjk_hull_measure(const gjk_shape *shape, gjk_extent *out);
void gjk_hull_pose(gjk_collider *c, const gjk_vec3 rows[3]);
bool gjk_hull_vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset);

#endif
