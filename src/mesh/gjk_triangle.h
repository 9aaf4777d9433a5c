// What a mesh and a height field share: triangles as parts of a body.
#ifndef GJK_SRC_TRIANGLE_H
#define GJK_SRC_TRIANGLE_H

#include "../parts/gjk_parts_class.h"
#include "gjk/mesh.h"

static inline bool gjk_same_place(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

// Makes a box empty, and makes it hold a point as well.
void gjk_triangle_start_box(gjk_vec3 *lower, gjk_vec3 *upper);
void gjk_triangle_widen(gjk_vec3 *lower, gjk_vec3 *upper, const gjk_vec3 *v);

// Do all three lie beyond one end of a range?
static inline bool gjk_is_beyond_range(int32_t a, int32_t b, int32_t c, int32_t low, int32_t high) {
  return (a < low && b < low && c < low) || (a > high && b > high && c > high);
}

// Is the box of a triangle apart from the region's box?
static inline bool gjk_triangle_is_apart(const gjk_aabb *box, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c) {
  const gjk_vec3 *low = &box->lower, *high = &box->upper;
  return gjk_is_beyond_range(a->x, b->x, c->x, low->x, high->x) ||
         gjk_is_beyond_range(a->y, b->y, c->y, low->y, high->y) ||
         gjk_is_beyond_range(a->z, b->z, c->z, low->z, high->z);
}

bool gjk_triangle_meets_on_way(const gjk_region *region, const gjk_vec3 corner[3]);

// Does the box of a triangle meet the region?
static inline bool gjk_triangle_meets(const gjk_region *region, const gjk_vec3 corner[3]) {
  return !gjk_triangle_is_apart(&region->box, &corner[0], &corner[1], &corner[2]) &&
         (!region->moves || gjk_triangle_meets_on_way(region, corner));
}

// The kind of the edge from a to b of the triangle a, b, c, if the triangle across it has its third corner at w.
gjk_mesh_edge gjk_triangle_edge_of(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, const gjk_vec3 *w);

// The corners of a triangle where they stand in the world: each turned and rounded once, wherever it is used. So triangles
// that share a corner share its place. False: a coordinate is out of range, which only unchecked data can cause.
bool gjk_triangle_turn(const gjk_parts_frame *frame, const gjk_vec3 corner[3], gjk_vec3 world[3]);

// The collider of a triangle in the world. Statuses as gjk_collider_init.
gjk_status gjk_triangle_collider(const gjk_vec3 world[3], gjk_parts_room *room, gjk_collider *out);

// What gjk_parts_class.place and .local are for triangles.
gjk_status gjk_triangle_place(const gjk_parts_frame *frame, const gjk_vec3 corner[3], gjk_parts_room *room,
                              gjk_collider *out);
void gjk_triangle_local(const gjk_vec3 corner[3], gjk_parts_room *room, gjk_parts_local *out);

// The largest distance from the origin of a point of a box, plus 4 for rounding; below sqrt(3) 2^31 + 4.
uint32_t gjk_triangle_reach(const gjk_vec3 *lower, const gjk_vec3 *upper);

// How far a box lies from a region: the sum of the gaps along the axes.
int64_t gjk_box_gap(const gjk_vec3 *lower, const gjk_vec3 *upper, const gjk_region *region);

// What a guess compares: the sum of the gaps along the axes, and among equals the sum of the distances of the middles.
int64_t gjk_triangle_distance(const gjk_vec3 corner[3], const gjk_region *region);

// What gjk_parts_class.edges returns: the gjk_mesh_edge of each edge, two bits each, and whether there are contacts on both
// sides.
#define GJK_TRIANGLE_EDGES(a, b, c) ((unsigned)(a) | (unsigned)(b) << 2 | (unsigned)(c) << 4)
#define GJK_TRIANGLE_EDGE(edges, i) ((edges) >> 2 * (i)&3u)

// The contacts of one triangle of a surface with a body, as gjk_surface_contacts; count 0: none. All of *out except for
// contacts may be written in any case. cache: of any triangles of the surface with b, or NULL. Pre: margin is 0 to
// GJK_RADIUS_MAX, most as of gjk_contacts.
gjk_status gjk_surface_meet(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_q16 margin,
                            unsigned most, gjk_cache *cache, const gjk_workspace *workspace, gjk_manifold *out);

// gjk_parts_class.settle of surfaces.
bool gjk_surface_settle(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_manifold *m);

#endif
