// The tree of boxes of a mesh, and the walk through it, without links and without a stack.
//
// Leaf s holds the triangles from GJK_MESH_LEAF s on. A node of level l begins at a leaf s that 2^l divides, and holds
// the leaves from s to s + 2^l - 1, as far as there are. One that has only a left half is the same as that half, and is
// left out. So with n leaves there are 2 n - 1 nodes: leaf s is number 2 s, the node above, where its halves meet,
// number 2 s + 2^l - 1.
//
// The node that follows one and all below it begins at leaf s + 2^l. It is of the highest level that divides this, since
// all higher ones that begin there would hold the leaf before as well. So the walk is a number and a level. If the
// region moves, the walk goes from near to far, and a bit per level says whether the farther half is still to come.
#ifndef GJK_SRC_MESH_TREE_H
#define GJK_SRC_MESH_TREE_H

#include "gjk/mesh.h"
#include "gjk_triangle.h"

// There are less than 2^25 leaves.
#define GJK_MESH_LEVEL_MAX 25

static inline uint32_t gjk_mesh_leaves(uint32_t triangles) {
  return triangles / GJK_MESH_LEAF + (triangles % GJK_MESH_LEAF != 0 ? 1 : 0);
}

static inline uint32_t gjk_mesh_node_number(uint32_t leaf, unsigned level) {
  return 2 * leaf + ((UINT32_C(1) << level) - 1);
}

// The level of the node that stands for this one: the same, unless it has only a left half. Pre: leaf < leaves.
static inline unsigned gjk_mesh_level(uint32_t leaf, unsigned level, uint32_t leaves) {
  while (level > 0 && leaves - leaf <= UINT32_C(1) << (level - 1)) {
    level--;
  }
  return level;
}

// The next triangle whose box meets the region, and its corners. False: there is none. A triangle with a corner that is
// no vertex is left out. Each node is visited at most once.
//
// walk->node  the leaf where the next node begins, which has the highest level that begins there. For a region that
//             moves, the bits of its levels
// walk->item  the next triangle. If it begins a leaf, or comes after the last one, another leaf must be found
bool gjk_mesh_next(const gjk_mesh *mesh, const gjk_region *region, gjk_parts_walk *walk, uint32_t *triangle,
                   gjk_vec3 corner[3]);

// The steps from the mesh's lower corner to a coordinate, which is clamped to the mesh's box. They are rounded down, so
// a lower coordinate never has more steps.
uint16_t gjk_mesh_step(int32_t x, int32_t lower, int32_t upper, unsigned shift);

void gjk_mesh_steps_of(const gjk_mesh *mesh, const gjk_vec3 *lower, const gjk_vec3 *upper, gjk_mesh_node *out);

// The corners of a triangle; false if one is no vertex.
bool gjk_mesh_corners(const gjk_mesh *mesh, uint32_t triangle, gjk_vec3 corner[3]);

// Which edges of triangles meet an edge.
typedef struct gjk_mesh_across {
  uint32_t opposite;  // triangles that have it the other way
  uint32_t same;      // other triangles that have it the same way
  gjk_mesh_edge kind;
} gjk_mesh_across;

// Looks at the edge from a triangle's corner i to the next one. Pre: its numbers are those of vertices.
void gjk_mesh_look_across(const gjk_mesh *mesh, uint32_t triangle, unsigned i, gjk_mesh_across *out);

// What gjk_mesh_build and gjk_mesh_check ask of a triangle: the first corner at fault and what it is, or GJK_MESH_SOUND.
gjk_mesh_fault gjk_mesh_triangle_fault(const gjk_vec3 *vertices, uint32_t vertex_count,
                                       const gjk_mesh_triangle *triangle, unsigned *corner);

#endif
