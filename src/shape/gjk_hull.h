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

// Moves *at to the vertex with this offset if it is strictly farther along the exact direction; counts it if equally
// far.
static inline void gjk_hull_refine_to(gjk_direction *direction, const gjk_vec3 *offset, uint16_t vertex,
                                      gjk_support *at) {
  const gjk_vec3 step = gjk_sub(*offset, at->offset);
  const int side = gjk_direction_sign(direction, &step);
  if (side > 0) {
    at->offset = *offset;
    at->vertex = vertex;
    direction->ties = 0;
  } else if (side == 0) {
    direction->ties++;
  }
}

// *local = d in the shape's frame. Returns how far behind along *local the vertex may be that is farthest along d when
// posed.
int64_t gjk_hull_local_direction(const gjk_collider *c, const gjk_vec3 *d, gjk_vec3 *local);

// The offset of a vertex v of the shape from the rounded centre, posed by rows.
gjk_vec3 gjk_hull_pose_vertex(const gjk_collider *c, const gjk_vec3 rows[3], const gjk_vec3 *v);

// Functions of gjk_class_hull that both classes have.
gjk_status gjk_hull_measure(const gjk_shape *shape, gjk_extent *out);
void gjk_hull_pose(gjk_collider *c, const gjk_vec3 rows[3]);
bool gjk_hull_vertex(const gjk_collider *c, uint16_t number, gjk_vec3 *offset);

#endif
