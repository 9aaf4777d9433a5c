// Scenes whose poses the project's own solvers recorded, and the methods that replay them: a tick moves the bodies that moved
// and finds all contacts.
#ifndef BENCH_SCENE_REST_H
#define BENCH_SCENE_REST_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define REST_BODIES 2400
#define REST_SHAPES 8
#define REST_TICKS 10

// Bodies are near where they are this far apart, Q16.16: the sum of two margins.
#define REST_MARGIN 1310

typedef struct rest_body {
  uint8_t shape;
  bool fixed;
} rest_body;

// A scene and its recording.
typedef struct rest_stage {
  const char *name;
  bool plane;
  unsigned before;      // how many ticks the solver has gone on when the recording begins
  unsigned iterations;  // of the solver of space
  unsigned bodies;
  rest_body body[REST_BODIES];
  const void *shape[REST_SHAPES];  // gjk_shape or gjk2_shape
  float half[REST_SHAPES][3];      // of boxes of space, units
  const void *mesh;                // a gjk_mesh, which shape 0 is; NULL: there is none
  void *poses;                     // gjk_pose or gjk2_pose of each body, REST_TICKS + 1 times
} rest_stage;

// What a method finds in one tick.
typedef struct rest_found {
  uint32_t moved, pairs, near, manifolds;
  uint32_t queried;  // by the library, to decide whether they are near
} rest_found;

typedef struct rest_method {
  const char *name;
  bool plane;
  void *(*start)(const rest_stage *stage);                     // at the first poses; NULL: it failed
  bool (*go)(void *world, unsigned frame, rest_found *found);  // to the poses of another frame; what is timed
  void (*stop)(void *world);
} rest_method;

// Builds a scene, without its recording. False: there is none of this number.
bool rest_build(unsigned number, rest_stage *out);
bool rest_build_plane(unsigned number, rest_stage *out);
void rest_free(rest_stage *stage);

// Records a scene that is built.
bool rest_record(rest_stage *stage);
bool rest_record_plane(rest_stage *stage);

// The library: with the manifolds of all near pairs; of those that are not still; of none.
extern const rest_method rest_gjk_manifolds, rest_gjk_kept, rest_gjk_near;
extern const rest_method rest_gjk2_manifolds, rest_gjk2_kept, rest_gjk2_near;
extern const rest_method rest_bullet, rest_ode;

#ifdef __cplusplus
}
#endif

#endif
