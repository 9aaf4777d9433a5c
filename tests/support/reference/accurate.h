// The accurate oracle: distances with proven bounds, for shapes that integers can't hold.
//
// Polytopes are the integers that posing has made of them (baked hulls); cylinder, cone and ellipsoid stand exactly
// where their pose says, the quaternion normalised in the reals. Lengths in LSB.
#ifndef ACCURATE_H
#define ACCURATE_H

#include "case/case.h"

// Bounds of the distance between the two surfaces. Each follows from points and planes of the shapes, so it holds
// whatever the iteration did, up to the rounding of 113-bit (at least long double) numbers in evaluating it.
typedef struct accurate_result {
  bool enclosing;            // the cores share a point: upper is minus the sum of the roundings
  long double lower, upper;  // negative: the roundings overlap by so much
  long double normal[3];     // from A to B; not set when enclosing
  int iterations;
} accurate_result;

void accurate_distance(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out);

// The same, below 0 when the shapes overlap: minus the bounds of the depth, found by an expanding polytope of at most
// 256 vertices. It stops when the bounds are 1/16 LSB apart or when it is full. The normal is always set; a move of B
// by -lower along it parts the shapes.
void accurate_signed(const case_pair *pair, const case_collider *a, const case_collider *b, accurate_result *out);

// How far the surfaces are apart along a direction from A to B: a lower bound of the distance, and minus an upper
// bound of the depth.
long double accurate_separation(const case_pair *pair, const case_collider *a, const case_collider *b,
                                const gjk_unit3 *direction);

// The distance of a world point from the surface of a point, segment, box, cylinder, cone or ellipsoid at its pose in
// the reals, in closed form (ellipsoid: one equation by bisection); negative inside. An ellipsoid: outside, or inside
// no deeper than its smallest radius of curvature.
long double accurate_point_distance(const case_shape *shape, gjk_vec3 point);

// An upper bound of the distance of a world point from a shape as posed, within accurate_distance's of it; negative
// inside of its rounding.
long double accurate_point_outside(const case_shape *shape, const case_collider *collider, gjk_vec3 point);

// How far it is from the surface, outside or inside: a lower bound.
long double accurate_surface_distance(const case_shape *shape, const case_collider *collider, gjk_vec3 point);

#endif
