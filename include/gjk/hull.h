// The convex hull of points, exactly: for shapes made of points, of meshes, of scans.
//
// Coordinates are integers, so whether a point lies above a plane is a sign of theirs. Points that are coplanar or
// collinear are so by their integers, not by a tolerance: no hull is refused, folded or turned inside out.
#ifndef GJK_HULL_H
#define GJK_HULL_H

#include "gjk/shape.h"
#include "gjk/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Most points of one hull.
#define GJK_HULL_POINTS_MAX 65535

// Bytes of workspace for so many points: 40 a point, and 40.
#define GJK_HULL_WORKSPACE(points) (40 * (uint32_t)(points) + 40)

// A hull in the caller's workspace. The first six fields may be read; the rest is the library's.
typedef struct gjk_hull {
  uint8_t dimension;       // of the points: 0 to 3
  uint16_t vertices;       // extreme points, each counted once
  uint32_t faces;          // facets: faces in one plane count once. Of points in a plane two, of fewer dimensions none
  uint32_t edges;          // between facets
  uint32_t corners;        // of all facets together: twice the edges
  uint16_t most_corners;   // of one facet
  const gjk_vec3 *points;  // that gjk_hull_build was given
  void *workspace;         // the same
  uint32_t count, distinct, triangles;  // of points, of those in different places, and of triangles
} gjk_hull;

// Finds the hull.
//
// points     the caller's, in any order, repeated ones too, any int32_t; must stay until the hull is written out.
// workspace  the caller's, aligned for uint32_t, at least GJK_HULL_WORKSPACE(count) bytes; may come from
//            gjk_port_allocate. It holds the hull.
// out        written when the result is GJK_OK.
// Exact      vertices, facets and edges are those of the real hull. They are the same for any order of the points.
// Statuses   NULL; EMPTY; SIZE: the points are more than 2 GJK_RADIUS_MAX apart along an axis; CAPACITY: bytes; RANGE:
//            a workspace that is not aligned.
// Cost       of the order of count log count for points spread over a surface; no recursion. At worst count cubed: each point
//            added may leave as many others to compare with as many new triangles. Points along (cos t, sin t, cos 2 t) do.
// After      Barber, Dobkin, Huhdanpaa, The quickhull algorithm for convex hulls, 1996; exact signs in place of its
//            tolerances.
gjk_status gjk_hull_build(const gjk_vec3 *points, uint16_t count, void *workspace, size_t bytes, gjk_hull *out);

// Writes the vertices in their order by x, then y, then z. CAPACITY: fewer than hull->vertices.
gjk_status gjk_hull_vertices(const gjk_hull *hull, gjk_vec3 *out, uint16_t capacity);

// Room for the faces of any hull of so many vertices, at least 3, and for the corners of all faces.
#define GJK_HULL_FACES_MAX(vertices) (2 * (uint32_t)(vertices)-4)
#define GJK_HULL_CORNERS_MAX(vertices) (6 * (uint32_t)(vertices)-12)

// Writes the facets for a shape with faces (gjk/shape.h), by numbers of gjk_hull_vertices.
//
// A facet of more than GJK_FACE_CORNERS_MAX corners is cut into faces that share its first corner. So there may be more
// faces than hull->faces, and two more corners for each.
//
// corner, end  room for corner_capacity and face_capacity numbers; they become the fields of out. GJK_HULL_CORNERS_MAX and
//              GJK_HULL_FACES_MAX are always enough.
// Statuses     NULL; CAPACITY: too little room, or more than 65535 corners in all, which gjk_hull_faces cannot hold.
//              Then corner and end may have been written, out not.
gjk_status gjk_hull_write_faces(const gjk_hull *hull, uint16_t *corner, uint16_t corner_capacity, uint16_t *end,
                                uint16_t face_capacity, gjk_hull_faces *out);

// Six times the volume, in cubic LSB, exact: 2^64 high + low. 0 for points in a plane.
typedef struct gjk_hull_volume {
  uint64_t high, low;  // halves of the number
} gjk_hull_volume;

// The volume of a hull that is built. Statuses: NULL.
gjk_status gjk_hull_get_volume(const gjk_hull *hull, gjk_hull_volume *six_times);

// Bytes of workspace for gjk_hull_simplify of so many points: 96 a point, and 808.
#define GJK_HULL_SIMPLIFY_WORKSPACE(points) (96 * (uint32_t)(points) + 808)

// Fewest vertices that a hull can be simplified to.
#define GJK_HULL_SIMPLE_MIN 4

// What gjk_hull_simplify found.
typedef struct gjk_hull_simple {
  uint16_t vertices;  // written
  uint32_t excess;    // no point of the simple hull is farther than this from the hull of the points, LSB
} gjk_hull_simple;

// A hull of at most so many vertices that encloses the hull of the points, exactly. Points that lie far apart are chosen, and
// moved outwards until their hull holds all others.
//
// most       vertices wanted, from GJK_HULL_SIMPLE_MIN on (RANGE).
// workspace  as for gjk_hull_build, at least GJK_HULL_SIMPLIFY_WORKSPACE(count) bytes; not needed afterwards.
// vertices   room for most of them; may not be points. Find their faces by gjk_hull_build.
// out        written, with vertices, when the result is GJK_OK.
// Exact      every point is inside or on the simple hull, which is tested in the end. Where the hull has no more vertices
//            than wanted, they are the result, and the excess is 0. The same for any order of the points.
// Excess     measured on the result: at most 2 LSB above the largest distance, never below it. Never more than that of the
//            bounding box, of 8 vertices, or of a tetrahedron around it. It is small, not the least: of points on a sphere
//            32 vertices reach some 14 % of the radius beyond, and could do with 9 %. At a sharp corner a vertex has to go
//            far, since it is not cut off.
// Flat       of points in a plane with more corners than wanted: that box or tetrahedron, and its distance from the corners.
//            gjk2_polygon_order and a thin prism do better.
// Statuses   NULL; EMPTY; SIZE: as gjk_hull_build; CAPACITY: bytes. RANGE: also a workspace that is not aligned. Or int32 has
//            no room for a tetrahedron, which is up to three times as wide as the points.
// Cost       for each round of choosing, and three times more, the triangles of the result times the hull's vertices. To 32
//            vertices of 1,000 on a sphere it takes ten times as long as gjk_hull_build.
gjk_status gjk_hull_simplify(const gjk_vec3 *points, uint16_t count, uint16_t most, void *workspace, size_t bytes,
                             gjk_vec3 *vertices, gjk_hull_simple *out);

// What is wrong with the faces of a hull.
typedef enum gjk_hull_fault {
  GJK_HULL_SOUND = 0,  // nothing
  GJK_HULL_FEW,        // a face of less than 3 corners, or no faces
  GJK_HULL_NUMBER,     // a corner that is no vertex
  GJK_HULL_BENT,       // a face whose corners do not lie in one plane
  GJK_HULL_TURN,       // a face that does not turn counterclockwise at each corner, exactly once around
  GJK_HULL_BEYOND,     // a vertex beyond a face: the face is turned inwards, or does not bound the hull
  GJK_HULL_OPEN,       // an edge that no other face has the opposite way
  GJK_HULL_DOUBLED,    // an edge that two faces have the same way
  GJK_HULL_LAYERS      // faces that do not go once around a vertex; of face 0 also: around all of them
} gjk_hull_fault;

// What gjk_hull_check found.
typedef struct gjk_hull_report {
  uint8_t fault;    // a gjk_hull_fault, the first in their order
  uint16_t face;    // the first face that has it
  uint16_t corner;  // and its corner, counted from 0; 0 where the fault is of the whole face
  uint16_t vertex;  // BEYOND: the first vertex beyond it
} gjk_hull_report;

// Are the faces of a hull closed, convex, outward and complete, for contacts? Coplanar faces beside each other, and
// vertices that are on no face, within the hull, are sound. Of points in a plane both sides are, which meet at the outline:
// within it an edge is open, or doubled, by the faces of its own side.
//
// vertices  count of them, no more than 2 GJK_RADIUS_MAX apart along an axis (SIZE).
// Statuses  NULL; EMPTY. OK: out is written, whatever it says.
// Cost      of the order of faces times vertices, and of corners squared. No workspace.
gjk_status gjk_hull_check(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces, gjk_hull_report *out);

#ifdef __cplusplus
}
#endif

#endif
