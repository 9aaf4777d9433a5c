// How deep do two shapes of the plane overlap, and along which direction is the way out shortest?
#ifndef GJK2_PENETRATION_H
#define GJK2_PENETRATION_H

#include "gjk2/distance.h"

#ifdef __cplusplus
extern "C" {
#endif

// The most support scans that the depth of a pair with a curved shape takes, beside those of gjk2_distance. Smooth
// shapes in the middle of each other are equally deep all round, and would take many more.
#define GJK2_DEPTH_ITERATIONS_MAX 1000

// Lengths Q16.16, points in the world frame.
typedef struct gjk2_penetration_result {
  gjk_q16 depth;  // the shortest move of B, over all directions, that leaves the shapes apart or just touching, rounded
                  // up; 0 if and only if they just touch
  gjk_q16 lower;  // proven bounds of the depth, both included
  gjk_q16 upper;  // the other bound
  gjk2_vec point_a;              // the point of A that is deepest in B
  gjk2_vec point_b;              // the point of B that is deepest in A
  gjk2_unit normal;              // the direction of that move, from A to B, Q2.30, each component rounded away from 0
  bool intersecting;             // false: the shapes are apart, and of the rest only iterations and certificate are set
  uint16_t iterations;           // support scans of both shapes
  gjk2_certificate certificate;  // why the answer is right
} gjk2_penetration_result;

// The depth of the overlap of two convex shapes, with its direction and points. It needs no memory of the caller's.
//
// a, b       posed colliders, read only; may be the same object.
// cache      in/out, the caller's; zeroed = cold start; NULL = none. Changes speed only: it helps to find out that the
//            shapes are apart, and a depth is measured from a cold start. Written after OK and CAPACITY.
// out        the caller's.
// Exact      points, segments, triangles, boxes, polygons and their forms with a convex radius:
//              depth           the true minimum over all directions, rounded up; lower and upper equal it
//              normal          B moved by depth normal, each component rounded away from 0, is apart from A or touches
//                              it; within 2^-28 of the direction of the least depth
//              points          each within 1 LSB of its shape; when B has moved by depth normal they coincide, to
//                              within 3 LSB and 2^-28 of depth. Coordinates saturate at the ends of Q16.16
//            Ellipse: depth within 3 LSB, between bounds at most 6 LSB apart; or CAPACITY.
// Cost       cores of n and m vertices: each edge of both is measured once; of vertices that are not in order, n passes
//            over the one and m over the other find their edges. Cores apart: as of gjk2_distance. A curved shape:
//            beside the iterations of gjk2_distance at most GJK2_DEPTH_ITERATIONS_MAX. Stack: `make sizes`.
// After      the edges of A - B are those of A and of -B in the order of their angles (the rotating calipers of Shamos
//            1978); exact signs instead of tolerances.
//
// What is valid in out after each status; all else is as it was:
//
// OK                   everything if intersecting, else intersecting, iterations and certificate; of that what its
//                      proof uses.
// CAPACITY             everything, intersecting. Of curved pairs alone: GJK2_DEPTH_ITERATIONS_MAX have not settled it.
//                      depth is upper, and moving by it parts the shapes; the least depth is at least lower. The
//                      certificate proves nothing.
// ITERATION_LIMIT      nothing, nor whether they intersect. Only ellipse and custom can cause it.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_penetration(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                            gjk2_penetration_result *out);

// The distance of two shapes; where they overlap it is negative, minus the depth.
//
// a, b, cache         as of gjk2_penetration.
// out                 apart: as of gjk2_distance. Overlapping: as of gjk2_penetration, with distance = -depth,
//                     lower = -upper, upper = -lower, intersecting set.
// Exact, Cost, After  as of gjk2_distance and gjk2_penetration.
//
// OK                   everything, points and normal too; of the certificate what its proof uses.
// CAPACITY             everything, as of gjk2_penetration.
// ITERATION_LIMIT      lower, upper, iterations: the distance, or minus the depth, lies between them. lower above 0
//                      proves that the shapes are apart, upper below 0 that they overlap.
// NULL, UNINITIALISED  nothing.
gjk_status gjk2_signed_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache,
                                gjk2_distance_result *out);

#ifdef __cplusplus
}
#endif

#endif
