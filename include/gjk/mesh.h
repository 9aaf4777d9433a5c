// Triangle meshes: surfaces of up to millions of triangles, as constants fit for flash.
//
// A mesh is the caller's vertices plus 15 bytes for each triangle. These hold three vertex numbers, the kinds of the
// edges, and a share of a tree of boxes. gjk_mesh_build makes the tree, on the target or beforehand; gjk-convert writes
// meshes as C source. A query tests no more triangles in a mesh of a million than in a patch around the body.
#ifndef GJK_MESH_H
#define GJK_MESH_H

#include "gjk/parts.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind meshes.
extern const gjk_parts_class gjk_parts_class_mesh;

// The most triangles, and the most vertices, of one mesh.
#define GJK_MESH_TRIANGLES_MAX UINT32_C(0x0FFFFFFF)
#define GJK_MESH_VERTICES_MAX UINT32_C(0x0FFFFFFF)

// The largest magnitude of a vertex coordinate: 16384 units.
#define GJK_MESH_COORDINATE_MAX (INT32_C(1) << 30)

// The most triangles of a leaf of the tree, and the number of nodes of a tree of at least one triangle.
#define GJK_MESH_LEAF 8
#define GJK_MESH_NODES(triangles) ((triangles) / 4 + ((triangles) % 8 == 0 ? 0 : (triangles) % 8 < 4 ? 2 : 1) - 1)

// The kind of an edge: where the triangle across it lies relative to this triangle's plane.
typedef enum gjk_mesh_edge {
  GJK_MESH_CONCAVE = 0,  // in front: on the side from which the corners run counterclockwise
  GJK_MESH_FLAT = 1,     // in the plane
  GJK_MESH_CONVEX = 2,   // behind the plane, or folded back onto this triangle
  GJK_MESH_OPEN = 3      // there is no triangle across
} gjk_mesh_edge;

// A triangle. Seen from its front, the corners run counterclockwise.
//
// corner[i]: bits 0 to 27 are the number of a vertex. Bits 28 and 29 are the gjk_mesh_edge of the edge to the next
// corner. The other bits are 0.
typedef struct gjk_mesh_triangle {
  uint32_t corner[3];  // see above
} gjk_mesh_triangle;

// The vertex number, and the gjk_mesh_edge, of a corner of a triangle.
#define GJK_MESH_NUMBER(corner) ((corner)&UINT32_C(0x0FFFFFFF))
#define GJK_MESH_EDGE(corner) ((corner) >> 28 & 3u)

// A box of the tree, inclusive, in steps of 2^shift LSB from the mesh's lower corner.
typedef struct gjk_mesh_node {
  uint16_t lower[3], upper[3];  // ends along x, y and z
} gjk_mesh_node;

// A mesh in its own frame. gjk_mesh_build fills it; as a constant it may be in flash.
typedef struct gjk_mesh {
  const gjk_vec3 *vertices;               // Q16.16, each coordinate at most GJK_MESH_COORDINATE_MAX in size
  const gjk_mesh_triangle *triangles;     // in the order of the tree's leaves
  const gjk_mesh_node *nodes;             // GJK_MESH_NODES(triangle_count) nodes, see src/mesh/gjk_mesh_tree.h
  uint32_t vertex_count, triangle_count;  // lengths of the arrays
  gjk_vec3 lower, upper;                  // the box of all triangles
  uint8_t shift[3];                       // steps of nodes along x, y and z: (upper - lower) / 2^shift is below 2^16
  bool two_sided;                         // true: contacts on both sides; false: only in front
} gjk_mesh;

// A body of this mesh at the identity pose, for the queries of gjk/parts.h. Its parts are the triangles, numbered as in
// mesh->triangles. Each vertex is turned and rounded only once, so the surface has no gaps at any pose.
#define GJK_PARTS_OF_MESH(mesh) \
  { &gjk_parts_class_mesh, 1 ? (mesh) : (const gjk_mesh *)0, GJK_POSE_IDENTITY }

// Makes a mesh from triangles.
//
// vertices   the caller's, must outlive the mesh. Vertices in the same place count as the same.
// triangles  in: three vertex numbers each; other bits are ignored. Out: in the order of the tree, with the kinds of
//            their edges. They must outlive the mesh.
// nodes      room for capacity nodes, at least GJK_MESH_NODES(triangle_count).
// out        written when the result is GJK_OK; on any other status the triangles are as they were.
// Exact      an edge's kind is the sign of an 87-bit determinant. The same triangles in the same order give the same
//            mesh everywhere.
// Statuses   NULL; EMPTY: no triangles; CAPACITY: nodes; SIZE: a triangle is longer than GJK_RADIUS_MAX along an axis.
//            RANGE: a number or coordinate too large, or too many triangles or vertices.
// Cost       of the order of n log n for n triangles, if few of them meet in one place. No recursion, no workspace.
gjk_status gjk_mesh_build(const gjk_vec3 *vertices, uint32_t vertex_count, gjk_mesh_triangle *triangles,
                          uint32_t triangle_count, bool two_sided, gjk_mesh_node *nodes, uint32_t capacity,
                          gjk_mesh *out);

// What is wrong with a mesh.
typedef enum gjk_mesh_fault {
  GJK_MESH_SOUND = 0,     // nothing
  GJK_MESH_NUMBER_FAULT,  // a corner that is not the number of a vertex, or bits that are not 0
  GJK_MESH_COORDINATE,    // a vertex beyond GJK_MESH_COORDINATE_MAX
  GJK_MESH_SIZE,          // a triangle longer than GJK_RADIUS_MAX along an axis
  GJK_MESH_SHIFT,         // the mesh's box is not that of its triangles, or its steps do not fit
  GJK_MESH_BOX,           // a node that does not hold its triangles
  GJK_MESH_EDGES,         // an edge whose kind is wrong
  GJK_MESH_DEGENERATE,    // a triangle whose corners lie in a line; it has no front, and contacts leave it out
  GJK_MESH_CROWDED,       // an edge that more than two triangles share
  GJK_MESH_TURNED         // an edge that two triangles run along in the same direction: one is turned over
} gjk_mesh_fault;

// What gjk_mesh_check found. With a fault up to GJK_MESH_EDGES, queries may miss triangles, but never read outside the
// mesh's arrays. With a later fault every answer is right, but the surface is flawed.
typedef struct gjk_mesh_report {
  uint8_t fault;      // a gjk_mesh_fault: the first that applies, in the order of the enumeration
  uint8_t edge;       // edge of the triangle, for faults of an edge; for NUMBER_FAULT to SIZE the corner
  uint32_t triangle;  // the first triangle with the fault
  uint32_t node;      // BOX: the node
  uint32_t edges[4];  // number of edges by gjk_mesh_edge, each side of an edge counted; 0 for NUMBER_FAULT to EDGES
} gjk_mesh_report;

// Is a mesh as gjk_mesh_build makes it, and a sound surface?
//
// mesh      its arrays must be as long as its counts say.
// Statuses  NULL; EMPTY; RANGE: too many triangles or vertices. OK: out is written, with or without a fault.
// Cost      of the order of n log n, as gjk_mesh_build.
gjk_status gjk_mesh_check(const gjk_mesh *mesh, gjk_mesh_report *out);

#ifdef __cplusplus
}
#endif

#endif
