// A convex polytope of triangles that grows point by point: the quickhull algorithm with exact signs.
//
// Points are known by their numbers in the order of their coordinates, repeated ones once. Each point that lies beyond
// a triangle is in the list of one of them. While there is such a point:
//
//   1. Take the farthest point of its triangle's list.
//   2. From that triangle on, find all triangles that see the point: those that it lies strictly beyond. They are
//      connected, and the edges between them and the rest, the horizon, form one ring.
//   3. Put triangles from the horizon's edges to the point in their place.
//   4. Points of lists that lost their triangle join the list of a new triangle that they lie beyond. Those beyond none
//      lie in the hull.
//
// No triangle degenerates. The point lies strictly beyond the seen triangle at each edge of the horizon, so it is not in
// line with that edge. Points in the plane of a triangle do not see it; so triangles may be coplanar with others.
// gjk_hull_facets.c joins them.
//
// In step 4 a point q that is still outside lies beyond some new triangle. On the old polytope the triangles that q sees
// are connected. One of them is gone. If one of the rest is left, the way between them crosses the horizon, at an edge
// with both sides seen by q. The plane of the new triangle there is a combination of both planes. Both weights
// are at least 0, that of the seen one is above 0. So q is beyond it. If none is left, q sees only new ones.
#ifndef GJK_SRC_HULL_GROW_H
#define GJK_SRC_HULL_GROW_H

#include "../arith/gjk_vector.h"
#include "gjk/hull.h"

// Number i of vertex begins the edge to the next one; side i is the triangle across it. Counterclockwise from outside.
typedef struct gjk_hull_triangle {
  uint16_t vertex[3];
  uint16_t outside;  // first point of its list, or GJK_HULL_NO_POINT
  uint16_t side[3];  // the low 16 bits: there may be 2^17 triangles
  uint16_t flags;    // bit i: bit 16 of side i; and those below
} gjk_hull_triangle;

#define GJK_HULL_SEEN UINT16_C(8)        // by the point that is being added; afterwards: free for use
#define GJK_HULL_LINK_HIGH UINT16_C(16)  // bit 16 of a link between such triangles
#define GJK_HULL_FLAT UINT16_C(32)       // times 2^i: side i lies in the same plane
#define GJK_HULL_WRITTEN UINT16_C(256)   // times 2^i: the edge belongs to a facet that was visited

#define GJK_HULL_NO_POINT UINT16_MAX
#define GJK_HULL_NO_TRIANGLE UINT32_MAX
#define GJK_HULL_NO_LINK UINT32_C(0x1FFFF)

// The parts of a workspace, for n points:
//   triangle   16 bytes each: with v vertices there are 2 v - 4. So 2 n - 4 places are enough, since free ones are taken
//              first
//   of         which triangle's list the point is in; GJK_HULL_NO_TRIANGLE: none
//   order      the point's index
//   next       the next point of its list
typedef struct gjk_hull_work {
  const gjk_vec3 *points;
  gjk_hull_triangle *triangle;
  uint32_t *of;
  uint16_t *order, *next;
  uint32_t distinct;
  uint32_t triangles;  // places in use, and free ones among them
  uint32_t free;       // the first free one
} gjk_hull_work;

// The parts of a hull's workspace.
gjk_hull_work gjk_hull_work_of(const gjk_vec3 *points, void *workspace, uint32_t count);

// Are the points at most 2 GJK_RADIUS_MAX apart along each axis? Pre: there is one.
bool gjk_hull_fits(const gjk_vec3 *points, uint32_t count);

static inline const gjk_vec3 *gjk_hull_point(const gjk_hull_work *w, uint32_t number) {
  return &w->points[w->order[number]];
}

static inline uint32_t gjk_hull_side(const gjk_hull_triangle *t, unsigned i) {
  return t->side[i] | ((t->flags & 1u << i) != 0 ? UINT32_C(1) << 16 : 0);
}

// Which edge of t ends at a vertex of it.
static inline unsigned gjk_hull_edge_to(const gjk_hull_triangle *t, uint16_t vertex) {
  return t->vertex[1] == vertex ? 0 : t->vertex[2] == vertex ? 1 : 2;
}

// The plane of a triangle.
typedef struct gjk_hull_plane {
  gjk_long3 n;
  const gjk_vec3 *at;
} gjk_hull_plane;

// Points are at most 2^29 apart along each axis, so below 2^30 apart: |n| < 2^60, |n . (p - at)| < 2^90.
void gjk_hull_set_plane(const gjk_hull_work *w, const gjk_hull_triangle *t, gjk_hull_plane *out);

// n . (p - at) = 2^31 (returned) + *low, exact: above 0 beyond the plane.
static inline int64_t gjk_hull_height(const gjk_hull_plane *plane, const gjk_vec3 *p, uint32_t *low) {
  const gjk_vec3 v = gjk_sub(*p, *plane->at);
  return gjk_dot_exact(&plane->n, &v, low);
}

static inline int gjk_hull_height_sign(const gjk_hull_plane *plane, const gjk_vec3 *p) {
  const gjk_vec3 v = gjk_sub(*p, *plane->at);
  return gjk_dot_sign(&plane->n, &v);
}

// The hull of all points from a tetrahedron: numbers of four points, of which the last is below the plane of the others.
void gjk_hull_grow(gjk_hull_work *w, const uint16_t corner[4]);

#endif
