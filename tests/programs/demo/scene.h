// A scene: the bodies that the cases of a file mention, and the answer to each case.
#ifndef SCENE_H
#define SCENE_H

#include "case/certify.h"

enum { SCENE_BODIES_MAX = 96, SCENE_PAIRS_MAX = 128 };

// A shape that several cases have at the same pose is one body. A case 'x:y' names its bodies x and y.
typedef struct scene_body {
  char name[64];
  case_shape shape;
  case_collider collider;
  bool overlapping;  // in one of the pairs
} scene_body;

typedef enum scene_relation {
  SCENE_APART,
  SCENE_TOUCHING,  // depth 0, or of curved bodies at most the 3 LSB that it may be off
  SCENE_OVERLAPPING
} scene_relation;

typedef struct scene_pair {
  size_t a, b;  // bodies
  gjk_distance_result answer;
  gjk_penetration_result overlap;  // unless they are apart
  gjk_manifold manifold;           // the same
  scene_relation relation;
  certify_verdict verdict;
  gjk_vec3 mark_a, mark_b;  // nearest or deepest points
} scene_pair;

typedef struct scene {
  scene_body body[SCENE_BODIES_MAX];
  size_t bodies;
  scene_pair pair[SCENE_PAIRS_MAX];
  size_t pairs;
} scene;

// Reads the cases into a zeroed scene, answers them and checks the answers. False, with a message on standard error: a
// case is malformed or refused, or the scene is too large.
bool scene_read(scene *s, FILE *file, const char *name);
void scene_free(scene *s);

// A word for tables.
const char *scene_relation_name(scene_relation relation);
const char *scene_verdict_name(certify_verdict verdict);

// The direction from a to b along which they are apart, or along which the least move parts them.
gjk_unit3 scene_direction(const scene_body *a, const scene_body *b);

#endif
