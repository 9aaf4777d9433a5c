// The convex hull of points, exactly: for shapes made of points, meshes or scans.
//
// Coordinates are integers, so the side of a plane on which a point lies is an exact sign. Points are coplanar or
// collinear by their integers, not by a tolerance. So no hull is refused, folded or turned inside out.
#ifndef GJK_HULL_H
#define GJK_HULL_H

#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most points of one hull.
#define GJK_HULL_POINTS_MAX 65535

// Bytes of workspace for this many points: 40 a point, plus 40.
#define GJK_HULL_WORKSPACE(points) (40 * (uint32_t)(points) + 40)

// A hull in the caller's workspace. The first six fields may be read; the rest is the library's.
typedef struct gjk_hull {
  uint8_t dimension;       // dimension of the points, 0 to 3
  uint16_t vertices;       // extreme points, each counted once
  uint32_t faces;          // facets; coplanar faces count once. Points in a plane have two, points in a line none
  uint32_t edges;          // edges between facets
  uint32_t corners;        // corners of all facets together: twice the edges
  uint16_t most_corners;   // most corners of one facet
  const gjk_vec3 *points;  // the points given to gjk_hull_build
  void *workspace;         // the workspace given to gjk_hull_build
  uint32_t count, distinct, triangles;  // numbers of points, of distinct points, and of triangles
} gjk_hull;

// Finds the hull.
//
// points     the caller's, any int32_t, in any order; may repeat; must stay until the hull is written out.
// workspace  the caller's, aligned for uint32_t, at least GJK_HULL_WORKSPACE(count) bytes; may come from
//            gjk_port_allocate. It holds the hull.
// out        written when the result is GJK_OK.
// Exact      vertices, facets and edges are those of the real hull. They are the same for any order of the points.
// Statuses   NULL; EMPTY; SIZE: the points are more than 2 GJK_RADIUS_MAX apart along an axis; CAPACITY: bytes; RANGE:
//            an unaligned workspace.
// Cost       of the order of count log count for points spread over a surface, and at worst of count cubed. That
//            happens along (cos t, sin t, cos 2 t), where new triangles are many and see few points. No recursion.
// After      Barber, Dobkin, Huhdanpaa, The quickhull algorithm for convex hulls, 1996; with exact signs.
gjk_status gjk_hull_build(const gjk_vec3 *points, uint16_t count, void *workspace, size_t bytes, gjk_hull *out);

// Writes the vertices in order of x, then y, then z. CAPACITY: capacity is below hull->vertices.
gjk_status gjk_hull_vertices(const gjk_hull *hull, gjk_vec3 *out, uint16_t capacity);

// Lengths of the arrays end and corner that hold the faces of any hull of this many vertices, at least 3.
#define GJK_HULL_FACES_MAX(vertices) (2 * (uint32_t)(vertices)-4)
#define GJK_HULL_CORNERS_MAX(vertices) (6 * (uint32_t)(vertices)-12)

// Writes the facets as the faces of a shape (gjk/shape.h). Vertices are numbered as gjk_hull_vertices writes them.
//
// A facet of more than GJK_FACE_CORNERS_MAX corners is cut into faces that share its first corner. Each such cut adds a
// face and two corners to those that hull counts.
//
// corner, end  room for corner_capacity and face_capacity numbers, which out then refers to. GJK_HULL_CORNERS_MAX and
//              GJK_HULL_FACES_MAX are always enough.
// Statuses     NULL; CAPACITY: too little room, or more than 65535 corners in all, which gjk_hull_faces cannot hold.
//              Then corner and end may have been written, but out is not.
gjk_status gjk_hull_write_faces(const gjk_hull *hull, uint16_t *corner, uint16_t corner_capacity, uint16_t *end,
                                uint16_t face_capacity, gjk_hull_faces *out);

// Six times the volume, in cubic LSB, exact: 2^64 high + low. 0 for points in a plane.
typedef struct gjk_hull_volume {
  uint64_t high, low;  // halves of the number
} gjk_hull_volume;

// The volume of a hull made by gjk_hull_build. Statuses: NULL.
gjk_status gjk_hull_get_volume(const gjk_hull *hull, gjk_hull_volume *six_times);

// Bytes of workspace for gjk_hull_simplify of this many points: 96 a point, plus 808.
#define GJK_HULL_SIMPLIFY_WORKSPACE(points) (96 * (uint32_t)(points) + 808)

// The fewest vertices that a hull can be simplified to.
#define GJK_HULL_SIMPLE_MIN 4

// What gjk_hull_simplify found.
typedef struct gjk_hull_simple {
  uint16_t vertices;  // vertices written
  uint32_t excess;    // bound of the distance from a point of the simple hull to the hull of the points, LSB
} gjk_hull_simple;

// Makes a hull of at most a given number of vertices that encloses the hull of the points, exactly. It chooses points
// that lie far apart, and moves them outwards until their hull holds all others.
//
// most       the most vertices, at least GJK_HULL_SIMPLE_MIN (RANGE).
// workspace  as for gjk_hull_build, at least GJK_HULL_SIMPLIFY_WORKSPACE(count) bytes; not needed afterwards.
// vertices   room for most vertices; must not be points. gjk_hull_build finds their faces.
// out        written, with vertices, when the result is GJK_OK.
// Exact      every point is inside or on the simple hull; a final test makes sure. If the hull has no more than most
//            vertices, they are the result, and the excess is 0. The result is the same for any order of the points.
// Excess     measured on the result: never below the largest distance, and at most 2 LSB above it. It never exceeds
//            that of the bounding box (8 vertices) or of a tetrahedron around it. It is not the least: for points on a
//            sphere, 32 vertices reach 14 % of the radius beyond it, where 9 % is possible. Sharp corners are not cut
//            off, so a vertex at one moves far.
// Flat       points in a plane with more than most corners give that box or tetrahedron, and excess is its distance
//            from them. gjk2_polygon_order and a thin prism do better.
// Statuses   NULL; EMPTY; SIZE: as gjk_hull_build; CAPACITY: bytes. RANGE: most, or workspace is not aligned. Also
//            RANGE: the tetrahedron, up to three times as wide as the points, leaves int32.
// Cost       the result's triangles times the hull's vertices, for each round of choosing, and three times after that.
//            Reducing 1,000 vertices on a sphere to 32 takes ten times as long as gjk_hull_build.
gjk_status gjk_hull_simplify(const gjk_vec3 *points, uint16_t count, uint16_t most, void *workspace, size_t bytes,
                             gjk_vec3 *vertices, gjk_hull_simple *out);

// What is wrong with the faces of a hull.
typedef enum gjk_hull_fault {
  GJK_HULL_SOUND = 0,  // nothing
  GJK_HULL_FEW,        // a face of fewer than 3 corners, or no faces
  GJK_HULL_NUMBER,     // a corner that is not the number of a vertex
  GJK_HULL_BENT,       // a face whose corners do not lie in one plane
  GJK_HULL_TURN,       // a face that does not turn counterclockwise at each corner, exactly once around
  GJK_HULL_BEYOND,     // a vertex beyond a face, which is turned inwards or does not bound the hull
  GJK_HULL_OPEN,       // an edge that no other face has in the opposite direction
  GJK_HULL_DOUBLED,    // an edge that two faces have in the same direction
  GJK_HULL_LAYERS      // faces that do not go once around a vertex; with face 0 also around all vertices
} gjk_hull_fault;

// What gjk_hull_check found.
typedef struct gjk_hull_report {
  uint8_t fault;    // a gjk_hull_fault: the first that applies, in the order of the enumeration
  uint16_t face;    // the first face with the fault
  uint16_t corner;  // the corner of that face with the fault, from 0; 0 if the whole face has it
  uint16_t vertex;  // BEYOND: the first vertex beyond the face
} gjk_hull_report;

// Are the faces of a hull closed, convex, outward and complete, as contacts need them?
//
// Coplanar faces beside each other are sound, and so are vertices inside the hull that no face uses. Points in a plane
// need both sides, which meet at the outline. Within it, faces on an edge's own side decide about the edge.
//
// vertices  count vertices, at most 2 GJK_RADIUS_MAX apart along an axis (SIZE).
// Statuses  NULL; EMPTY. OK: out is written, with or without a fault.
// Cost      of the order of faces times vertices, and of corners squared. No workspace.
gjk_status gjk_hull_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces, gjk_hull_report *out);

#ifdef __cplusplus
}
#endif

#endif
