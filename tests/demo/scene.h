// A scene: the bodies that the cases of a file mention, and the answer to each case.
#ifndef SCENE_H
#define SCENE_H

#include "../case/certify.h"

enum { SCENE_BODIES_MAX = 96, SCENE_PAIRS_MAX = 128 };

// The same shape at the same pose in several cases is one body. A case 'x:y' names its bodies x and y.
typedef struct scene_body {
  char name[64];
  case_shape shape;
  case_collider collider;
  bool overlapping;  // in one of the pairs
} scene_body;

typedef enum scene_relation {
  SCENE_APART,
  SCENE_TOUCHING,  // they share a point, and a move by 1 LSB along an axis parts them
  SCENE_OVERLAPPING
} scene_relation;

typedef struct scene_pair {
  size_t a, b;  // bodies
  gjk_distance_result answer;
  scene_relation relation;
  certify_verdict verdict;
  gjk_vec3 mark_a,
      mark_b;  // nearest points; of touching and overlapping bodies, those once they are moved apart
} scene_pair;

typedef struct scene {
  scene_body body[SCENE_BODIES_MAX];
  size_t bodies;
  scene_pair pair[SCENE_PAIRS_MAX];
  size_t pairs;
} scene;

// Reads the cases into a zeroed scene, answers them and checks the answers. False, with a message on standard
// error, after a malformed or refused case or when the scene is too large.
bool scene_read(scene *s, FILE *file, const char *name);
void scene_free(scene *s);

// A word for tables.
const char *scene_relation_name(scene_relation relation);
const char *scene_verdict_name(certify_verdict verdict);

// Moves b along the axes in growing steps, from 1 LSB on, until the bodies are apart. Returns the step, 0 when
// they are apart as they stand; out is the answer there, as if b had moved.
gjk_q16 scene_part(const scene_body *a, const scene_body *b, gjk_distance_result *out);

#endif
