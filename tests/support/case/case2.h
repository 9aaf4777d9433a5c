// A case of the plane is two shapes at their poses.
#ifndef CASE2_H
#define CASE2_H

#include <stdio.h>

#include "gjk2/cast.h"
#include "gjk2/gjk2.h"
#include "gjk2/impact.h"

typedef enum case2_kind {
  CASE2_POINT,
  CASE2_SEGMENT,
  CASE2_TRIANGLE,
  CASE2_BOX,
  CASE2_POLYGON,
  CASE2_ELLIPSE
} case2_kind;  // a circle is a point with a convex radius, a capsule a segment with one

// One shape at its pose, and the way that it goes in a cast or an impact.
//
// size      segment {h, 0}; box: half extents; ellipse: radii; else unused. Q16.16.
// vertices  of a triangle or polygon, in any order. case2_shape_set_count makes room; case2_shape_reset keeps it for the next case.
// spin      as in gjk2_motion.
typedef struct case2_shape {
  case2_kind kind;
  gjk2_vec size;
  gjk2_vec *vertices;  // owned
  size_t count, capacity;
  gjk_q16 convex_radius;
  gjk2_pose pose;
  gjk2_pose end;  // of its way: without 'to' the position is that of pose, without 'turn-to' so is the rotation
  bool moves;     // it has an end
  gjk_angle spin;
} case2_shape;

typedef struct case2_pair {
  char id[64];
  case2_shape a, b;
} case2_pair;

// A collider with all that it points to. Zeroed before the first use; may be built again; free it with
// case2_collider_free.
typedef struct case2_collider {
  gjk2_shape shape;
  gjk2_vec *buffer;
  size_t capacity;
  gjk2_collider collider;
} case2_collider;

// Makes a collider of shape and poses it. lazy: a polygon gets no buffer; else it is baked. shape must outlive the
// collider.
gjk_status case2_collider_build(case2_collider *collider, const case2_shape *shape, bool lazy);
void case2_collider_free(case2_collider *collider);

// The ways of a pair, for a cast and for an impact. The pair must outlive the path.
gjk2_cast_path case2_path(const case2_pair *pair, gjk_q16 margin);
gjk2_motion case2_motion(const case2_shape *shape);

// Makes shape a point at the origin, not turned, of convex radius 0; keeps the room for vertices.
void case2_shape_reset(case2_shape *shape);
void case2_pair_free(case2_pair *pair);
// Makes room for count vertices and sets count.
void case2_shape_set_count(case2_shape *shape, size_t count);

// Gives the shape a way: the position of its pose at the end.
void case2_shape_move_to(case2_shape *shape, const gjk2_vec *to);

// Prints the case in the format of parse.h, numbers as raw integers, so that the query tool can read it.
void case2_print(FILE *file, const case2_pair *pair);

// For check_trial: prints a case2_pair to standard output.
void case2_show(const void *pair);

#endif
