// The accurate oracle: distances with proven bounds, also for curved shapes. Lengths are in LSB.
//
// A polytope is judged as posed, by its integer vertices (hulls: baked). Cylinder, cone and ellipsoid stand exactly
// where their pose says, with the quaternion normalised in the reals.
#ifndef ACCURATE_H
#define ACCURATE_H

#include "case/case.h"

// Bounds of the distance of two shapes. Each bound follows from points and planes of the shapes, so it holds even if
// the search that found them went wrong. It is exact but for rounding in 113 bits, or what long double has.
typedef struct accurate_result {
  bool enclosing;            // the cores share a point: upper is minus the sum of the convex radii
  long double lower, upper;  // negative: the convex radii overlap by so much
  long double normal[3];     // from A to B; not set when enclosing
  int iterations;
} accurate_result;

// Bounds of the distance.
void accurate_distance(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out);

// Bounds of the distance once B has moved by so many LSB, which need not be whole.
void accurate_distance_moved(const case_pair *pair, const case_collider *a, const case_collider *b,
                             const long double moved[3], accurate_result *out);

// Bounds of the distance, or if the shapes overlap, of minus the depth, found by EPA (epa.h) with at most 256 vertices.
// EPA stops when its bounds are 1/16 LSB apart or it has no room. The normal is always set; a move of B by -lower along
// it parts the shapes.
void accurate_signed(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out);

// How far the shapes are apart along a direction from A to B. It is a lower bound of the distance, or minus an upper
// bound of the depth.
long double accurate_separation(const case_pair *pair, const case_collider *a, const case_collider *b,
                                const gjk_unit3 *direction);

// The distance of a world point from the surface of a shape at its pose in the reals; negative inside. It is in closed
// form, of an ellipsoid by bisection of one equation. Pre: shape is a point, segment, box, cylinder, cone or ellipsoid;
// the point is not deeper inside an ellipsoid than its smallest radius of curvature.
long double accurate_point_distance(const case_shape *shape, gjk_vec3 point);

// An upper bound of the distance of a world point from a shape as posed, as tight as accurate_distance. It is negative
// within the convex radius of the core.
long double accurate_point_outside(const case_shape *shape, const case_collider *collider, gjk_vec3 point);

// A lower bound of the distance of a world point from the surface of a shape, outside or inside.
long double accurate_surface_distance(const case_shape *shape, const case_collider *collider, gjk_vec3 point);

#endif
