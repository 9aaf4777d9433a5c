// What the steps of gjk_hull_simplify share, and its step 3: vertices that go outwards.
#ifndef GJK_SRC_HULL_SIMPLE_H
#define GJK_SRC_HULL_SIMPLE_H

#include "gjk_hull_facets.h"

// The parts of a workspace, and where the work stands.
typedef struct gjk_hull_simple_work {
  const gjk_vec3 *points;
  void *hull;  // workspace of hulls
  size_t bytes;
  gjk_vec3 *vertex, *moved;  // of the polytope, and room for as many
  gjk_unit3 *unit;           // of each triangle of the polytope: its normal
  uint16_t *touch;           // and the first point that is farthest along it
  uint16_t *core;            // of each vertex: the point that its way begins at
  uint16_t *extreme;         // the points that are vertices of their hull
  uint16_t extremes, count;  // of extreme and of vertex
  gjk_vec3 lower, upper;     // where vertices may be
  gjk_hull_work triangles;   // of the polytope
} gjk_hull_simple_work;

// Is it a triangle of the hull, not a free place?
static inline bool gjk_hull_is_in_use(const gjk_hull_triangle *t) {
  return (t->flags & GJK_HULL_SEEN) == 0;
}

// The squared distance. Pre: components of the difference are below 2^30.
static inline uint64_t gjk_hull_squared_between(const gjk_vec3 *a, const gjk_vec3 *b) {
  const gjk_vec3 d = gjk_sub(*a, *b);
  return (uint64_t)gjk_dot(&d, &d);
}

// The point that is farthest beyond a plane, of equals the first.
uint16_t gjk_hull_farthest_beyond(const gjk_hull_simple_work *s, const gjk_hull_plane *plane);

// Sets what is kept of each triangle: its normal and the point that is farthest along it.
void gjk_hull_look_along(gjk_hull_simple_work *s);

// Step 3: moves all vertices. Step 4, again: moves those that get nearer. False: a vertex was not found.
bool gjk_hull_move_vertices(gjk_hull_simple_work *s, bool again);

#endif
