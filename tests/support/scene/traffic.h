// Scenes that move by rule, for benchmarks and lockstep tests: the same on every target, without libc.
#ifndef TRAFFIC_H
#define TRAFFIC_H

#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "random.h"

#define TRAFFIC_SHAPES 5

typedef enum traffic_kind {
  TRAFFIC_SPARSE,    // bodies are 4 units apart on average
  TRAFFIC_CROWDED,   // 1.5 units: each body touches or almost touches some others
  TRAFFIC_PILES,     // crates in columns of 8 on static plates
  TRAFFIC_STREAMING  // static scenery in a moving window: bodies are removed behind it and added ahead
} traffic_kind;

typedef struct traffic_body {
  gjk_body_id id;
  gjk_pose pose;
  gjk_vec3 step;  // per tick
  gjk_quat turn;
  uint8_t shape;
  bool moves;
} traffic_body;

typedef struct traffic {
  traffic_kind kind;
  uint32_t count, percent;  // bodies, and how many percent of them move
  gjk_vec3 reach;           // half the size of the room
  uint32_t oldest;          // streaming: the next body that leaves
  int32_t ahead;            // streaming: where the window is
  random_state random;
  traffic_body *bodies;  // the caller's, count of them
} traffic;

extern const gjk_shape *const traffic_shapes[TRAFFIC_SHAPES];

// A configuration with room for count bodies of such traffic.
gjk_scene_config traffic_config(traffic_kind kind, uint32_t count);

// Fills an empty scene with count bodies, of which percent move. Returns the first status that is not GJK_OK.
gjk_status traffic_start(traffic *t, gjk_scene *scene, traffic_kind kind, uint32_t count, uint32_t percent,
                         traffic_body *bodies);

// Adds a body to a slot of a scene, and sets its id.
gjk_status traffic_add(gjk_scene *scene, uint32_t slot, traffic_body *b);
bool traffic_is_static(const traffic_body *b);

// Sets where the bodies are in the next tick; does not change a scene.
void traffic_plan(traffic *t);

// Moves the bodies of the scene to where they are planned. Returns the first status that is not GJK_OK.
gjk_status traffic_apply(traffic *t, gjk_scene *scene);

#endif
