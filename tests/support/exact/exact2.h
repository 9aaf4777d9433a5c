// The exact oracle of the plane: decision, distance and depth of two convex shapes, by brute force over all edges and
// vertices, in 128-bit integers of its own.
//
// It shares no code with the library and reads no certificate. Shapes are points in any order, with duplicates and
// points in a line or inside, rounded by a radius.
#ifndef EXACT2_H
#define EXACT2_H

#include <stdbool.h>
#include <stdint.h>

// Most different vertices of a convex hull.
#define EXACT2_VERTICES_MAX 4096

typedef struct exact2_point {
  int64_t x, y;
} exact2_point;

// All points within radius of the convex hull of the points. World frame, LSB.
// Pre: count >= 1; coordinates from -2^32 to 2^32; two points at most 2^29 apart; 0 <= radius < 2^31.
typedef struct exact2_shape {
  const exact2_point *point;
  unsigned count;
  int64_t radius;
} exact2_shape;

// The convex hull of points: its corners counterclockwise, none twice, none within an edge; 1 or 2 where it is flat.
typedef struct exact2_hull {
  unsigned count;
  exact2_point vertex[EXACT2_VERTICES_MAX];
} exact2_hull;

// Pre: the hull has at most EXACT2_VERTICES_MAX corners.
void exact2_hull_find(const exact2_point *point, unsigned count, exact2_hull *out);

__extension__ typedef unsigned __int128 exact2_wide;

typedef struct exact2_truth {
  bool cores_meet;    // without the radii the shapes share a point
  bool intersecting;  // the shapes share a point
  int64_t distance;   // apart: to the nearest LSB, a tie up; else 0
  int64_t depth;      // intersecting: rounded up; else 0
  // Where the cores do not meet: the vector from the point of A's core to that of B's nearest to it, times a positive
  // number. Where they meet: the outward normal of an edge of A - B that is nearest to the origin; it may be 0.
  exact2_point direction;
  exact2_wide numerator, denominator;  // of the squared distance of the cores, exact
} exact2_truth;

void exact2_find(const exact2_shape *a, const exact2_shape *b, exact2_truth *out);

// Are the shapes, whose radii add up to radii, at most distance apart? Pre: 0 <= distance < 2^31.
bool exact2_truth_within(const exact2_truth *truth, int64_t radii, int64_t distance);
bool exact2_within(const exact2_shape *a, const exact2_shape *b, int64_t distance);

#endif
