// A case of the plane is two shapes at their poses.
#ifndef CASE2_H
#define CASE2_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef enum case2_kind {
  CASE2_POINT,
  CASE2_SEGMENT,
  CASE2_BOX,
  CASE2_POLYGON,
  CASE2_ELLIPSE
} case2_kind;  // a circle is a point with a convex radius, a capsule a segment with one

typedef struct case2_vec {
  int32_t x, y;
} case2_vec;

// One shape at its pose.
//
// size      segment {h, 0}; box: half extents; ellipse: radii; else unused. Q16.16.
// vertices  of a polygon, in any order. case2_shape_set_count makes room; case2_shape_reset keeps it for the next case.
// turn      cosine and sine, Q2.30
typedef struct case2_shape {
  case2_kind kind;
  case2_vec size;
  case2_vec *vertices;  // owned
  size_t count, capacity;
  int32_t convex_radius;
  case2_vec at, turn;
} case2_shape;

typedef struct case2_pair {
  char id[64];
  case2_shape a, b;
} case2_pair;

// Makes shape a point at the origin, not turned, of convex radius 0; keeps the room for vertices.
void case2_shape_reset(case2_shape *shape);
void case2_pair_free(case2_pair *pair);
// Makes room for count vertices and sets count.
void case2_shape_set_count(case2_shape *shape, size_t count);

// Prints the case in the format of parse.h, numbers as raw integers, so that the query tool can read it.
void case2_print(FILE *file, const case2_pair *pair);

// For check_trial: prints a case2_pair to standard output.
void case2_show(const void *pair);

#endif
