// How deep do two shapes overlap, and along which direction is the way out shortest?
#ifndef GJK_PENETRATION_H
#define GJK_PENETRATION_H

#include "gjk/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a workspace holds: vertices, faces and the horizon of the expanding polytope (EPA). The contents are the
// library's.
typedef struct gjk_epa_vertex {
  gjk_vec3 w;     // a point of A - B
  uint16_t a, b;  // numbers of the vertices that it is the difference of
} gjk_epa_vertex;

// A face of the expanding polytope.
typedef struct gjk_epa_face {
  uint16_t corner[3], neighbour[3];  // numbers of vertices, and of the faces across the edges
  uint32_t height_key;               // orders faces by their distance from the origin
} gjk_epa_face;

// Up to four edges of its horizon.
typedef struct gjk_epa_horizon {
  uint16_t corner[4], face[4];  // edges of the horizon: where each begins, and the face that stays
} gjk_epa_horizon;

// A cell of a workspace.
typedef union gjk_epa_cell {
  gjk_epa_vertex vertex;    // one of three
  gjk_epa_face face;        // the second
  gjk_epa_horizon horizon;  // the third
} gjk_epa_cell;

// Cells that always suffice for an EPA hull of this many vertices, 4 to 16000. A pair with a curved shape needs one
// more for each vertex.
#define GJK_EPA_CELLS(vertices) (3 * (vertices)-4 + (vertices) / 2)

// The most EPA iterations for a pair with a curved shape, and the cells that they take; more cells change nothing.
// Smooth shapes in the middle of each other are equally deep all round, and would take hundreds of thousands of
// iterations.
#define GJK_EPA_CURVED_ITERATIONS_MAX 1000
#define GJK_EPA_CURVED_CELLS (GJK_EPA_CELLS(GJK_EPA_CURVED_ITERATIONS_MAX + 4) + GJK_EPA_CURVED_ITERATIONS_MAX + 4)

// The caller's memory for the EPA hull. No pair needs any unless its cores overlap; points, segments and boxes, with or
// without a convex radius, need none among each other.
//
// EPA hulls of the others have, in vertices:
//   hulls of n and m vertices   at most n m
//   two 8-point hulls           at most 20 in 1,000,000 random pairs (66 cells, 1,056 bytes)
//   two 64-point hulls          at most 36 in 100,000 random pairs (122 cells, 1,952 bytes)
typedef struct gjk_workspace {
  gjk_epa_cell *cells;  // the caller's; NULL where count is 0
  uint32_t count;       // of cells
} gjk_workspace;

// The bytes of a workspace for an EPA hull of this many vertices; 0 below 4.
size_t gjk_workspace_bytes(uint16_t vertices);

// Lengths Q16.16, points in the world frame.
typedef struct gjk_penetration_result {
  gjk_q16 depth;  // the shortest move of B, over all directions, that leaves the shapes apart or just touching, rounded
                  // up; 0 if and only if they just touch
  gjk_q16 lower;  // proven bounds of the depth, both included
  gjk_q16 upper;  // the other bound
  gjk_vec3 point_a;             // the point of A that is deepest in B
  gjk_vec3 point_b;             // the point of B that is deepest in A
  gjk_unit3 normal;             // the direction of that move, from A to B, Q2.30, each component rounded away from 0
  bool intersecting;            // false: the shapes are apart, and of the rest only iterations and certificate are set
  uint16_t iterations;          // support scans of both shapes
  gjk_certificate certificate;  // why the answer is right
} gjk_penetration_result;

// The depth of the overlap of two convex shapes, with its direction and points.
//
// a, b       posed colliders, read only; may be the same object.
// cache      in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only: it helps to find out that the
//            shapes are apart, and which facet of boxes is nearest; other depths are measured from a cold start. Written
//            after OK and CAPACITY.
// workspace  read only, its cells in/out; may be NULL, see gjk_workspace. The result depends on the number of cells
//            only where they are too few, never on what they hold.
// out        the caller's.
// Exact      points, segments, triangles, boxes, hulls and their forms with a convex radius:
//              depth           the true minimum over all directions, rounded up; lower and upper equal it
//              normal          B moved by depth normal, each component rounded away from 0, is apart from A or touches
//                              it; within 2^-28 of the direction of the least depth. Depths along directions are compared
//                              exactly, not in LSB; equal ones, of points, segments and boxes, in this order: faces of a
//                              by their half axes, faces of b, edges of a by those of b; of other pairs one that is a
//                              function of the posed shapes and their order
//              points          each within 1 LSB of its shape; when B has moved by depth normal they coincide, to
//                              within 3 LSB and 2^-28 of depth. Coordinates saturate at the ends of Q16.16
//            Cylinder, cone, ellipsoid: depth within 3 LSB, between bounds at most 6 LSB apart; or CAPACITY.
// Cost       beside the iterations of gjk_distance, one iteration for each vertex of the EPA hull: at most as many as
//            the workspace holds, with a curved shape GJK_EPA_CURVED_ITERATIONS_MAX. Stack: `make sizes`.
// After      Gino van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001: an
//            expanding polytope; exact visibility signs instead of tolerances. Boxes: their 15 separating axes.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything if intersecting, else intersecting, iterations and certificate; of that what its
//                      proof uses.
// CAPACITY             everything, intersecting. The workspace is too small, or a curved pair would take more than
//                      GJK_EPA_CURVED_ITERATIONS_MAX. depth is upper, and moving by it parts the shapes; the least
//                      depth is at least lower. The certificate proves nothing.
// ITERATION_LIMIT      nothing, nor whether they intersect. Only cylinder, cone, ellipsoid and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out);

// The distance of two shapes; where they overlap it is negative, minus the depth.
//
// a, b, cache, workspace  as of gjk_penetration.
// out                     apart: as of gjk_distance. Overlapping: as of gjk_penetration, with distance = -depth,
//                         lower = -upper, upper = -lower, intersecting set. iterations stops counting at 255.
// Exact, Cost, After      as of gjk_distance and gjk_penetration.
//
// OK                   everything, points and normal too; of the certificate what its proof uses.
// CAPACITY             everything, as of gjk_penetration.
// ITERATION_LIMIT      lower, upper, iterations: the distance, or minus the depth, lies between them. lower above 0
//                      proves that the shapes are apart, upper below 0 that they overlap.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
