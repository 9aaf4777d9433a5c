// The reference of the plane: the same queries in double, as a good library answers them. It is right nearly always.
//
// It shares no code with the library: GJK by barycentric coordinates and an expanding polygon, in double.
#ifndef REFERENCE2_H
#define REFERENCE2_H

#include <stdbool.h>
#include <stddef.h>

// All points within convex_radius of a core: the convex hull of points, or where count is 0 the ellipse about centre
// whose half axes are axis[0] and axis[1]. In LSB, world frame.
typedef struct reference2_shape {
  const double (*point)[2];
  size_t count;
  double centre[2], axis[2][2];
  double convex_radius;
} reference2_shape;

// Lengths in LSB, points in the world frame.
typedef struct reference2_result {
  bool intersecting;
  double distance;    // apart: the gap; intersecting: minus the depth
  double a[2], b[2];  // nearest points, or deepest
  double normal[2];   // unit, from A to B
  int iterations;
} reference2_result;

void reference2_query(const reference2_shape *a, const reference2_shape *b, reference2_result *out);

#endif
