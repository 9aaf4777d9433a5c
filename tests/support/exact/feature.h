// Exact geometry of points, segments, triangles and tetrahedra against the origin.
#ifndef EXACT_FEATURE_H
#define EXACT_FEATURE_H

#include <stdbool.h>

#include "integer.h"

// A point with integer coordinates, at most 2^34 in size: a vertex in the world or of a Minkowski difference.
typedef struct exact_point {
  int64_t x[3];
} exact_point;

typedef struct exact_vector {
  exact_int x[3];
} exact_vector;

// The point nearest to the origin of the line or plane through one to three points.
// With points up to 2^33 and edges up to 2^31: denominator 2^127, weights 2^132, point 2^168, squared 2^202.
typedef struct exact_feature {
  exact_int denominator;  // above 0
  exact_int weight[3];    // barycentric coordinates times denominator
  exact_vector point;     // the nearest point times denominator
  exact_int squared;      // its squared distance times denominator
} exact_feature;

exact_point exact_subtract(const exact_point *a, const exact_point *b);
exact_vector exact_cross(const exact_point *a, const exact_point *b);
exact_int exact_dot(const exact_vector *a, const exact_point *b);

// False when the points do not span a line or plane.
bool exact_feature_make(const exact_point *points, unsigned count, exact_feature *out);

// Does the nearest point lie in the simplex (inside: and on no border of it)?
bool exact_feature_contains(const exact_feature *feature, unsigned count, bool inside);

// The feature of one to three points that holds the nearest point of all they span. Always one does.
void exact_feature_nearest(const exact_point *points, unsigned count, exact_feature *out);

// The sign of the difference of two features' distances from the origin.
int exact_feature_order(const exact_feature *a, const exact_feature *b);

// Is the origin in the hull of one to four points?
bool exact_encloses(const exact_point *points, unsigned count);

// The sign of (distance of the feature's point from the origin) - half / 2, for half >= 0.
int exact_feature_compare(const exact_feature *feature, int64_t half);

#endif
