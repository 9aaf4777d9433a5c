// A case: two shapes at their poses, as the query tool reads them and as tests make and print them.
#ifndef CASE_H
#define CASE_H

#include <stdio.h>

#include "gjk/gjk.h"

typedef enum case_kind {
  CASE_POINT,
  CASE_SEGMENT,
  CASE_TRIANGLE,
  CASE_BOX,
  CASE_HULL,
  CASE_CYLINDER,
  CASE_CONE,
  CASE_ELLIPSOID
} case_kind;  // a sphere is a rounded point, a capsule a rounded segment

// One shape at its pose. size: segment {0, 0, h}; box half extents; cylinder and cone {r, r, h}; ellipsoid
// radii.
typedef struct case_shape {
  case_kind kind;
  gjk_vec3 size;
  gjk_vec3 *vertices;  // triangle, hull: owned, grows as needed, kept between cases
  size_t count, capacity;
  uint16_t *corners, *ends;  // faces of a hull, as in gjk_hull_faces: owned, with room for faces_capacity faces
  size_t faces, faces_capacity;
  gjk_q16 convex_radius;
  gjk_pose pose;
} case_shape;

typedef struct case_pair {
  char id[64];
  case_shape a, b;
} case_pair;

// A shape of a case bound to a posed collider; hulls baked. Both may be reused; free with case_collider_free.
typedef struct case_collider {
  gjk_shape shape;
  gjk_hull_faces faces;
  gjk_vec3 *buffer;
  size_t capacity;
  gjk_collider collider;
} case_collider;

// Point at the origin with identity rotation, no rounding; keeps the vertex storage.
void case_shape_reset(case_shape *shape);
void case_shape_free(case_shape *shape);
void case_pair_free(case_pair *pair);
// Room for count vertices; sets count.
void case_shape_set_count(case_shape *shape, size_t count);
// Room for so many faces of GJK_FACE_CORNERS_MAX corners; sets faces.
void case_shape_set_faces(case_shape *shape, size_t faces);
// *to becomes a deep copy of *from.
void case_shape_copy(case_shape *to, const case_shape *from);

// Builds and poses. lazy: hulls keep no buffer. The case must outlive the collider.
gjk_status case_collider_build(case_collider *collider, const case_shape *shape, bool lazy);
void case_collider_free(case_collider *collider);

// Prints the case in the query tool's own format, raw integers.
void case_print(FILE *file, const case_pair *pair);

// For check_trial: prints a case_pair to standard output.
void case_show(const void *pair);

// Two shapes of the library's own kinds at their poses, whose vertices outlive it.
typedef struct case_posed {
  gjk_shape a, b;
  gjk_pose at_a, at_b;
} case_posed;

// For check_trial: prints a case_posed as a case.
void case_show_posed(const void *posed);

// Reading, see parse.h.

#endif
