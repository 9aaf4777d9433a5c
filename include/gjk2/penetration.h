// How deep do two shapes of the plane overlap, and along which direction is the way out shortest?
#ifndef GJK2_PENETRATION_H
#define GJK2_PENETRATION_H

#include "gjk2/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most support scans that the depth of a pair with a curved shape takes, besides those of gjk2_distance. Smooth
// shapes whose centres coincide are equally deep all round and would take many more.
#define GJK2_DEPTH_ITERATIONS_MAX 1000

// Lengths Q16.16, points in the world frame.
typedef struct gjk2_penetration_result {
  gjk_q16 depth;     // length of the shortest move of B that leaves the shapes apart or just touching, rounded up; 0 if
                     // and only if they just touch
  gjk_q16 lower;     // proven lower bound of the depth, inclusive
  gjk_q16 upper;     // proven upper bound of the depth, inclusive
  gjk2_vec point_a;  // the point of A deepest in B
  gjk2_vec point_b;  // the point of B deepest in A
  gjk2_unit normal;  // direction of that move, from A to B, Q2.30, each component rounded away from 0
  bool intersecting;             // false: the shapes are apart, and only iterations and certificate are also set
  uint16_t iterations;           // support scans of both shapes
  gjk2_certificate certificate;  // why the answer is right
} gjk2_penetration_result;

// The depth by which two convex shapes overlap, with its direction and points. It needs no memory from the caller.
//
// a, b       posed colliders, read only; may be the same object.
// cache      in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only: it speeds up finding shapes
//            apart. Depths start cold. Written after OK and CAPACITY.
// out        the caller's.
// Exact      points, segments, triangles, boxes, polygons and their forms with a convex radius:
//              depth           the true minimum over all directions, rounded up; lower and upper equal it
//              normal          B moved by depth * normal, each component rounded away from 0, is apart from A or
//                              touches it. normal is within 2^-28 of the direction of least depth
//              points          each within 1 LSB of its shape. Once B has moved by depth * normal, they coincide to
//                              within 3 LSB and 2^-28 of depth. Coordinates saturate at the ends of Q16.16
//            Ellipse: depth within 3 LSB, between bounds at most 6 LSB apart; or CAPACITY.
// Cost       cores of n and m vertices: each edge of both is measured once. If the vertices are not in order, n passes
//            over one shape and m over the other find its edges. Cores apart: as in gjk2_distance. A curved shape: the
//            iterations of gjk2_distance, and at most GJK2_DEPTH_ITERATIONS_MAX more. Stack: `make sizes`.
// After      Shamos 1978, rotating calipers, with exact signs instead of tolerances. The edges of A - B are those of A
//            and of -B in the order of their angles.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything if intersecting, else intersecting, iterations and certificate; in that, only what
//                      its proof uses.
// CAPACITY             everything; intersecting is true. GJK2_DEPTH_ITERATIONS_MAX iterations did not settle a curved
//                      pair. depth equals upper, and B moved by it is clear of A. The least depth is at least lower.
//                      The certificate proves nothing.
// ITERATION_LIMIT      nothing, not even intersecting. Only ellipse and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_penetration(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                            gjk2_penetration_result *out);

// The signed distance of two shapes. Where they overlap, it is minus the depth.
//
// a, b, cache         as in gjk2_penetration.
// out                 apart: as in gjk2_distance. Overlapping: as in gjk2_penetration, with distance = -depth,
//                     lower = -upper, upper = -lower and intersecting set.
// Exact, Cost, After  as in gjk2_distance and gjk2_penetration.
//
// OK                   everything, points and normal too; in the certificate, only what its proof uses.
// CAPACITY             everything, as in gjk2_penetration.
// ITERATION_LIMIT      lower, upper, iterations. The signed distance lies between lower and upper. lower above 0 proves
//                      that the shapes are apart, upper below 0 that they overlap.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_signed_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                gjk2_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
