// A case is two shapes at their poses. The query tool reads cases (parse.h); tests make them and print the ones that
// fail.
#ifndef CASE_H
#define CASE_H

#include <stdio.h>

#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"

typedef enum case_kind {
  CASE_POINT,
  CASE_SEGMENT,
  CASE_TRIANGLE,
  CASE_BOX,
  CASE_HULL,
  CASE_CYLINDER,
  CASE_CONE,
  CASE_ELLIPSOID
} case_kind;  // a sphere is a point with a convex radius, a capsule a segment with one

// One shape at its pose, and the way that it goes in a cast or an impact.
//
// size      segment {0, 0, h}; box: half extents; cylinder and cone {r, r, h}; ellipsoid: radii; else unused.
// vertices  of a triangle or hull. case_shape_set_count makes room; case_shape_reset keeps the room for the next case.
// spin      as in gjk_motion.
typedef struct case_shape {
  case_kind kind;
  gjk_vec3 size;
  gjk_vec3 *vertices;  // owned
  size_t count, capacity;
  uint16_t *corners, *ends;  // faces of a hull, as in gjk_hull_faces: owned, with room for faces_capacity faces
  size_t faces, faces_capacity;
  gjk_q16 convex_radius;
  gjk_pose pose;
  gjk_pose end;  // of its way: without 'to' the position is that of pose, without 'turn-to' so is the rotation
  bool moves;    // it has an end
  gjk_vec3 spin;
} case_shape;

typedef struct case_pair {
  char id[64];
  case_shape a, b;
} case_pair;

// A collider with all that it points to. Zeroed before the first use; may be built again; free it with
// case_collider_free.
typedef struct case_collider {
  gjk_shape shape;
  gjk_hull_faces faces;
  gjk_vec3 *buffer;
  size_t capacity;
  gjk_collider collider;
} case_collider;

// Makes shape a point at the origin with identity rotation and convex radius 0, which stands; keeps the room for
// vertices.
void case_shape_reset(case_shape *shape);
void case_shape_free(case_shape *shape);
void case_pair_free(case_pair *pair);
// Makes room for count vertices and sets count.
void case_shape_set_count(case_shape *shape, size_t count);
// Makes room for so many faces of GJK_FACE_CORNERS_MAX corners each, and sets faces.
void case_shape_set_faces(case_shape *shape, size_t faces);
// Gives the shape a way: the position of its pose at the end.
void case_shape_move_to(case_shape *shape, const gjk_vec3 *to);
// Makes *to a deep copy of *from.
void case_shape_copy(case_shape *to, const case_shape *from);

// Makes a collider of shape and poses it. lazy: a hull gets no buffer; else it is baked. shape must outlive the
// collider.
gjk_status case_collider_build(case_collider *collider, const case_shape *shape, bool lazy);
void case_collider_free(case_collider *collider);
// Both shapes of a pair. False: one of them cannot be posed.
bool case_pair_build(const case_pair *pair, bool lazy, case_collider *a, case_collider *b);
// Frees the pair and its colliders.
void case_pair_release(case_pair *pair, case_collider *a, case_collider *b);

// The ways of a pair, for a cast and for an impact. The pair must outlive the path.
gjk_cast_path case_path(const case_pair *pair, gjk_q16 margin);
gjk_motion case_motion(const case_shape *shape);

// Prints the case in the format of parse.h, numbers as raw integers, so that the query tool can read it.
void case_print(FILE *file, const case_pair *pair);

// For check_trial: prints a case_pair to standard output.
void case_show(const void *pair);

// Two shapes of the library's at their poses; the caller keeps their vertices. For tests that need no case_pair.
typedef struct case_posed {
  gjk_shape a, b;
  gjk_pose at_a, at_b;
} case_posed;

// For check_trial: prints a case_posed as a case.
void case_show_posed(const void *posed);

#endif
