// How deep do two shapes overlap, and which way out is the shortest?
#ifndef GJK_PENETRATION_H
#define GJK_PENETRATION_H

#include "gjk/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a workspace holds: vertices, faces and the horizon of the expanding polytope (EPA). Contents are the library's.
typedef struct gjk_epa_vertex {
  gjk_vec3 w;
  uint16_t a, b;
} gjk_epa_vertex;

typedef struct gjk_epa_face {
  uint16_t corner[3], neighbour[3];
  uint32_t height_key;
} gjk_epa_face;

typedef struct gjk_epa_horizon {
  uint16_t corner[4], face[4];
} gjk_epa_horizon;

typedef union gjk_epa_cell {
  gjk_epa_vertex vertex;
  gjk_epa_face face;
  gjk_epa_horizon horizon;
} gjk_epa_cell;

// Cells that always suffice for a polytope of so many vertices, 4 to 16000; a pair with a curved shape needs one more for
// each vertex.
#define GJK_EPA_CELLS(vertices) (3 * (vertices)-4 + (vertices) / 2)

// Most iterations of a polytope's expansion for a pair with a curved shape: smooth shapes in the middle of each other are equally
// deep all round, and would take hundreds of thousands. The cells that this takes; more change nothing.
#define GJK_EPA_CURVED_ITERATIONS_MAX 1000
#define GJK_EPA_CURVED_CELLS (GJK_EPA_CELLS(GJK_EPA_CURVED_ITERATIONS_MAX + 4) + GJK_EPA_CURVED_ITERATIONS_MAX + 4)

// The caller's memory for the polytope. Points, segments, spheres, capsules, boxes and their rounded forms need none
// among each other, and no pair needs any unless its cores overlap. In a million random pairs two 8-point hulls have
// needed at most 20 vertices (66 cells, 1,056 bytes), in 100,000 two 64-point hulls 36 (1,952 bytes); hulls of n and m
// vertices never need more than n m.
typedef struct gjk_workspace {
  gjk_epa_cell *cells;
  uint32_t count;
} gjk_workspace;

// The bytes of a workspace for a polytope of so many vertices.
size_t gjk_workspace_bytes(uint16_t vertices);

// Lengths Q16.16, world frame.
typedef struct gjk_penetration_result {
  gjk_q16 depth;        // the least move of B along any direction that leaves them apart or just touching, rounded up:
                        // 0 if and only if they just touch
  gjk_q16 lower;        // proven bounds of the depth; both equal depth for polytopes and their rounded forms after
  gjk_q16 upper;        // GJK_OK; after CAPACITY depth is upper
  gjk_vec3 point_a;     // A's deepest in B, within 1 LSB of A; and B's deepest in A: they coincide when B has moved, to
  gjk_vec3 point_b;     // within 3 LSB and 2^-28 of depth. Coordinates beyond Q16.16 are cut off there
  gjk_unit3 normal;     // that direction, from A to B, Q2.30, each component rounded away from 0
  bool intersecting;    // false: they are apart, and nothing but iterations and certificate is set
  uint16_t iterations;  // support scans of both shapes
  gjk_certificate certificate;
} gjk_penetration_result;

// The depth of the overlap of two convex shapes, with the direction and points.
//
// a, b       posed colliders, read only; may be the same object.
// cache      in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only: it serves to find out sooner that
//            they are apart, and a depth is measured from a cold start. Kept after OK and CAPACITY.
// workspace  read only, its cells in/out; may be NULL, see gjk_workspace. What is reported depends on their number only
//            where they are too few, never on what they hold.
// Exact      points, segments, triangles, boxes, hulls and their rounded forms: the depth is that of the true minimum
//            over all directions, rounded up. Moving B by depth along normal, each component of the product rounded
//            away from 0, leaves them apart or touching, exactly. Cylinder, cone, ellipsoid: within 3 LSB, between
//            bounds at most 6 apart; or CAPACITY with its bounds.
// Cost       one round for each vertex of the polytope, so at most the workspace's, and of a curved pair at most
//            GJK_EPA_CURVED_ITERATIONS_MAX beside those of gjk_distance; stack: `make sizes`.
// After      Gino van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001: an
//            expanding polytope; exact visibility signs instead of tolerances. Boxes: their 15 directions.
//
// What is valid in out after each status; after an error all else is as it was:
//
// OK                   everything if intersecting, else intersecting, iterations and certificate; of that what its proof uses.
// CAPACITY             everything, intersecting: the workspace is too small, or a curved pair would take more than
//                      GJK_EPA_CURVED_ITERATIONS_MAX. Moving by depth, which is upper, still parts them; the least depth is at least
//                      lower. The certificate proves nothing.
// ITERATION_LIMIT      nothing, nor whether they intersect. Of cylinder, cone, ellipsoid and custom alone.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_penetration(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                           const gjk_workspace *workspace, gjk_penetration_result *out);

// The distance of two shapes, negative when they overlap: minus the depth.
//
// out  as of gjk_distance when they are apart; else as of gjk_penetration: distance = -depth, lower = -upper,
//      upper = -lower, points, normal and certificate set, intersecting. iterations stops counting at 255.
// The rest as gjk_distance and gjk_penetration.
//
// OK                   everything, points and normal too; of the certificate what its proof uses.
// CAPACITY             everything, as of gjk_penetration.
// ITERATION_LIMIT      lower, upper, iterations: the distance, or minus the depth, is between them. lower above 0 proves
//                      that the shapes are apart, upper below 0 that they overlap.
// NULL, UNINITIALISED  nothing.
gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
