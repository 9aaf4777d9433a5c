// How deep do two shapes overlap, and along which direction is the way out shortest?
#ifndef GJK_PENETRATION_H
#define GJK_PENETRATION_H

#include "gjk/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

// A vertex of the expanding polytope (EPA). The contents of a workspace are the library's.
typedef struct gjk_epa_vertex {
  gjk_vec3 w;     // a point of A - B
  uint16_t a, b;  // numbers of the vertices of A and B whose difference is w
} gjk_epa_vertex;

// A face of the expanding polytope.
typedef struct gjk_epa_face {
  uint16_t corner[3], neighbour[3];  // numbers of its vertices, and of the faces across its edges
  uint32_t height_key;               // orders faces by their distance from the origin
} gjk_epa_face;

// Up to four edges of the horizon.
typedef struct gjk_epa_horizon {
  uint16_t corner[4], face[4];  // for each edge, the vertex where it begins and the face that stays
} gjk_epa_horizon;

// A cell of a workspace, which holds one of the three.
typedef union gjk_epa_cell {
  gjk_epa_vertex vertex;    // a vertex
  gjk_epa_face face;        // a face
  gjk_epa_horizon horizon;  // edges of the horizon
} gjk_epa_cell;

// The number of cells that always suffices for an EPA hull of this many vertices, from 4 to 16000. A pair with a curved
// shape needs one more cell for each vertex.
#define GJK_EPA_CELLS(vertices) (3 * (vertices)-4 + (vertices) / 2)

// The most EPA iterations for a pair with a curved shape, and the cells that they take; more cells change nothing.
// Smooth shapes with coinciding centres are equally deep all round, and would take hundreds of thousands of iterations.
#define GJK_EPA_CURVED_ITERATIONS_MAX 1000
#define GJK_EPA_CURVED_CELLS (GJK_EPA_CELLS(GJK_EPA_CURVED_ITERATIONS_MAX + 4) + GJK_EPA_CURVED_ITERATIONS_MAX + 4)

// The caller's memory for the EPA hull. A pair needs it only if its cores overlap. Pairs of points, segments and boxes,
// with or without a convex radius, need none.
//
// EPA hulls of other pairs have, in vertices:
//   hulls of n and m vertices   at most n m
//   two 8-point hulls           at most 20 in 1,000,000 random pairs (66 cells, 1,056 bytes)
//   two 64-point hulls          at most 36 in 100,000 random pairs (122 cells, 1,952 bytes)
typedef struct gjk_workspace {
  gjk_epa_cell *cells;  // the caller's; NULL where count is 0
  uint32_t count;       // length of cells
} gjk_workspace;

// The bytes of a workspace for an EPA hull of this many vertices; 0 below 4. GJK_EPA_CELLS sizes a static array.
size_t gjk_workspace_bytes(uint16_t vertices);

// Lengths Q16.16, points in the world frame.
typedef struct gjk_penetration_result {
  gjk_q16 depth;     // length of the shortest move of B that leaves the shapes apart or just touching, rounded up; 0 if
                     // and only if they just touch
  gjk_q16 lower;     // proven lower bound of the depth, inclusive
  gjk_q16 upper;     // proven upper bound of the depth, inclusive
  gjk_vec3 point_a;  // the point of A deepest in B
  gjk_vec3 point_b;  // the point of B deepest in A
  gjk_unit3 normal;  // direction of that move, from A to B, Q2.30, each component rounded away from 0
  bool intersecting;            // false: the shapes are apart, and only iterations and certificate are also set
  uint16_t iterations;          // support scans of both shapes
  gjk_certificate certificate;  // why the answer is right
} gjk_penetration_result;

// The depth by which two convex shapes overlap, with its direction and points.
//
// a, b       posed colliders, read only; may be the same object.
// cache      in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only: it speeds up finding shapes
//            apart, and the nearest facet of boxes. Other depths start cold. Written after OK and CAPACITY.
// workspace  read only, its cells in/out; may be NULL, see gjk_workspace. The result depends on the number of cells
//            only if there are too few, and never on their contents.
// out        the caller's.
// Exact      points, segments, triangles, boxes, hulls and their forms with a convex radius:
//              depth           the true minimum over all directions, rounded up; lower and upper equal it
//              normal          B moved by depth * normal, each component rounded away from 0, is apart from A or
//                              touches it. normal is within 2^-28 of the direction of least depth
//              points          each within 1 LSB of its shape. Once B has moved by depth * normal, they coincide to
//                              within 3 LSB and 2^-28 of depth. Coordinates saturate at the ends of Q16.16
//            Ties: depths along directions are compared exactly, not in LSB. Among points, segments and boxes, faces of
//            a by half axis win, then faces of b, then edges of a crossed with edges of b. For other pairs the choice
//            depends only on the posed shapes and their order.
//            Cylinder, cone, ellipsoid: depth within 3 LSB, between bounds at most 6 LSB apart; or CAPACITY.
// Cost       the iterations of gjk_distance, and one for each vertex of the EPA hull. The workspace limits these; with
//            a curved shape GJK_EPA_CURVED_ITERATIONS_MAX does too. Stack: `make sizes`.
// After      Gino van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001: an
//            expanding polytope; exact visibility signs instead of tolerances. Boxes: their 15 separating axes.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything if intersecting, else intersecting, iterations and certificate; in that, only what
//                      its proof uses.
// CAPACITY             everything; intersecting is true. The workspace is too small, or a curved pair would take more
//                      than GJK_EPA_CURVED_ITERATIONS_MAX iterations. depth equals upper, and B moved by it is clear of
//                      A. The least depth is at least lower. The certificate proves nothing.
// ITERATION_LIMIT      nothing, not even intersecting. Only cylinder, cone, ellipsoid and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out);

// The signed distance of two shapes. Where they overlap, it is minus the depth.
//
// a, b, cache, workspace  as in gjk_penetration.
// out                     apart: as in gjk_distance. Overlapping: as in gjk_penetration, with distance = -depth,
//                         lower = -upper, upper = -lower and intersecting set. iterations stops counting at 255.
// Exact, Cost, After      as in gjk_distance and gjk_penetration.
//
// OK                   everything, points and normal too; in the certificate, only what its proof uses.
// CAPACITY             everything, as in gjk_penetration.
// ITERATION_LIMIT      lower, upper, iterations. The signed distance lies between lower and upper. lower above 0 proves
//                      that the shapes are apart, upper below 0 that they overlap.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
