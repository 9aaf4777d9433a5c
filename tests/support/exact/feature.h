// Exact geometry of points, segments, triangles and tetrahedra against the origin.
#ifndef EXACT_FEATURE_H
#define EXACT_FEATURE_H

#include <stdbool.h>

#include "integer.h"

// A point with integer coordinates, |coordinate| <= 2^34: a vertex in the world or of a Minkowski difference.
typedef struct exact_point {
  int64_t x[3];
} exact_point;

typedef struct exact_vector {
  exact_int x[3];
} exact_vector;

// Of the point, line or plane through one to three points: its point nearest to the origin, as fractions.
// Bounds for points up to 2^33 and edges up to 2^31:
typedef struct exact_feature {
  exact_int denominator;  // 0 < denominator <= 2^127
  exact_int weight[3];    // <= 2^132: barycentric coordinates times denominator
  exact_vector point;     // <= 2^168: the nearest point times denominator
  exact_int squared;      // <= 2^202: its squared distance from the origin times denominator
} exact_feature;

exact_point exact_subtract(const exact_point *a, const exact_point *b);
exact_vector exact_cross(const exact_point *a, const exact_point *b);
exact_int exact_dot(const exact_vector *a, const exact_point *b);

// False: two points coincide, or three lie on one line.
bool exact_feature_make(const exact_point *points, unsigned count, exact_feature *out);

// Does the nearest point lie in the simplex of the points? inside: in its interior?
bool exact_feature_contains(const exact_feature *feature, unsigned count, bool inside);

// The feature of the convex hull of one to three points that is nearest to the origin.
void exact_feature_nearest(const exact_point *points, unsigned count, exact_feature *out);

// The sign of (distance of a from the origin) - (distance of b).
int exact_feature_order(const exact_feature *a, const exact_feature *b);

// Is the origin in the hull of one to four points?
bool exact_encloses(const exact_point *points, unsigned count);

// The sign of (distance of the feature's point from the origin) - half / 2, for half >= 0.
int exact_feature_compare(const exact_feature *feature, int64_t half);

#endif
